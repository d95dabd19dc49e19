#include "beadmesh/read/face_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "beadmesh/read/face_boundary.h"
#include "beadmesh/read/point_hash.h"

namespace beadmesh {
namespace {

constexpr double clearance = 0.76;  // of the wanted size: no other point nearer than that
constexpr double farthest =
    1e9;  // mm from the origin; damaged surfaces have points anywhere, and some are no numbers
constexpr std::size_t most_points = 400'000;  // more than a whole car body side at a chord of 0.02 mm

/// A point that may spawn others, and the direction (in space) its pattern is turned to.
struct Spawner {
  Vec3 point, du, dv;
  Vec2 uv;
  Vec3 along;
};

class PointSpawner {
 public:
  PointSpawner(const Geom_Surface& surface, const FaceSpace& space,
               const std::vector<std::vector<Index>>& polygons, FaceNodes& nodes)
      : surface_(surface), space_(space), nodes_(nodes), inside_(polygons, stretched(nodes, space)) {
    for (const std::vector<Index>& polygon : polygons) add_boundary(polygon);
  }

  bool spawn() {
    if (too_many_) return false;
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      if (queue_.size() > most_points) return false;
      const Spawner parent = queue_[i];  // the queue grows meanwhile
      spawn_from(parent);
    }
    return true;
  }

 private:
  static std::vector<Vec2> stretched(const FaceNodes& nodes, const FaceSpace& space) {
    std::vector<Vec2> result;
    for (const Vec2 uv : nodes.uv) result.push_back(space.stretched(uv));
    return result;
  }

  static bool is_near(Vec3 p) { return squared_norm(p) < farthest * farthest; }

  void add_boundary(const std::vector<Index>& polygon) {
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 before = nodes_.points[polygon[(i + n - 1) % n]], here = nodes_.points[polygon[i]],
                 after = nodes_.points[polygon[(i + 1) % n]];
      too_many_ = too_many_ || !is_near(here);
      if (too_many_) return;
      taken_.insert(here, space_.sizes.at(space_.stretched(nodes_.uv[polygon[i]])));
      guard_segment(polygon[i], polygon[(i + 1) % n]);
      const Vec2 uv = nodes_.uv[polygon[i]];
      const SurfaceFrame frame = frame_at(surface_, uv);
      queue_.push_back({here, frame.du, frame.dv, uv, after - before});
    }
  }

  /// Keeps points away from the inside of a segment, too.
  void guard_segment(Index a, Index b) {
    const Vec3 from = nodes_.points[a], to = nodes_.points[b];
    const double length = distance(from, to);
    if (length <= 0) return;
    const double size = space_.sizes.at(space_.stretched((nodes_.uv[a] + nodes_.uv[b]) / 2));
    const double wanted = std::ceil(length / (0.8 * size));
    too_many_ = too_many_ || !(wanted < most_points);
    if (too_many_) return;
    const int pieces = std::max(2, static_cast<int>(wanted));
    for (int i = 1; i < pieces; ++i) taken_.insert(lerp(from, to, static_cast<double>(i) / pieces), size);
  }

  void spawn_from(const Spawner& parent) {
    const Vec3 normal = normalized(cross(parent.du, parent.dv));
    const Vec3 x = normalized(parent.along - normal * dot(parent.along, normal));
    if (squared_norm(x) == 0) return;
    const Vec3 y = cross(normal, x);
    const double step = space_.sizes.at(space_.stretched(parent.uv));
    for (int k = 0; k < 6; ++k) {
      // The first two go to the left of a boundary, inwards.
      constexpr int order[6] = {1, 2, 0, 3, 4, 5};
      const double angle = order[k] * (pi / 3);
      const Vec3 direction = x * std::cos(angle) + y * std::sin(angle);
      if (const auto child = child_at(parent, direction, step)) accept(*child);
    }
  }

  /// First guess in the tangent plane; only where that is free the surface is asked.
  std::optional<Spawner> child_at(const Spawner& parent, Vec3 direction, double step) const {
    if (!taken_.is_free(parent.point + direction * step, 0.8 * clearance * step, step)) return {};
    const double e = dot(parent.du, parent.du), f = dot(parent.du, parent.dv), g = dot(parent.dv, parent.dv);
    const double a = dot(direction, parent.du) * step, b = dot(direction, parent.dv) * step;
    const double det = e * g - f * f;
    if (!(det > 1e-12 * e * g)) return {};
    const Vec2 uv{parent.uv.x + (a * g - b * f) / det, parent.uv.y + (b * e - a * f) / det};
    const Vec2 st = space_.stretched(uv);
    if (!inside_(st)) return {};
    const double size = space_.sizes.at(st);
    const SurfaceFrame frame = frame_at(surface_, uv);
    if (!is_near(frame.point)) return {};
    if (!taken_.is_free(frame.point, clearance * std::min(size, step), size)) return {};
    return Spawner{frame.point, frame.du, frame.dv, uv, parent.along};
  }

  void accept(const Spawner& child) {
    taken_.insert(child.point, space_.sizes.at(space_.stretched(child.uv)));
    nodes_.uv.push_back(child.uv);
    nodes_.points.push_back(child.point);
    queue_.push_back(child);
  }

  const Geom_Surface& surface_;
  const FaceSpace& space_;
  FaceNodes& nodes_;
  InsideTest inside_;
  PointHash taken_;
  std::vector<Spawner> queue_;
  bool too_many_ = false;  // already on the boundary
};

}  // namespace

bool spawn_inner_points(const Geom_Surface& surface, const FaceSpace& space,
                        const std::vector<std::vector<Index>>& polygons, FaceNodes& nodes) {
  return PointSpawner(surface, space, polygons, nodes).spawn();
}

}  // namespace beadmesh
