#include "beadmesh/medial/axis_smoothing.h"

#include <algorithm>

namespace beadmesh {
namespace {

/// Value at x of the polynomial through the points (xs, ys), Lagrange's form.
double interpolated(const std::vector<Vec2>& points, double x) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double weight = 1;
    for (std::size_t k = 0; k < points.size(); ++k)
      if (k != i) weight *= (x - points[k].x) / (points[i].x - points[k].x);
    sum += weight * points[i].y;
  }
  return sum;
}

/// Value at x of the cubic with the least norm of coefficients through three points: the quadratic through
/// them plus a multiple of the cubic that vanishes there.
double least_norm_cubic(const std::vector<Vec2>& p, double x) {
  const double q0 = interpolated(p, 0), q_plus = interpolated(p, 1), q_minus = interpolated(p, -1);
  const double q2 = (q_plus + q_minus) / 2 - q0, q1 = (q_plus - q_minus) / 2;
  const double z2 = -(p[0].x + p[1].x + p[2].x), z0 = -p[0].x * p[1].x * p[2].x;
  const double z1 = p[0].x * p[1].x + p[1].x * p[2].x + p[2].x * p[0].x;
  const double factor = -(q0 * z0 + q1 * z1 + q2 * z2) / (1 + z0 * z0 + z1 * z1 + z2 * z2);
  return q0 + x * (q1 + x * q2) + factor * (z0 + x * (z1 + x * (z2 + x)));
}

void smooth_point(std::vector<Vec2>& points, std::size_t i, bool closed) {
  const auto n = static_cast<std::ptrdiff_t>(points.size());
  std::vector<Vec2> around;
  for (const std::ptrdiff_t offset : {-2, -1, 1, 2}) {
    std::ptrdiff_t at = static_cast<std::ptrdiff_t>(i) + offset;
    if (closed) at = (at + n) % n;
    if (at >= 0 && at < n) around.push_back(points[static_cast<std::size_t>(at)]);
  }
  if (around.size() < 3) return;
  Vec2 origin;
  for (const Vec2 p : around) origin += p / static_cast<double>(around.size());
  const Vec2 direction = around.back() - around.front();
  const double scale = norm(direction) / 2;
  if (!(scale > 0)) return;
  const Vec2 x_axis = direction / (scale * 2), y_axis = left_normal(x_axis);
  const auto local = [&](Vec2 p) { return Vec2{dot(p - origin, x_axis), dot(p - origin, y_axis)} / scale; };
  const double x = local(points[i]).x;
  double last = -1e30;
  for (Vec2& p : around) {
    p = local(p);
    if (p.x - last < 0.02) return;
    last = p.x;
  }
  if (x < around.front().x || x > around.back().x) return;
  const double y = around.size() == 4 ? interpolated(around, x) : least_norm_cubic(around, x);
  points[i] = origin + (x_axis * x + y_axis * y) * scale;
}

}  // namespace

void smooth_cubic(std::vector<Vec2>& points, bool closed) {
  const std::size_t n = points.size();
  if (n < (closed ? 5u : 4u)) return;
  const std::size_t first = closed ? 0 : 1, end = closed ? n : n - 1;
  for (std::size_t i = first; i < end; ++i) smooth_point(points, i, closed);
  for (std::size_t i = end; i-- > first;) smooth_point(points, i, closed);
}

}  // namespace beadmesh
