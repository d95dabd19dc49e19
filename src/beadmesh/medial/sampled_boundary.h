// The boundary as samples and their triangulation, as dense as the medial axis needs them (section 3.1).
#pragma once

#include <vector>

#include "beadmesh/core/result.h"
#include "beadmesh/delaunay/boundary_samples.h"
#include "beadmesh/delaunay/triangulation.h"
#include "beadmesh/medial/boundary_curve.h"

namespace beadmesh {

struct SamplingOptions {
  double spacing = 0;    ///< default 0: from the local thickness; else the greatest distance of samples
  double grading = 2.0;  ///< default 2: greatest ratio of the lengths of neighbouring segments
  int min_segments =
      4;  ///< default 4: least number of segments between two corners, where no facet forbids it
  Index max_samples = 4'000'000;  ///< default 4e6: more that the sampling would add are an error
};

struct SampledBoundary {
  BoundarySamples samples;
  Triangulation triangulation;  ///< its points are the samples
};

/// All points of the region's loops, and points between them on the curve where they are needed: no segment
/// is longer than half the circumradius of its triangle, so that it is short beside the local thickness, and
/// no triangle is obtuse over its segment, so that circumcentres stay inside; neighbouring segments differ by
/// `grading` at most; every convex corner has a triangle of its own, on equally long legs where no given
/// point forbids it. A facet of a curve that is not known exactly is split only where it is much too long.
/// A straight side that faces another one is cut into pieces of no less than a 128th of it. Fails with
/// delaunay.* or medial.too_many_samples.
Result<SampledBoundary> sampled_boundary(const BoundaryCurve& curve, const SamplingOptions& options);

/// Adds samples at these places, where there is none near. False where nothing was added.
bool add_samples(SampledBoundary& sampled, const std::vector<BoundaryPlace>& places,
                 const BoundaryCurve& curve);

}  // namespace beadmesh
