#include "examples/panel_design.h"

#include <algorithm>
#include <cmath>

namespace beadmesh::examples {
namespace {

std::vector<PlanLoop> placed_all(const std::vector<PlanLoop>& chains, const Feature& feature) {
  std::vector<PlanLoop> result;
  for (const PlanLoop& chain : chains) result.push_back(placed(chain, feature.origin, feature.angle));
  return result;
}

}  // namespace

double Base::height(Vec2 p) const {
  if (radius > 0) return std::sqrt(radius * radius - p.x * p.x) - radius;
  return xx * p.x * p.x + yy * p.y * p.y + xy * p.x * p.y + xxx * p.x * p.x * p.x;
}

Vec3 Base::normal(Vec2 p) const {
  if (radius > 0) return normalized(Vec3{p.x, 0, std::sqrt(radius * radius - p.x * p.x)});
  const double dx = 2 * xx * p.x + xy * p.y + 3 * xxx * p.x * p.x, dy = 2 * yy * p.y + xy * p.x;
  return normalized(Vec3{-dx, -dy, 1});
}

std::vector<PlanLoop> Feature::loops() const {
  return placed_all(footprint.loops, *this);
}

std::vector<PlanLoop> Feature::centrelines() const {
  return placed_all(footprint.centrelines, *this);
}

double Feature::height_share(Vec2 plan) const {
  if (walls.run_out <= 0) return 1;
  double reach = 0;
  for (const Vec2 p : sampled(footprint.loops.front())) reach = std::max(reach, std::abs(p.x));
  const double along = dot(plan - origin, Vec2{std::cos(angle), std::sin(angle)});
  const double t = std::clamp((reach - std::abs(along)) / walls.run_out, 0.0, 1.0);
  return 0.35 + 0.65 * t * t * (3 - 2 * t);
}

double Feature::rise(Vec2 local, const BoundaryDistance& boundary) const {
  const double inside = boundary(local);
  if (inside <= 0) return 0;
  double half = footprint.half_width;
  if (footprint.between_loops) half = (boundary.to_loop(0, local) + boundary.to_loop(1, local)) / 2;
  if (footprint.end_half_width != footprint.half_width) {
    const Vec2 axis = footprint.axis_end - footprint.axis_start;
    const double along = std::clamp(dot(local - footprint.axis_start, axis) / squared_norm(axis), 0.0, 1.0);
    half += along * (footprint.end_half_width - half);
  }
  // Both rise with the third power of the distance, so that slope and curvature vanish along the boundary and
  // a cubic spline follows closely; both are level at the crest.
  const double t = std::min(inside / half, 1.0);
  const double part =
      profile == Profile::bead ? t * t * t * (4 - 3 * t) : t * t * t * (10 - t * (15 - 6 * t));
  return height * part;
}

int PanelDesign::count(const std::string& kind) const {
  return int(
      std::count_if(features.begin(), features.end(), [&](const Feature& f) { return f.kind == kind; }));
}

}  // namespace beadmesh::examples
