// Points on the boundary from which the triangulation is made (section 3.1 of the paper).
#pragma once

#include <vector>

#include "beadmesh/delaunay/planar_region.h"

namespace beadmesh {

struct SamplingOptions {
  double spacing =
      0;  ///< default 0: half the local radius of the region; else the greatest distance of samples
  double grading = 2.0;  ///< default 2: greatest ratio of the lengths of neighbouring segments
  int min_segments =
      4;  ///< default 4: least number of segments between two corners, where no facet forbids it
  bool facetted =
      false;  ///< default false; true: the region's points stand for smooth curves; a segment that is a facet
              ///< of a curve is split only where it is longer than twice what is asked for
  Index max_samples = 4'000'000;  ///< default 4e6: refinement stops before it would pass this number
};

struct BoundarySample {
  Vec2 point;
  Index loop = 0;
  double position = 0;  ///< arc length along the region's loop polyline from its first point
  bool corner = false;  ///< tangent discontinuity
  Index curve = 0;      ///< of the segment that starts here
};

/// Samples of all loops; loop l owns samples[first[l]] .. samples[first[l + 1] - 1], in loop order.
struct BoundarySamples {
  std::vector<BoundarySample> samples;
  std::vector<Index> first;
  std::vector<double> loop_length;  ///< arc length of each loop
};

/// Where a loop does not say which of its points are corners: those where the boundary turns by more than
/// this. It lies between the turns of regular polygons of 16 and 17 sides, so that none of them is decided by
/// rounding.
inline constexpr double corner_turn = radians(22.0);

/// All points of the region's loops (a checked_region) and points between them on their segments, denser
/// where the region is thin: spacing about half the radius of the circumcircle of the triangle on the
/// segment, and no point inside the circle over a segment, so that circumcentres stay inside; a smooth change
/// of density; equally long segments at a corner, where no given point forbids it. The sizes are found by
/// triangulating the samples a few times.
BoundarySamples sample_boundary(const PlanarRegion& region, const SamplingOptions& options = {});

/// The sample after / before i along its loop.
Index next_sample(const BoundarySamples& samples, Index i);
Index previous_sample(const BoundarySamples& samples, Index i);

}  // namespace beadmesh
