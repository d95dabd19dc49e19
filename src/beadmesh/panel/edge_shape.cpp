#include "beadmesh/panel/edge_shape.h"

#include <algorithm>
#include <map>
#include <utility>

namespace beadmesh {
namespace {

/// What a face does beside a segment of its boundary.
struct Side {
  Vec3 normal;      ///< at the segment's middle
  double bend = 0;  ///< turn of the normal per length, along the segment and away from it
};

using Segment = std::pair<Index, Index>;  // two panel points, the lower one first

/// Side k of triangle t.
Side side_of(const Facets& facets, Index t, int k) {
  const Triangle& v = facets.triangles[t];
  const Vec3 a = facets.points[v[k]], b = facets.points[v[(k + 1) % 3]], c = facets.points[v[(k + 2) % 3]];
  const Vec3 at_a = corner_normal(facets, t, k), at_b = corner_normal(facets, t, (k + 1) % 3),
             at_c = corner_normal(facets, t, (k + 2) % 3);
  const Vec3 normal = normalized(at_a + at_b);
  constexpr double no_length = 1e-6;  // mm
  const double along = angle_between(at_a, at_b) / std::max(distance(a, b), no_length);
  const double away = angle_between(normal, at_c) / std::max(distance(c, (a + b) / 2), no_length);
  return {normal, std::max(along, away)};
}

class EdgeMeasure {
 public:
  explicit EdgeMeasure(const Panel& panel) {
    for (const PanelEdge& edge : panel.edges)
      for (std::size_t i = 1; i < edge.points.size(); ++i)
        sides_[std::minmax(edge.points[i - 1], edge.points[i])];
    for (const PanelFace& face : panel.faces)
      for (Index t = 0; t < static_cast<Index>(face.facets.triangles.size()); ++t) add_sides(face.facets, t);
  }

  EdgeShape shape_of(const PanelEdge& edge) const {
    EdgeShape shape{0, 0};
    for (std::size_t i = 1; i < edge.points.size(); ++i) {
      const auto& sides = sides_.at(std::minmax(edge.points[i - 1], edge.points[i]));
      if (sides.size() != 2) return {};
      shape.turn = std::max(shape.turn, angle_between(sides[0].normal, sides[1].normal));
      shape.bend = std::max({shape.bend, sides[0].bend, sides[1].bend});
    }
    return shape;
  }

 private:
  void add_sides(const Facets& facets, Index t) {
    for (int k = 0; k < 3; ++k) {
      const Triangle& v = facets.triangles[t];
      const auto at =
          sides_.find(std::minmax(facets.panel_points[v[k]], facets.panel_points[v[(k + 1) % 3]]));
      if (at != sides_.end()) at->second.push_back(side_of(facets, t, k));
    }
  }

  std::map<Segment, std::vector<Side>> sides_;  ///< of the segments of all edges
};

}  // namespace

std::vector<EdgeShape> edge_shapes(const Panel& panel) {
  const EdgeMeasure measure(panel);
  std::vector<EdgeShape> shapes;
  for (const PanelEdge& edge : panel.edges) shapes.push_back(measure.shape_of(edge));
  return shapes;
}

}  // namespace beadmesh
