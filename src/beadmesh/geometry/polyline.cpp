#include "beadmesh/geometry/polyline.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace beadmesh {
namespace {

template <class V>
double parameter(V a, V b, V p) {
  const V along = b - a;
  const double squared = dot(along, along);
  return squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0;
}

}  // namespace

double nearest_parameter(Vec2 a, Vec2 b, Vec2 p) {
  return parameter(a, b, p);
}
double nearest_parameter(Vec3 a, Vec3 b, Vec3 p) {
  return parameter(a, b, p);
}

template <class V>
Polyline<V>::Polyline(std::vector<V> points, bool closed) : points_(std::move(points)), closed_(closed) {
  assert(!points_.empty());
  positions_.push_back(0);
  const std::size_t count = points_.size() - (closed ? 0 : 1);
  for (std::size_t i = 0; i < count; ++i)
    positions_.push_back(positions_.back() + distance(points_[i], end(static_cast<Index>(i))));
}

template <class V>
double Polyline<V>::wrapped(double position) const {
  if (!closed_ || !(length() > 0)) return std::clamp(position, 0.0, length());
  const double rest = std::fmod(position, length());
  return rest < 0 ? rest + length() : rest;
}

template <class V>
Index Polyline<V>::segment_at(double position) const {
  const auto after = std::upper_bound(positions_.begin(), positions_.end(), wrapped(position));
  return std::min(static_cast<Index>(after - positions_.begin()), segments()) - 1;
}

template <class V>
V Polyline<V>::point_at(double position) const {
  const Index i = segment_at(position);
  if (i < 0) return points_.front();
  const double s = positions_[i + 1] - positions_[i];
  return s > 0 ? lerp(points_[i], end(i), std::min((wrapped(position) - positions_[i]) / s, 1.0))
               : points_[i];
}

template <class V>
V Polyline<V>::direction_at(double position) const {
  const Index i = segment_at(position);
  return i < 0 ? V{} : normalized(end(i) - points_[i]);
}

template <class V>
std::vector<V> Polyline<V>::resampled(Index parts) const {
  std::vector<V> result;
  for (Index k = 0; k < parts; ++k) result.push_back(point_at(length() * k / parts));
  if (!closed_) result.push_back(points_.back());
  return result;
}

template <class V>
typename Polyline<V>::Nearest Polyline<V>::nearest(V p) const {
  Nearest best{points_.front(), 0, distance(points_.front(), p)};
  for (Index i = 0; i < segments(); ++i) {
    const double t = nearest_parameter(points_[i], end(i), p);
    const V q = lerp(points_[i], end(i), t);
    const double d = distance(p, q);
    if (d < best.distance) best = {q, positions_[i] + t * (positions_[i + 1] - positions_[i]), d};
  }
  return best;
}

template class Polyline<Vec2>;
template class Polyline<Vec3>;

}  // namespace beadmesh
