#include "beadmesh/flatten/flat_region.h"

namespace beadmesh {

PlanarRegion flat_region(const Facets& facets, const FlatFace& flat,
                         const std::vector<std::vector<bool>>& corners) {
  PlanarRegion region;
  region.loops.resize(facets.loops.size());
  for (std::size_t l = 0; l < facets.loops.size(); ++l) {
    PlanarLoop& loop = region.loops[l];
    loop.points.reserve(facets.loops[l].size());
    for (const Index v : facets.loops[l]) loop.points.push_back(flat.positions[v]);
    if (l < corners.size()) loop.corner = corners[l];
  }
  return region;
}

}  // namespace beadmesh
