#include "examples/base_curves.h"

#include <Geom2dAPI_Interpolate.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_Circle.hxx>
#include <Geom2d_Line.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_Circle.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TColgp_HArray1OfPnt2d.hxx>
#include <algorithm>
#include <cmath>

#include "examples/spline_surface.h"

namespace beadmesh::examples {
namespace {

constexpr double closure = 1e-7;  // mm, points nearer than this are one to the interpolation

/// Interpolation parameters along an edge, dense enough for curves on a gently curved base.
std::vector<double> curve_parameters(const PlanEdge& edge) {
  const CurveRange range = curve_range(edge);
  return even_steps(range.first, range.last, std::max(12, int(edge.length() / 2)));
}

Vec2 point_at(const PlanEdge& edge, double parameter) {
  const CurveRange range = curve_range(edge);
  return edge.point((parameter - range.first) / (range.last - range.first));
}

}  // namespace

Handle(Geom_Surface) base_surface(const Base& base, double length, double width) {
  if (base.is_flat()) return new Geom_Plane(gp_Ax3(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1), gp_Dir(1, 0, 0)));
  if (base.radius > 0) {
    const gp_Ax3 axes(gp_Pnt(0, 0, -base.radius), gp_Dir(0, 1, 0), gp_Dir(0, 0, 1));
    return new Geom_CylindricalSurface(axes, base.radius);
  }
  // One span of a bicubic spline holds the cubic polynomial exactly.
  const double x = length / 2 + 10, y = width / 2 + 10;
  const std::vector<double> us = even_steps(-x, x, 3), vs = even_steps(-y, y, 3);
  std::vector<Vec3> points;
  for (const double u : us)
    for (const double v : vs) points.push_back(base.point({u, v}));
  return spline_through(us, vs, points);
}

CurveRange curve_range(const PlanEdge& edge) {
  if (!edge.is_arc()) return {0, edge.length()};
  return {edge.start_angle, edge.start_angle + edge.sweep};
}

Handle(Geom_Curve) curve_in_space(const Base& base, const PlanEdge& edge) {
  if (base.is_flat() && edge.is_arc()) {
    const gp_Ax2 axes(gp_Pnt(edge.centre.x, edge.centre.y, 0), gp_Dir(0, 0, 1), gp_Dir(1, 0, 0));
    return new Geom_Circle(axes, edge.radius);
  }
  if (base.is_flat()) {
    const Vec2 d = normalized(edge.end - edge.start);
    return new Geom_Line(gp_Pnt(edge.start.x, edge.start.y, 0), gp_Dir(d.x, d.y, 0));
  }
  const std::vector<double> ts = curve_parameters(edge);
  Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, int(ts.size()));
  Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, int(ts.size()));
  for (int i = 0; i < int(ts.size()); ++i) {
    const Vec3 p = base.point(point_at(edge, ts[i]));
    points->SetValue(i + 1, gp_Pnt(p.x, p.y, p.z));
    parameters->SetValue(i + 1, ts[i]);
  }
  GeomAPI_Interpolate interpolate(points, parameters, false, closure);
  interpolate.Perform();
  return Handle(Geom_Curve)(interpolate.Curve());
}

Handle(Geom2d_Curve) curve_on_base(const Base& base, const PlanEdge& edge) {
  if (base.radius == 0) return curve_in_frame(edge, {}, 0);
  const std::vector<double> ts = curve_parameters(edge);
  Handle(TColgp_HArray1OfPnt2d) points = new TColgp_HArray1OfPnt2d(1, int(ts.size()));
  Handle(TColStd_HArray1OfReal) parameters = new TColStd_HArray1OfReal(1, int(ts.size()));
  for (int i = 0; i < int(ts.size()); ++i) {
    const Vec2 p = point_at(edge, ts[i]);
    points->SetValue(i + 1, gp_Pnt2d(std::asin(p.x / base.radius), p.y));
    parameters->SetValue(i + 1, ts[i]);
  }
  Geom2dAPI_Interpolate interpolate(points, parameters, false, closure);
  interpolate.Perform();
  return Handle(Geom2d_Curve)(interpolate.Curve());
}

Handle(Geom2d_Curve) curve_in_frame(const PlanEdge& edge, Vec2 origin, double angle) {
  const PlanEdge local = placed(placed({edge}, -origin, 0), {}, -angle).front();
  if (!local.is_arc()) {
    const Vec2 d = normalized(local.end - local.start);
    return new Geom2d_Line(gp_Pnt2d(local.start.x, local.start.y), gp_Dir2d(d.x, d.y));
  }
  // The plan's x axis keeps parameter 0, so that the arc has the same parameters in every frame.
  const gp_Ax22d axes(gp_Pnt2d(local.centre.x, local.centre.y), gp_Dir2d(std::cos(angle), -std::sin(angle)));
  return new Geom2d_Circle(axes, local.radius);
}

}  // namespace beadmesh::examples
