#include "beadmesh/read/facet_skin.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>

#include "beadmesh/read/orientation.h"

namespace beadmesh {
namespace {

using Corners = std::array<Vec3, 3>;
constexpr Index next_corner(Index c) { return c % 3 == 2 ? c - 2 : c + 1; }

class SkinBuilder {
 public:
  explicit SkinBuilder(double feature_angle) : feature_angle_(feature_angle) {}

  Panel build(const std::vector<Corners>& facets) {
    weld(facets);
    pair_half_edges();
    orient();
    split_regions();
    for (Index r = 0; r < region_count_; ++r) add_face(r);
    return std::move(panel_);
  }

 private:
  Index triangle_count() const { return static_cast<Index>(triangles_.size()); }
  Index tail(Index h) const { return triangles_[h / 3][h % 3]; }
  Index head(Index h) const { return tail(next_corner(h)); }

  void weld(const std::vector<Corners>& facets) {
    std::vector<Vec3> all;
    for (const Corners& corners : facets) all.insert(all.end(), corners.begin(), corners.end());
    panel_.points = all;
    const double tolerance = 1e-6 * diagonal(panel_);
    std::vector<Index> order(all.size()), to(all.size(), no_index);
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<Index>(i);
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b) { return all[a].x != all[b].x ? all[a].x < all[b].x : a < b; });
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (to[order[i]] != no_index) continue;
      to[order[i]] = order[i];
      for (std::size_t j = i + 1; j < order.size() && all[order[j]].x <= all[order[i]].x + tolerance; ++j)
        if (to[order[j]] == no_index && distance(all[order[j]], all[order[i]]) <= tolerance) to[order[j]] = order[i];
    }
    std::vector<Index> number(all.size(), no_index);
    panel_.points.clear();
    for (std::size_t c = 0; c < all.size(); c += 3) {
      const Index a = to[c], b = to[c + 1], d = to[c + 2];
      if (a == b || b == d || d == a) continue;
      for (const Index v : {a, b, d})
        if (number[v] == no_index) {
          number[v] = static_cast<Index>(panel_.points.size());
          panel_.points.push_back(all[v]);
        }
      triangles_.push_back({number[a], number[b], number[d]});
    }
    drop_repeated();
  }

  void drop_repeated() {
    std::map<std::array<Index, 3>, int> seen;
    std::vector<Triangle> once;
    for (const Triangle& t : triangles_) {
      std::array<Index, 3> key = t;
      std::sort(key.begin(), key.end());
      if (seen[key]++ == 0) once.push_back(t);
    }
    triangles_ = std::move(once);
  }

  /// Two half-edges on the same two points are partners, whichever way they run; three or more have no partner.
  void pair_half_edges() {
    const Index n = 3 * triangle_count();
    std::vector<Index> order(n);
    for (Index h = 0; h < n; ++h) order[h] = h;
    const auto key = [&](Index h) { return std::pair{std::min(tail(h), head(h)), std::max(tail(h), head(h))}; };
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
      const auto ka = key(a), kb = key(b);
      return ka != kb ? ka < kb : a < b;
    });
    partner_.assign(n, no_index);
    for (Index i = 0, j; i < n; i = j) {
      for (j = i + 1; j < n && key(order[j]) == key(order[i]);) ++j;
      if (j - i != 2 || order[i] / 3 == order[i + 1] / 3) continue;
      partner_[order[i]] = order[i + 1];
      partner_[order[i + 1]] = order[i];
    }
  }

  double area_of(Index t) const {
    const Triangle& v = triangles_[t];
    return norm(cross(panel_.points[v[1]] - panel_.points[v[0]], panel_.points[v[2]] - panel_.points[v[0]])) / 2;
  }

  /// Turns triangles so that partners run in opposite directions; the side with more area stays.
  void orient() {
    std::vector<int> side(triangles_.size(), -1);
    for (Index seed = 0; seed < triangle_count(); ++seed) {
      if (side[seed] >= 0) continue;
      std::vector<Index> piece{seed};
      side[seed] = 0;
      std::array<double, 2> weight{0, 0};
      for (std::size_t i = 0; i < piece.size(); ++i) {
        const Index t = piece[i];
        weight[side[t]] += area_of(t);
        for (Index h = 3 * t; h < 3 * t + 3; ++h) {
          if (partner_[h] == no_index || side[partner_[h] / 3] >= 0) continue;
          side[partner_[h] / 3] = side[t] ^ (tail(h) == tail(partner_[h]) ? 1 : 0);
          piece.push_back(partner_[h] / 3);
        }
      }
      const int minority = weight[1] > weight[0] ? 0 : 1;
      for (const Index t : piece)
        if (side[t] == minority) turned_.push_back(t);
    }
    for (const Index t : turned_) std::swap(triangles_[t][1], triangles_[t][2]);
    if (!turned_.empty())
      panel_.diagnostics.push_back({"read.turned_over", Severity::note, no_index, {},
                                    std::to_string(turned_.size()) + " facets were turned over to agree with their neighbours", {}});
    pair_half_edges();
    for (Index h = 0; h < 3 * triangle_count(); ++h)
      if (partner_[h] != no_index && tail(h) == tail(partner_[h]))  // no orientation: cut there
        partner_[partner_[h]] = no_index, partner_[h] = no_index;
  }

  Vec3 normal_of(Index t) const {
    const Triangle& v = triangles_[t];
    return normalized(cross(panel_.points[v[1]] - panel_.points[v[0]], panel_.points[v[2]] - panel_.points[v[0]]));
  }

  bool is_smooth(Index h) const {
    if (partner_[h] == no_index) return false;
    const Vec3 a = normal_of(h / 3), b = normal_of(partner_[h] / 3);
    return squared_norm(a) == 0 || squared_norm(b) == 0 || angle_between(a, b) <= feature_angle_;
  }

  void split_regions() {
    region_.assign(triangles_.size(), no_index);
    for (Index seed = 0; seed < triangle_count(); ++seed) {
      if (region_[seed] != no_index) continue;
      std::vector<Index> stack{seed};
      region_[seed] = region_count_;
      while (!stack.empty()) {
        const Index t = stack.back();
        stack.pop_back();
        for (Index h = 3 * t; h < 3 * t + 3; ++h) {
          if (!is_smooth(h) || region_[partner_[h] / 3] != no_index) continue;
          region_[partner_[h] / 3] = region_count_;
          stack.push_back(partner_[h] / 3);
        }
      }
      ++region_count_;
    }
    mark_lines();
  }

  /// Half-edges that have their own region on one side only are lines; points where lines end, branch or bend are corners.
  bool is_line(Index h) const { return partner_[h] == no_index || region_[partner_[h] / 3] != region_[h / 3]; }

  void mark_lines() {
    std::map<Index, std::vector<Index>> ends;  // point -> the other ends of the lines there
    std::map<std::pair<Index, Index>, int> seen;
    for (Index h = 0; h < 3 * triangle_count(); ++h) {
      if (!is_line(h)) continue;
      const auto key = std::minmax(tail(h), head(h));
      if (seen[{key.first, key.second}]++ > 0) continue;
      ends[tail(h)].push_back(head(h));
      ends[head(h)].push_back(tail(h));
    }
    is_corner_.assign(panel_.points.size(), false);
    for (const auto& [p, others] : ends) {
      const Vec3 here = panel_.points[p];
      is_corner_[p] = others.size() != 2 ||
                      angle_between(here - panel_.points[others[0]], panel_.points[others[1]] - here) > feature_angle_;
    }
  }

  void add_face(Index r) {
    Panel piece;  // of this region alone, to borrow the tracing of composite faces
    piece.points = panel_.points;
    PanelFace face;
    fill_facets(r, face.facets);
    face.number = r + 1;
    const Index id = static_cast<Index>(panel_.faces.size());
    face.facets.triangle_face.assign(face.facets.triangles.size(), id);
    for (std::vector<Index>& loop : face.facets.loops) face.loops.push_back(edges_of(loop, face.facets, id));
    panel_.faces.push_back(std::move(face));
  }

  const double feature_angle_;
  Panel panel_;
  std::vector<Triangle> triangles_;
  std::vector<Index> partner_, region_, turned_;
  std::vector<bool> is_corner_;
  Index region_count_ = 0;
};

}  // namespace
}  // namespace beadmesh
