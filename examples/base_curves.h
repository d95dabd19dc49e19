// The sheet's surface and the curves on it over edges of the plan.
#pragma once

#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>

#include "examples/panel_design.h"

namespace beadmesh::examples {

/// The base as a surface: plane, cylinder or one bicubic span, for a sheet of length x width mm.
Handle(Geom_Surface) base_surface(const Base& base, double length, double width);

/// Parameters of all curves of an edge: the length of a line, the angle of an arc (counter-clockwise ones
/// only).
struct CurveRange {
  double first, last;
};
CurveRange curve_range(const PlanEdge& edge);

/// The edge lifted onto the base: exact on a flat one, else an interpolating spline.
Handle(Geom_Curve) curve_in_space(const Base& base, const PlanEdge& edge);
/// The same curve in the parameters of base_surface().
Handle(Geom2d_Curve) curve_on_base(const Base& base, const PlanEdge& edge);
/// The edge itself in a frame of the plan with the given origin and turn (radians), exact.
Handle(Geom2d_Curve) curve_in_frame(const PlanEdge& edge, Vec2 origin, double angle);

}  // namespace beadmesh::examples
