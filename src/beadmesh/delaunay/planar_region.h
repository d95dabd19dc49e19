// A region of the plane with holes, bounded by polylines whose points know what they stand for.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "beadmesh/core/result.h"
#include "beadmesh/core/vector.h"
#include "beadmesh/delaunay/planar_curve.h"

namespace beadmesh {

/// A closed loop; points[i] to points[(i + 1) % n] is a segment. The region lies on the left.
struct PlanarLoop {
  std::vector<Vec2> points;
  std::vector<bool> corner;  ///< per point: true = tangent discontinuity; empty: decided from the angle
  /// Per segment: the curve that it lies on, an index into PlanarRegion::curves; no_index: it is straight.
  /// Empty: there are no exact curves; the points without corner stand for smooth curves.
  std::vector<Index> curve;
  /// Per segment: parameters of its curve at its start and end; empty where `curve` is.
  std::vector<std::array<double, 2>> parameters{};
};

/// loops[0] is the outer one (counter-clockwise), the rest are holes (clockwise). A loop with exact curves
/// has points on them that are so dense that the polygon of the points has the topology of the region.
struct PlanarRegion {
  std::vector<PlanarLoop> loops;
  std::vector<std::shared_ptr<const PlanarCurve>> curves{};
};

/// Orders and orients loops: outer first and counter-clockwise, holes clockwise in their given order. Fails
/// with the loop and point named, both counted from 1 as the caller has ordered them; codes are
/// delaunay.region.* : empty, few_points, attributes (corner, curve or parameters of another length than
/// points, or a curve that does not exist or does not pass through the points), not_finite, repeated_point,
/// zero_area, crossing, touching (a loop touches itself or another), outside (a second outer loop, or a hole
/// outside), nested (a loop in a hole). Exact; O(n log n) in practice.
Result<PlanarRegion> checked_region(PlanarRegion region);

/// How a caller calls a point of a loop, both from 0, for example "vertex 7".
using PointName = std::function<std::string(std::size_t loop, std::size_t point)>;
/// The same, with the caller's names in the errors; without a name, "point 3 of loop 1".
Result<PlanarRegion> checked_region(PlanarRegion region, const PointName& name);

/// Whether the polygons of the loops hold a point, by the crossings of a ray; either where it is on a
/// segment.
bool contains(const PlanarRegion& region, Vec2 point);
/// Positive where the loop runs counter-clockwise.
double signed_area(const PlanarLoop& loop);
/// Length of the diagonal of the bounding box.
double diagonal(const PlanarRegion& region);

}  // namespace beadmesh
