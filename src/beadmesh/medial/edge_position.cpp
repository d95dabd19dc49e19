#include <algorithm>
#include <cmath>

#include "beadmesh/medial/medial_object.h"
#include "beadmesh/medial/radius_along.h"

namespace beadmesh {
namespace {

/// Both feet lie on the boundary; between two of one loop the arc length is interpolated the short way round
/// only where that does not pass the loop's start, which the points tell: else the nearer of the two is
/// taken.
Foot interpolated(const Foot& a, const Foot& b, double t) {
  const double chord = distance(a.point, b.point);
  const bool beside = a.loop == b.loop && std::abs(b.position - a.position) <= 2 * chord + 1e-12;
  if (!beside) return t < 0.5 ? a : b;
  return {lerp(a.point, b.point, t), a.loop, a.position * (1 - t) + b.position * t};
}

MedialPoint interpolated(const MedialPoint& a, const MedialPoint& b, double t) {
  return {lerp(a.point, b.point, t),
          RadiusAlong(a, b).at(t),
          {interpolated(a.feet[0], b.feet[0], t), interpolated(a.feet[1], b.feet[1], t)},
          a.subtended_angle * (1 - t) + b.subtended_angle * t};
}

}  // namespace

MedialPoint point_at(const MedialEdge& edge, double distance_along) {
  const std::size_t n = edge.points.size();
  if (n == 0) return {};
  const bool closed = edge.type == MedialEdgeType::N;
  double left = distance_along;
  if (closed && edge.length > 0) left -= edge.length * std::floor(left / edge.length);
  for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
    const MedialPoint &a = edge.points[i], &b = edge.points[(i + 1) % n];
    const double step = distance(a.point, b.point);
    if (left <= step) return step > 0 ? interpolated(a, b, std::max(left, 0.0) / step) : a;
    left -= step;
  }
  return closed ? edge.points.front() : edge.points.back();
}

}  // namespace beadmesh
