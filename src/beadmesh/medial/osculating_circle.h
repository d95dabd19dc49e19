// The centre of curvature where an exact boundary bends the most.
#pragma once

#include <optional>

#include "beadmesh/medial/boundary_curve.h"
#include "beadmesh/medial/triangle_type.h"

namespace beadmesh {

/// A stretch of the boundary by arc lengths along the loop's polyline; `to` may pass its end.
struct Stretch {
  Index loop = 0;
  double from = 0, to = 0;
};

/// Where a smooth end of the axis is: the osculating circle at the vertex of the curve (the place of greatest
/// curvature) of a stretch. Nothing where the curve is not known exactly there, has its greatest curvature at
/// an end, or the circle is far from `start`. `vertex` is set to the place.
std::optional<Circle> osculating_circle(const BoundaryCurve& curve, const Stretch& stretch,
                                        const Circle& start, BoundaryPlace& vertex);

}  // namespace beadmesh
