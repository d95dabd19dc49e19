#include "beadmesh/blocking/axis_station.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

BoundaryPosition foot_between(const Foot& a, const Foot& b, double t,
                              const std::vector<double>& loop_lengths) {
  if (a.loop != b.loop)
    return t < 0.5 ? BoundaryPosition{a.loop, a.position} : BoundaryPosition{b.loop, b.position};
  const double length = loop_lengths[a.loop];
  double at = std::fmod(a.position + t * loop_difference(a.position, b.position, length), length);
  if (at < 0) at += length;
  return {a.loop, at};
}

}  // namespace

std::vector<double> loop_lengths_of(const PlanarRegion& region) {
  std::vector<double> lengths;
  for (const PlanarLoop& loop : region.loops) {
    double length = 0;
    for (size_t i = 0; i < loop.points.size(); ++i)
      length += distance(loop.points[i], loop.points[(i + 1) % loop.points.size()]);
    lengths.push_back(length);
  }
  return lengths;
}

double loop_difference(double a, double b, double loop_length) {
  return std::remainder(b - a, loop_length);
}

std::vector<double> distances_along(const SkeletonArm& arm) {
  std::vector<double> along{0};
  for (size_t i = 1; i < arm.points.size(); ++i)
    along.push_back(along.back() + distance(arm.points[i - 1].point, arm.points[i].point));
  return along;
}

AxisStation station_at(const SkeletonArm& arm, double along, const std::vector<double>& loop_lengths) {
  const std::vector<double> at = distances_along(arm);
  const size_t last = at.size() - 1;
  const bool closed = arm.start == no_index;
  const double closing = closed ? distance(arm.points.back().point, arm.points.front().point) : 0;
  const double length = at.back() + closing;
  if (closed) {
    along = std::fmod(along, length);
    if (along < 0) along += length;
  }
  along = std::clamp(along, 0.0, length);
  size_t i = std::upper_bound(at.begin(), at.end(), along) - at.begin();
  i = i > 0 ? i - 1 : 0;
  if (!closed && i == last && last > 0) i = last - 1;
  const size_t j = i == last ? (closed ? 0 : last) : i + 1;
  const double step = i == last ? closing : at[j] - at[i];
  const double t = step > 0 ? (along - at[i]) / step : 0;
  const MedialPoint &a = arm.points[i], &b = arm.points[j];
  AxisStation out;
  out.along = along;
  out.centre = lerp(a.point, b.point, t);
  out.radius = a.radius + t * (b.radius - a.radius);
  out.subtended_angle = a.subtended_angle + t * (b.subtended_angle - a.subtended_angle);
  out.left = foot_between(a.feet[0], b.feet[0], t, loop_lengths);
  out.right = foot_between(a.feet[1], b.feet[1], t, loop_lengths);
  return out;
}

}  // namespace beadmesh
