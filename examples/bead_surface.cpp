#include "examples/bead_surface.h"

#include <algorithm>
#include <cmath>

#include "examples/spline_surface.h"

namespace beadmesh::examples {
namespace {

constexpr double max_gap = 0.003;              // mm
constexpr double max_bend = 0.4 * (pi / 180);  // radians
constexpr int finest_division = 24;            // of the half width, a stop for hopeless requests

Vec2 to_panel(const Feature& feature, Vec2 local) {
  const double c = std::cos(feature.angle), s = std::sin(feature.angle);
  return feature.origin + Vec2{c * local.x - s * local.y, s * local.x + c * local.y};
}

/// Steps of at most `step` over the loop's extent along x or y and a margin.
std::vector<double> grid_steps(const std::vector<Vec2>& loop, double Vec2::*axis, double step) {
  const auto [low, high] =
      std::minmax_element(loop.begin(), loop.end(), [&](Vec2 a, Vec2 b) { return a.*axis < b.*axis; });
  const double from = (*low).*axis - 4 * step, to = (*high).*axis + 4 * step;
  return even_steps(from, to, int(std::ceil((to - from) / step)));
}

Handle(Geom_BSplineSurface) surface_on_grid(const Base& base, const Feature& feature, double step) {
  const BoundaryDistance boundary(feature.footprint.loops);
  const std::vector<Vec2> outline = sampled(feature.footprint.loops.front());
  const std::vector<double> us = grid_steps(outline, &Vec2::x, step),
                            vs = grid_steps(outline, &Vec2::y, step);
  std::vector<Vec3> points;
  points.reserve(us.size() * vs.size());
  for (const double u : us)
    for (const double v : vs) {
      const Vec2 local{u, v};
      points.push_back(base.point(to_panel(feature, local)) + Vec3{0, 0, feature.rise(local, boundary)});
    }
  return spline_through(us, vs, points);
}

/// Does the surface leave the base smoothly along the whole boundary?
bool meets_base(const Base& base, const Feature& feature, const Handle(Geom_BSplineSurface) & surface) {
  for (const PlanLoop& loop : feature.footprint.loops)
    for (const PlanEdge& edge : loop) {
      const int pieces = std::max(8, int(edge.length() / 0.3));
      for (int i = 0; i < pieces; ++i) {
        const Vec2 local = edge.point((i + 0.5) / pieces), p = to_panel(feature, local);
        gp_Pnt at;
        gp_Vec du, dv;
        surface->D1(local.x, local.y, at, du, dv);
        const gp_Vec n = du.Crossed(dv);
        if (std::abs(at.Z() - base.height(p)) > max_gap) return false;
        if (angle_between(base.normal(p), Vec3{n.X(), n.Y(), n.Z()}) > max_bend) return false;
      }
    }
  return true;
}

/// The surface without the knots it can lose for less than a thousandth of a millimetre (along straight
/// arms).
Handle(Geom_BSplineSurface) simplified(const Handle(Geom_BSplineSurface) & full) {
  constexpr double loss = 5e-5;  // mm, at each knot
  Handle(Geom_BSplineSurface) lean = Handle(Geom_BSplineSurface)::DownCast(full->Copy());
  for (int i = lean->NbUKnots() - 1; i > 1; --i) lean->RemoveUKnot(i, 0, loss);
  for (int i = lean->NbVKnots() - 1; i > 1; --i) lean->RemoveVKnot(i, 0, loss);
  return lean;
}

}  // namespace

Handle(Geom_BSplineSurface) bead_surface(const Base& base, const Feature& feature) {
  const double half = std::min(feature.footprint.half_width, feature.footprint.end_half_width);
  for (int division = 4;; ++division) {
    const Handle(Geom_BSplineSurface) full = surface_on_grid(base, feature, half / division);
    if (division < finest_division && !meets_base(base, feature, full)) continue;
    const Handle(Geom_BSplineSurface) lean = simplified(full);
    return meets_base(base, feature, lean) ? lean : full;
  }
}

}  // namespace beadmesh::examples
