// The surface of a raised feature: one bicubic B-spline over its bounding box that runs on as the base
// outside.
#pragma once

#include <Geom_BSplineSurface.hxx>

#include "examples/panel_design.h"

namespace beadmesh::examples {

/// Surface over the feature's own frame, parameters in mm along its axes: S(u, v) lies above the plan point
/// with the local coordinates (u, v). The grid is refined until along the boundary the surface is within
/// 0.003 mm and 0.4 degrees of the base.
Handle(Geom_BSplineSurface) bead_surface(const Base& base, const Feature& feature);

}  // namespace beadmesh::examples
