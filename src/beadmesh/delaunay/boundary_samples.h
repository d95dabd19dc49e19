// Points on the boundary from which the triangulation is made (section 3.1 of the paper).
#pragma once

#include <vector>

#include "beadmesh/delaunay/planar_region.h"

namespace beadmesh {

/// A point between the given points `segment` and `segment` + 1 of a loop.
struct BoundarySample {
  Vec2 point;
  double t = 0;  ///< along the segment, in [0, 1)
  Index loop = 0;
  Index segment = 0;
  bool corner = false;  ///< tangent discontinuity
};

/// Samples of all loops in loop order; loop l owns samples[first[l]] .. samples[first[l + 1] - 1].
struct BoundarySamples {
  std::vector<BoundarySample> samples;
  std::vector<Index> first;
};

/// The sample after / before i along its loop.
inline Index next_sample(const BoundarySamples& samples, Index i) {
  const Index loop = samples.samples[i].loop;
  return i + 1 < samples.first[loop + 1] ? i + 1 : samples.first[loop];
}
inline Index previous_sample(const BoundarySamples& samples, Index i) {
  const Index loop = samples.samples[i].loop;
  return i > samples.first[loop] ? i - 1 : samples.first[loop + 1] - 1;
}

/// The points of the region's loops (tagged at every point) as samples.
BoundarySamples samples_of(const PlanarRegion& region);

}  // namespace beadmesh
