#include "beadmesh/panel/skin_offset.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

/// A surface at a distance below another one.
class MovedSurface : public SurfaceEvaluator {
 public:
  MovedSurface(std::shared_ptr<const SurfaceEvaluator> surface, double distance)
      : surface_(std::move(surface)), distance_(distance) {}
  Vec3 point(Vec2 uv) const override { return surface_->point(uv) - surface_->normal(uv) * distance_; }
  Vec3 normal(Vec2 uv) const override { return surface_->normal(uv); }

 private:
  std::shared_ptr<const SurfaceEvaluator> surface_;
  double distance_;
};

/// The planes that moved faces have at a point: it goes to where they meet.
struct PlanesAtPoint {
  std::vector<Vec3> normals;
  std::vector<double> distances;

  void add(Vec3 normal, double distance) {
    constexpr double alike = radians(5);
    for (std::size_t i = 0; i < normals.size(); ++i)
      if (angle_between(normals[i], normal) < alike) return;
    normals.push_back(normal);
    distances.push_back(distance);
  }

  /// Towards where the planes meet, from a few rounds of steps onto each (Kaczmarz).
  Vec3 shift() const {
    Vec3 sum;
    for (int round = 0; round < 60; ++round)
      for (std::size_t i = 0; i < normals.size(); ++i)
        sum -= normals[i] * (dot(normals[i], sum) + distances[i]);
    return sum;
  }
};

}  // namespace

void move_inwards(Panel& panel, const std::vector<double>& distances) {
  std::vector<PlanesAtPoint> planes(panel.points.size());
  for (std::size_t f = 0; f < panel.faces.size(); ++f) {
    const Facets& facets = panel.faces[f].facets;
    for (Index t = 0; t < static_cast<Index>(facets.triangles.size()); ++t)
      for (int k = 0; k < 3; ++k)
        planes[facets.panel_points[facets.triangles[t][k]]].add(corner_normal(facets, t, k), distances[f]);
  }
  std::vector<Vec3> moved = panel.points;
  for (std::size_t p = 0; p < moved.size(); ++p) moved[p] = panel.points[p] + planes[p].shift();
  panel.points = std::move(moved);
  for (std::size_t f = 0; f < panel.faces.size(); ++f) {
    if (distances[f] == 0) continue;
    Facets& facets = panel.faces[f].facets;
    bool is_sharp = false;
    for (std::size_t v = 0; v < facets.points.size(); ++v) {
      facets.points[v] = panel.points[facets.panel_points[v]];
      is_sharp = is_sharp || planes[facets.panel_points[v]].normals.size() > 1;
    }
    for (auto& surface : facets.surfaces)
      surface = is_sharp || !surface ? nullptr : std::make_shared<MovedSurface>(surface, distances[f]);
    for (const auto& loop : panel.faces[f].loops)
      for (const EdgeUse use : loop)
        panel.edges[use.edge].curve = nullptr, panel.edges[use.edge].parameters.clear();
  }
}

}  // namespace beadmesh
