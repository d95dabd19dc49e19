#include "beadmesh/read/polygon_cutting.h"

namespace beadmesh {

void cut_polygon(const std::vector<Vec3>& points, const std::vector<Index>& polygon, LooseFacets& facets) {
  const auto at = [&](std::size_t i) { return points[polygon[i % polygon.size()]]; };
  const bool turn = polygon.size() == 4 && distance(at(1), at(3)) < distance(at(0), at(2));
  const std::size_t first = turn ? 1 : 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    facets.corners.push_back({at(first), at(first + i), at(first + i + 1)});
}

}  // namespace beadmesh
