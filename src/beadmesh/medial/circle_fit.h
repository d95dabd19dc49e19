// Least-squares circles through points.
#pragma once

#include <optional>
#include <vector>

#include "beadmesh/medial/triangle_type.h"

namespace beadmesh {

/// Points no further than `band` from the circle's line.
std::vector<Vec2> points_near(const std::vector<Vec2>& points, const Circle& circle, double band);

/// Angle about `centre` that the points span, in order; steps between neighbours summed with their sign.
double arc_of(const std::vector<Vec2>& points, Vec2 centre);

/// Minimises the sum of squared distances to the circle's line (Gauss-Newton from `start`); needs three
/// points.
std::optional<Circle> fitted_circle(const std::vector<Vec2>& points, const Circle& start);

}  // namespace beadmesh
