#include "beadmesh/mesh/surface_polyline.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {

SurfacePolyline::SurfacePolyline(const std::vector<Vec2>& flat, const SurfaceMap& map) {
  double total = 0;
  for (size_t i = 1; i < flat.size(); ++i) total += distance(flat[i - 1], flat[i]);
  const double step = total / 16;
  points_.push_back(flat.front());
  for (size_t i = 1; i < flat.size(); ++i) {
    const double length = distance(flat[i - 1], flat[i]);
    const int pieces = step > 0 ? std::max(1, int(std::ceil(length / step - 1e-9))) : 1;
    for (int k = 1; k <= pieces; ++k) points_.push_back(lerp(flat[i - 1], flat[i], double(k) / pieces));
  }
  Index hint = no_index;
  Vec3 before;
  for (size_t i = 0; i < points_.size(); ++i) {
    const FacetPoint at = map.locate(points_[i], hint);
    hint = at.triangle;
    const Vec3 here = map.facet_point(at);
    flat_.push_back(i ? flat_.back() + distance(points_[i - 1], points_[i]) : 0);
    surface_.push_back(i ? surface_.back() + distance(before, here) : 0);
    before = here;
  }
}

Vec2 SurfacePolyline::point_at(double arc_length) const {
  const size_t next = std::upper_bound(surface_.begin(), surface_.end(), arc_length) - surface_.begin();
  const size_t i = std::clamp<size_t>(next, 1, surface_.size() - 1) - 1;
  const double step = surface_[i + 1] - surface_[i];
  const double t = step > 0 ? std::clamp((arc_length - surface_[i]) / step, 0.0, 1.0) : 0;
  return lerp(points_[i], points_[i + 1], t);
}

double SurfacePolyline::flat_share_at(double arc_length) const {
  const size_t next = std::upper_bound(surface_.begin(), surface_.end(), arc_length) - surface_.begin();
  const size_t i = std::clamp<size_t>(next, 1, surface_.size() - 1) - 1;
  const double step = surface_[i + 1] - surface_[i];
  const double t = step > 0 ? std::clamp((arc_length - surface_[i]) / step, 0.0, 1.0) : 0;
  return flat_.back() > 0 ? (flat_[i] + t * (flat_[i + 1] - flat_[i])) / flat_.back() : 0;
}

}  // namespace beadmesh
