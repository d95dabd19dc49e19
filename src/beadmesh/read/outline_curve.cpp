#include "beadmesh/read/outline_curve.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "beadmesh/geometry/polyline.h"

namespace beadmesh {
namespace {

constexpr std::size_t run = 16;  // segments in a box

double beyond(double low, double high, double x) {
  return std::max({low - x, x - high, 0.0});
}

}  // namespace

OutlineCurve::OutlineCurve(std::vector<Vec3> points, std::vector<Vec3> normals)
    : points_(std::move(points)), normals_(std::move(normals)) {
  for (std::size_t first = 0; first < points_.size(); first += run) {
    Box box{points_[first], points_[first]};
    for (std::size_t i = first; i <= std::min(first + run, points_.size()); ++i) {
      const Vec3 p = at(i);
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
    }
    boxes_.push_back(box);
  }
}

Vec3 OutlineCurve::along(std::size_t segment) const {
  return normalized(at(segment + 1) - at(segment));
}

OutlinePlace OutlineCurve::place(Vec3 point) const {
  double best = std::numeric_limits<double>::max(), best_t = 0;
  std::size_t segment = 0;
  for (std::size_t b = 0; b < boxes_.size(); ++b) {
    const Box& box = boxes_[b];
    const Vec3 off{beyond(box.low.x, box.high.x, point.x), beyond(box.low.y, box.high.y, point.y),
                   beyond(box.low.z, box.high.z, point.z)};
    if (squared_norm(off) >= best) continue;
    for (std::size_t i = b * run; i < std::min((b + 1) * run, points_.size()); ++i) {
      const double t = nearest_parameter(at(i), at(i + 1), point);
      const double d = squared_norm(lerp(at(i), at(i + 1), t) - point);
      if (d < best) best = d, best_t = t, segment = i;
    }
  }
  const std::size_t n = points_.size();
  const Vec3 nearest = lerp(at(segment), at(segment + 1), best_t);
  const Vec3 normal = normalized(lerp(normals_[segment], normals_[(segment + 1) % n], best_t));
  Vec3 way = along(segment);
  if (best_t <= 0) way = normalized(way + along((segment + n - 1) % n));
  if (best_t >= 1) way = normalized(way + along((segment + 1) % n));
  const Vec3 off = point - nearest;
  return {nearest, norm(off), dot(off, cross(normal, way)), dot(off, normal)};
}

}  // namespace beadmesh
