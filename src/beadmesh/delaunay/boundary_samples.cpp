#include "beadmesh/delaunay/boundary_samples.h"

namespace beadmesh {

BoundarySamples samples_of(const PlanarRegion& region) {
  BoundarySamples samples;
  std::size_t count = 0;
  for (const PlanarLoop& loop : region.loops) count += loop.points.size();
  samples.samples.reserve(count);
  for (std::size_t l = 0; l < region.loops.size(); ++l) {
    const PlanarLoop& loop = region.loops[l];
    samples.first.push_back(static_cast<Index>(samples.samples.size()));
    for (std::size_t i = 0; i < loop.points.size(); ++i)
      samples.samples.push_back(
          {loop.points[i], 0, static_cast<Index>(l), static_cast<Index>(i), bool(loop.corner[i])});
  }
  samples.first.push_back(static_cast<Index>(samples.samples.size()));
  return samples;
}

}  // namespace beadmesh
