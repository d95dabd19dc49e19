#include "beadmesh/panel/panel.h"

#include <algorithm>
#include <utility>

namespace beadmesh {
namespace {

template <class T>
void append(const std::vector<T>& from, std::vector<T>& to) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

Facets facets_of(const Panel& panel, const std::vector<Index>& faces) {
  if (faces.size() == 1) return panel.faces[faces.front()].facets;
  std::vector<Triangle> triangles;
  Facets sum;
  bool has_uv = true;
  for (const Index f : faces) {
    const Facets& facets = panel.faces[f].facets;
    for (const Triangle& t : facets.triangles)
      triangles.push_back({facets.panel_points[t[0]], facets.panel_points[t[1]], facets.panel_points[t[2]]});
    has_uv = has_uv && facets.triangle_uv.size() == facets.triangles.size();
    append(facets.triangle_uv, sum.triangle_uv);
    append(facets.triangle_face, sum.triangle_face);
    if (sum.surfaces.size() < facets.surfaces.size()) sum.surfaces.resize(facets.surfaces.size());
    for (std::size_t i = 0; i < facets.surfaces.size(); ++i)
      if (facets.surfaces[i]) sum.surfaces[i] = facets.surfaces[i];
  }
  Facets joined = facets_of_triangles(panel.points, triangles);
  if (has_uv) joined.triangle_uv = std::move(sum.triangle_uv);
  joined.triangle_face = std::move(sum.triangle_face);
  joined.surfaces = std::move(sum.surfaces);
  return joined;
}

double diagonal(const Panel& panel) {
  if (panel.points.empty()) return 0;
  Vec3 low = panel.points.front(), high = low;
  for (const Vec3 p : panel.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return distance(low, high);
}

}  // namespace beadmesh
