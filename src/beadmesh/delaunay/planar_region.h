// A region of the plane with holes, bounded by polylines whose points know what they stand for.
#pragma once

#include <vector>

#include "beadmesh/core/result.h"
#include "beadmesh/core/vector.h"

namespace beadmesh {

/// A closed loop; points[i] to points[(i + 1) % n] is a segment. The region lies on the left.
struct PlanarLoop {
  std::vector<Vec2> points;
  std::vector<bool> corner;  ///< per point: true = tangent discontinuity; empty: decided from the angle
  std::vector<Index> curve;  ///< per segment: id of the curve it lies on; empty: one curve a loop
};

/// loops[0] is the outer one (counter-clockwise), the rest are holes (clockwise).
struct PlanarRegion {
  std::vector<PlanarLoop> loops;
};

/// Orders and orients loops: outer first and counter-clockwise, holes clockwise in their given order. Fails
/// with the loop and point named, both counted from 1 as the caller has ordered them; codes are
/// delaunay.region.* : empty, few_points, attributes (corner or curve of another length than points),
/// not_finite, repeated_point, zero_area, crossing, touching (a loop touches itself or another), outside (a
/// second outer loop, or a hole outside), nested (a loop in a hole). Exact; O(n log n) in practice.
Result<PlanarRegion> checked_region(PlanarRegion region);

/// Positive where the loop runs counter-clockwise.
double signed_area(const PlanarLoop& loop);
/// Length of the diagonal of the bounding box.
double diagonal(const PlanarRegion& region);

}  // namespace beadmesh
