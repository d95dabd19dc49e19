#include "beadmesh/blocking/arm_line.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

double nearest_on(const std::vector<Vec2>& line, const std::vector<double>& at, Vec2 p) {
  double best = 0, best_distance = distance(line.front(), p);
  for (size_t i = 1; i < line.size(); ++i) {
    const Vec2 a = line[i - 1], u = line[i] - a;
    const double uu = dot(u, u);
    const double t = uu > 0 ? std::clamp(dot(p - a, u) / uu, 0.0, 1.0) : 0;
    const double d = distance(a + u * t, p);
    if (d < best_distance) {
      best_distance = d;
      best = at[i - 1] + t * std::sqrt(uu);
    }
  }
  return best;
}

}  // namespace

ArmLine::ArmLine(const SkeletonArm& medial, const RidgeArm& ridge, const std::vector<double>& loop_lengths)
    : medial_(&medial), points_(ridge.points), loop_lengths_(&loop_lengths) {
  at_.push_back(0);
  for (size_t i = 1; i < points_.size(); ++i)
    at_.push_back(at_.back() + distance(points_[i - 1], points_[i]));
  medial_at_ = distances_along(medial);
}

Vec2 ArmLine::point(double along) const {
  along = std::clamp(along, 0.0, length());
  const size_t next = std::upper_bound(at_.begin(), at_.end(), along) - at_.begin();
  const size_t i = std::clamp<size_t>(next, 1, points_.size() - 1) - 1;
  const double step = at_[i + 1] - at_[i];
  return lerp(points_[i], points_[i + 1], step > 0 ? (along - at_[i]) / step : 0);
}

std::vector<Vec2> ArmLine::between(double from, double to) const {
  std::vector<Vec2> out;
  const double margin = 1e-6 * length();
  for (size_t i = 0; i < points_.size(); ++i)
    if (at_[i] > from + margin && at_[i] < to - margin) out.push_back(points_[i]);
  return out;
}

double ArmLine::nearest(Vec2 p) const {
  return nearest_on(points_, at_, p);
}

AxisStation ArmLine::station(double along) const {
  std::vector<Vec2> axis;
  for (const MedialPoint& m : medial_->points) axis.push_back(m.point);
  return station_at(*medial_, nearest_on(axis, medial_at_, point(along)), *loop_lengths_);
}

}  // namespace beadmesh
