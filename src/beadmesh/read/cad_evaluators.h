// Inside the read room: exact curves and surfaces behind the panel's evaluators.
#pragma once

#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <memory>

#include "beadmesh/panel/panel.h"

namespace beadmesh {

std::shared_ptr<const CurveEvaluator> curve_of(const Handle(Geom_Curve) & curve);

/// Normals are the surface's own, turned where `turned`.
std::shared_ptr<const SurfaceEvaluator> surface_of(const Handle(Geom_Surface) & surface, bool turned);

}  // namespace beadmesh
