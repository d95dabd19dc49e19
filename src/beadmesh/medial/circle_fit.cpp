#include "beadmesh/medial/circle_fit.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {

std::vector<Vec2> points_near(const std::vector<Vec2>& points, const Circle& circle, double band) {
  std::vector<Vec2> near;
  for (const Vec2 p : points)
    if (std::abs(distance(p, circle.centre) - circle.radius) <= band) near.push_back(p);
  return near;
}

double arc_of(const std::vector<Vec2>& points, Vec2 centre) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 a = points[i - 1] - centre, b = points[i] - centre;
    sum += std::atan2(cross(a, b), dot(a, b));
  }
  return sum;
}

std::optional<Circle> fitted_circle(const std::vector<Vec2>& points, const Circle& start) {
  if (points.size() < 3) return std::nullopt;
  Circle circle = start;
  const double count = static_cast<double>(points.size());
  for (int step = 0; step < 30; ++step) {
    Vec2 mean;
    double mean_distance = 0;
    for (const Vec2 p : points) {
      const double d = distance(p, circle.centre);
      if (!(d > 0)) return std::nullopt;
      mean += (circle.centre - p) / (d * count);
      mean_distance += d / count;
    }
    double xx = 0, xy = 0, yy = 0;
    Vec2 right;
    for (const Vec2 p : points) {
      const double d = distance(p, circle.centre);
      const Vec2 u = (circle.centre - p) / d - mean;
      xx += u.x * u.x, xy += u.x * u.y, yy += u.y * u.y;
      right += u * (mean_distance - d);
    }
    const double det = xx * yy - xy * xy;
    if (!(det > 1e-12 * (xx + yy) * (xx + yy))) return std::nullopt;
    const Vec2 move = Vec2{yy * right.x - xy * right.y, xx * right.y - xy * right.x} / det;
    circle = {circle.centre + move, mean_distance + dot(mean, move)};
    if (!std::isfinite(circle.radius) || !(circle.radius > 0)) return std::nullopt;
    if (norm(move) < 1e-14 * circle.radius) break;
  }
  return circle;
}

}  // namespace beadmesh
