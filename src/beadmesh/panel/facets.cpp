#include "beadmesh/panel/facets.h"

#include <algorithm>
#include <utility>

namespace beadmesh {
namespace {

Vec3 triangle_vector_area(const Facets& facets, const Triangle& t) {
  const Vec3 a = facets.points[t[0]];
  return cross(facets.points[t[1]] - a, facets.points[t[2]] - a) / 2;
}

double loop_length(const Facets& facets, const std::vector<Index>& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    sum += distance(facets.points[loop[i]], facets.points[loop[(i + 1) % loop.size()]]);
  return sum;
}

Vec3 loop_vector_area(const Facets& facets, const std::vector<Index>& loop) {
  Vec3 sum;
  const Vec3 origin = facets.points[loop.front()];
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    sum += cross(facets.points[loop[i]] - origin, facets.points[loop[i + 1]] - origin) / 2;
  return sum;
}

/// Corner 3 * t + k is corner k of triangle t; half-edge 3 * t + k runs from corner k to the next.
constexpr Index next_corner(Index c) {
  return c % 3 == 2 ? c - 2 : c + 1;
}

class FacetTracer {
 public:
  FacetTracer(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) : points_(points) {
    for (const Triangle& t : triangles) corner_point_.insert(corner_point_.end(), t.begin(), t.end());
  }

  Facets trace() {
    pair_half_edges();
    weld_corners();
    trace_loops();
    if (!facets_.loops.empty()) std::swap(facets_.loops.front(), facets_.loops[outer_loop(facets_)]);
    return std::move(facets_);
  }

 private:
  /// Half-edges that are alone in their direction and have one partner in the other are inner; all others
  /// (free, of three or more triangles, or of two that disagree in orientation) are boundary.
  void pair_half_edges() {
    const Index n = static_cast<Index>(corner_point_.size());
    std::vector<Index> order(n);
    for (Index c = 0; c < n; ++c) order[c] = c;
    const auto key = [&](Index c) { return std::minmax({corner_point_[c], corner_point_[next_corner(c)]}); };
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
      const auto ka = key(a), kb = key(b);
      return ka != kb ? ka < kb : a < b;
    });
    opposite_.assign(n, no_index);
    for (Index i = 0, j; i < n; i = j) {
      for (j = i + 1; j < n && key(order[j]) == key(order[i]);) ++j;
      if (j - i == 2 && corner_point_[order[i]] != corner_point_[order[i + 1]]) {
        opposite_[order[i]] = order[i + 1];
        opposite_[order[i + 1]] = order[i];
      }
    }
  }

  /// Turns from half-edge to half-edge around the tail of `c`, clockwise, until the boundary (or a full
  /// turn).
  Index first_in_fan(Index c) const {
    Index at = c;
    while (opposite_[at] != no_index) {
      at = next_corner(opposite_[at]);
      if (at == c) break;
    }
    return at;
  }

  /// One local vertex per fan of triangles, so that a point where the piece only touches itself stays
  /// manifold.
  void weld_corners() {
    const Index n = static_cast<Index>(corner_point_.size());
    corner_vertex_.assign(n, no_index);
    facets_.triangles.resize(n / 3);
    for (Index c = 0; c < n; ++c) {
      if (corner_vertex_[c] == no_index) {
        const Index vertex = static_cast<Index>(facets_.points.size());
        facets_.points.push_back(points_[corner_point_[c]]);
        facets_.panel_points.push_back(corner_point_[c]);
        mark_fan(first_in_fan(c), vertex);
      }
      facets_.triangles[c / 3][c % 3] = corner_vertex_[c];
    }
  }

  /// Counter-clockwise from the first half-edge of the fan: the one before it in the triangle, seen from
  /// beyond.
  void mark_fan(Index first, Index vertex) {
    for (Index at = first; at != no_index && corner_vertex_[at] == no_index;) {
      corner_vertex_[at] = vertex;
      at = opposite_[next_corner(next_corner(at))];
    }
  }

  void trace_loops() {
    const Index n = static_cast<Index>(corner_point_.size());
    std::vector<bool> done(n, false);
    for (Index c = 0; c < n; ++c) {
      if (opposite_[c] != no_index || done[c]) continue;
      std::vector<Index> loop;
      for (Index at = c; !done[at]; at = first_in_fan(next_corner(at))) {
        done[at] = true;
        loop.push_back(corner_vertex_[at]);
      }
      facets_.loops.push_back(std::move(loop));
    }
  }

  const std::vector<Vec3>& points_;
  Facets facets_;
  std::vector<Index> corner_point_;   // per corner: index in points_
  std::vector<Index> corner_vertex_;  // per corner: local vertex
  std::vector<Index> opposite_;       // per half-edge: its partner, or no_index
};

}  // namespace

Facets facets_of_triangles(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
  return FacetTracer(points, triangles).trace();
}

Vec3 corner_normal(const Facets& facets, Index triangle, int k) {
  if (!facets.triangle_uv.empty() && !facets.surfaces.empty())
    if (const auto& surface = facets.surfaces[facets.triangle_surface[triangle]]) {
      const Vec3 normal = surface->normal(facets.triangle_uv[triangle][k]);
      if (squared_norm(normal) > 0.5) return normal;  // zero where the surface is singular
    }
  return normalized(triangle_vector_area(facets, facets.triangles[triangle]));
}

Vec3 vector_area(const Facets& facets) {
  Vec3 sum;
  for (const Triangle& t : facets.triangles) sum += triangle_vector_area(facets, t);
  return sum;
}

double area(const Facets& facets) {
  double sum = 0;
  for (const Triangle& t : facets.triangles) sum += norm(triangle_vector_area(facets, t));
  return sum;
}

std::size_t outer_loop(const Facets& facets) {
  const Vec3 mean = vector_area(facets);
  const bool has_normal = norm(mean) > 0.05 * area(facets);
  std::size_t best = 0;
  double best_size = 0;
  for (std::size_t i = 0; i < facets.loops.size(); ++i) {
    const std::vector<Index>& loop = facets.loops[i];
    const double size = has_normal ? dot(loop_vector_area(facets, loop), mean) : loop_length(facets, loop);
    if (i == 0 || size > best_size) best = i, best_size = size;
  }
  return best;
}

}  // namespace beadmesh
