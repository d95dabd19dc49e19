#include "beadmesh/bead/plan_frame.h"

#include <cmath>

namespace beadmesh {

PlanFrame::PlanFrame(const SurfaceMap* map, Vec2 around, Vec3 up) : map_(map), up_(up) {
  if (!map) return;
  origin_ = map->surface_point(map->locate(around));
  const Vec3 least = std::abs(up.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  x_ = normalized(cross(least, up));
  y_ = cross(up, x_);
}

Vec2 PlanFrame::to_plan(Vec2 flat) const {
  if (!map_) return flat;
  const Vec3 d = map_->surface_point(map_->locate(flat)) - origin_;
  return {dot(d, x_), dot(d, y_)};
}

double PlanFrame::height(Vec2 flat) const {
  return map_ ? dot(map_->surface_point(map_->locate(flat)) - origin_, up_) : 0;
}

Vec2 PlanFrame::to_flat(Vec2 plan, Vec2 guess) const {
  if (!map_) return plan;
  for (int i = 0; i < 5; ++i) {
    const Vec2 at = to_plan(guess);
    const Vec2 u = (to_plan(guess + Vec2{step_, 0}) - at) / step_,
               v = (to_plan(guess + Vec2{0, step_}) - at) / step_;
    const double det = cross(u, v);
    if (std::abs(det) < 0.05) break;  // a wall seen edge on: stay where it still can be told
    const Vec2 miss = plan - at;
    guess += {cross(miss, v) / det, cross(u, miss) / det};
  }
  return guess;
}

}  // namespace beadmesh
