// Bicubic B-spline surfaces through a grid of points.
#pragma once

#include <Geom_BSplineSurface.hxx>
#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh::examples {

/// The cubic tensor product spline (not-a-knot) with S(us[i], vs[j]) = points[i * vs.size() + j]; at least
/// four increasing parameters each way. Where x = u and y = v in the points they are so on the whole surface.
Handle(Geom_BSplineSurface) spline_through(const std::vector<double>& us, const std::vector<double>& vs,
                                           const std::vector<Vec3>& points);

/// count + 1 evenly spaced values from `from` to `to`.
std::vector<double> even_steps(double from, double to, int count);

}  // namespace beadmesh::examples
