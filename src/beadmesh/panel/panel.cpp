#include "beadmesh/panel/panel.h"

#include <algorithm>

namespace beadmesh {
namespace {

/// Corner 3 * t + k is corner k of triangle t; half-edge 3 * t + k runs from corner k to the next.
constexpr Index next_corner(Index c) { return c % 3 == 2 ? c - 2 : c + 1; }

class FacetJoiner {
 public:
  FacetJoiner(const Panel& panel, const std::vector<Index>& faces) : panel_(panel) {
    for (const Index f : faces) append(panel.faces[f].facets);
    if (uv_of_all_) joined_.triangle_uv = std::move(uv_);
  }

  Facets join() {
    pair_half_edges();
    weld_corners();
    trace_loops();
    if (!joined_.loops.empty()) std::swap(joined_.loops.front(), joined_.loops[outer_loop(joined_)]);
    return std::move(joined_);
  }

 private:
  void append(const Facets& facets) {
    for (const Triangle& t : facets.triangles)
      for (const Index v : t) corner_point_.push_back(facets.panel_points[v]);
    joined_.triangle_face.insert(joined_.triangle_face.end(), facets.triangle_face.begin(),
                                 facets.triangle_face.end());
    uv_of_all_ = uv_of_all_ && facets.triangle_uv.size() == facets.triangles.size();
    uv_.insert(uv_.end(), facets.triangle_uv.begin(), facets.triangle_uv.end());
    if (joined_.surfaces.size() < facets.surfaces.size()) joined_.surfaces.resize(facets.surfaces.size());
    for (std::size_t i = 0; i < facets.surfaces.size(); ++i)
      if (facets.surfaces[i]) joined_.surfaces[i] = facets.surfaces[i];
  }

  /// Half-edges that are alone in their direction and have one partner in the other are inner; all others (free, of
  /// three or more triangles, or of two that disagree in orientation) are boundary.
  void pair_half_edges() {
    const Index n = static_cast<Index>(corner_point_.size());
    std::vector<Index> order(n);
    for (Index c = 0; c < n; ++c) order[c] = c;
    const auto key = [&](Index c) {
      return std::minmax({corner_point_[c], corner_point_[next_corner(c)]});
    };
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

  /// Turns from half-edge to half-edge around the tail of `c`, clockwise, until the boundary (or a full turn).
  Index first_in_fan(Index c) const {
    Index at = c;
    while (opposite_[at] != no_index) {
      at = next_corner(opposite_[at]);
      if (at == c) break;
    }
    return at;
  }

  /// One local vertex per fan of triangles, so that a point where the piece only touches itself stays manifold.
  void weld_corners() {
    const Index n = static_cast<Index>(corner_point_.size());
    corner_vertex_.assign(n, no_index);
    joined_.triangles.resize(n / 3);
    for (Index c = 0; c < n; ++c) {
      if (corner_vertex_[c] == no_index) {
        const Index vertex = static_cast<Index>(joined_.points.size());
        joined_.points.push_back(panel_.points[corner_point_[c]]);
        joined_.panel_points.push_back(corner_point_[c]);
        mark_fan(first_in_fan(c), vertex);
      }
      joined_.triangles[c / 3][c % 3] = corner_vertex_[c];
    }
  }

  /// Counter-clockwise from the first half-edge of the fan: the one before it in the triangle, seen from beyond.
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
      joined_.loops.push_back(std::move(loop));
    }
  }

  const Panel& panel_;
  Facets joined_;
  std::vector<Index> corner_point_;   // per corner: index in Panel::points
  std::vector<Index> corner_vertex_;  // per corner: local vertex
  std::vector<Index> opposite_;       // per half-edge: its partner, or no_index
  std::vector<std::array<Vec2, 3>> uv_;
  bool uv_of_all_ = true;
};

}  // namespace

Facets facets_of(const Panel& panel, const std::vector<Index>& faces) {
  if (faces.size() == 1) return panel.faces[faces.front()].facets;
  return FacetJoiner(panel, faces).join();
}

double diagonal(const Panel& panel) {
  if (panel.points.empty()) return 0;
  Vec3 low = panel.points.front(), high = low;
  for (const Vec3 p : panel.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return distance(low, high);
}

}  // namespace beadmesh
