#include "beadmesh/medial/axis_refinement.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

constexpr int greatest_depth = 14;

}  // namespace

double AxisRefiner::allowed(const AxisPoint& point) const {
  double open = curve_.noise();
  for (const BoundaryPlace& foot : point.feet)
    if (curve_.is_facet(foot.loop, foot.segment))
      open = std::max(open, curve_.tolerance(foot.loop, foot.segment));
  return std::max(chord_, 0.1 * open);
}

/// By the directions in which the axis passes the two points: across the line between the feet. Where the
/// feet are one point there is no direction.
bool AxisRefiner::may_be_off(const AxisPoint& from, const AxisPoint& to) const {
  const Vec2 line = to.circle.centre - from.circle.centre;
  // An arc is off by a quarter of what its end's tangent is off at the other end.
  const double limit = 2 * chord_;
  const auto is_off = [&](const AxisPoint& point) {
    const double width = squared_norm(point.across), along = dot(line, point.across);
    if (!(width > 4e-4 * point.circle.radius * point.circle.radius)) return false;
    if (along * along <= limit * limit * width) return false;
    const double open = 2 * allowed(point);
    return along * along > open * open * width;
  };
  return is_off(from) || is_off(to);
}

double AxisRefiner::points_wanted(const PlacedEdge& points) const {
  double wanted = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    if (!may_be_off(points[i], points[i + 1])) continue;
    const Vec2 line = points[i + 1].circle.centre - points[i].circle.centre, across = points[i].across;
    const double width = norm(across);
    if (width > 0) wanted += std::sqrt(std::abs(dot(line, across)) / (4 * width * allowed(points[i])));
  }
  return wanted;
}

bool AxisRefiner::point_between(const AxisPoint& from, const AxisPoint& to, AxisPoint& middle) const {
  middle.circle = {lerp(from.circle.centre, to.circle.centre, 0.5),
                   (from.circle.radius + to.circle.radius) / 2};
  const auto is_one_piece = [&](std::size_t side) {
    return from.feet[side].segment == to.feet[side].segment;
  };
  const auto nearest = [&](std::size_t side) {
    const Contact a = curve_.nearest(middle.circle.centre, from.feet[side]);
    const Contact b = curve_.nearest(middle.circle.centre, to.feet[side]);
    return a.distance <= b.distance ? a : b;
  };
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    middle.feet[side] = from.feet[side];
    if (is_one_piece(side))
      middle.feet[side].t = (from.feet[side].t + to.feet[side].t) / 2;
    else
      middle.feet[side] = nearest(side).place;
  }
  if (!polish(curve_, middle)) return false;
  // Where a branch was pruned the feet jump: a point may then be between two places of which one is not
  // nearest.
  const double least = middle.circle.radius - curve_.tolerances().rounding;
  return (is_one_piece(0) || nearest(0).distance >= least) &&
         (is_one_piece(1) || nearest(1).distance >= least);
}

void AxisRefiner::refine_line(const AxisPoint& from, const AxisPoint& to, int depth) {
  if (depth >= greatest_depth || !may_be_off(from, to)) return;
  AxisPoint middle;
  if (!point_between(from, to, middle)) return;
  const Vec2 line = to.circle.centre - from.circle.centre, at = middle.circle.centre - from.circle.centre;
  const double length = norm(line), along = dot(at, line) / length;
  if (!(along > 0.2 * length && along < 0.8 * length)) return;
  const double off = std::abs(cross(line, at)) / length;
  if (off <= allowed(middle)) return;
  refine_line(from, middle, depth + 1);
  made_.push_back(middle);
  refine_line(middle, to, depth + 1);
}

void AxisRefiner::refine_closed(PlacedEdge& points) {
  if (points.size() < 3) return;
  made_.clear();
  for (std::size_t i = 0; i < points.size(); ++i) {
    made_.push_back(points[i]);
    refine_line(points[i], points[i + 1 < points.size() ? i + 1 : 0], 0);
  }
  if (made_.size() > points.size()) points.assign(made_.begin(), made_.end());
}

void AxisRefiner::refine_open(PlacedEdge& points, const AxisPoint& start, bool start_merged,
                              const AxisPoint& end, bool end_merged) {
  bool any = points.empty() || may_be_off(start, points.front()) || may_be_off(points.back(), end);
  for (std::size_t i = 0; !any && i + 1 < points.size(); ++i) any = may_be_off(points[i], points[i + 1]);
  if (!any) return;
  made_.clear();
  if (!start_merged && !points.empty()) refine_line(start, points.front(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    made_.push_back(points[i]);
    if (i + 1 < points.size()) refine_line(points[i], points[i + 1], 0);
  }
  if (!end_merged && !points.empty()) refine_line(points.back(), end, 0);
  if (points.empty() && !start_merged && !end_merged) refine_line(start, end, 0);
  if (made_.size() > points.size()) points.assign(made_.begin(), made_.end());
}

}  // namespace beadmesh
