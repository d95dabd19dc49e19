// Inside the read room: a smooth curve through the points of a facetted edge.
#pragma once

#include <memory>
#include <vector>

#include "beadmesh/panel/panel.h"

namespace beadmesh {

/// Cubics from point to point (first == last closes the curve), tangents of circles through three points; the
/// parameter of a point is the length of the polyline up to it. Beside a segment that is three times as long
/// as the next the tangent is that segment's: a line that runs into an arc stays straight. A joint that a
/// smooth curve would round by more than 0.5 mm keeps its corner.
struct FacetCurve {
  std::shared_ptr<const CurveEvaluator> curve;
  std::vector<double> parameters;
};
FacetCurve curve_through(const std::vector<Vec3>& points);

}  // namespace beadmesh
