#include "beadmesh/read/facet_skin.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

namespace beadmesh {
namespace {

using Corners = std::array<Vec3, 3>;
constexpr Index next_corner(Index c) {
  return c % 3 == 2 ? c - 2 : c + 1;
}

class SkinBuilder {
 public:
  explicit SkinBuilder(double feature_angle) : feature_angle_(feature_angle) {}

  Panel build(const std::vector<Corners>& facets) {
    weld(facets);
    pair_half_edges();
    orient();
    split_regions();
    std::vector<std::vector<Triangle>> regions(region_count_);
    for (Index t = 0; t < triangle_count(); ++t) regions[region_[t]].push_back(triangles_[t]);
    for (const std::vector<Triangle>& region : regions) add_face(region);
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
    const std::vector<Index> to = representatives(all, 1e-6 * diagonal(panel_));
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

  /// Per point the first one within the tolerance. Cells of that size; equal points, the common case, are
  /// found first.
  static std::vector<Index> representatives(const std::vector<Vec3>& points, double tolerance) {
    using Cell = std::array<std::int64_t, 3>;
    double reach = 1e-300;
    for (const Vec3 p : points) reach = std::max({reach, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    const double size = std::max(tolerance, 1e-15 * reach);  // cells must stay countable
    std::map<std::array<double, 3>, Index> exact;
    std::map<Cell, Index> cells;
    std::vector<Index> result;
    for (Index i = 0; i < static_cast<Index>(points.size()); ++i) {
      const Vec3 p = points[i];
      const auto [found, is_new] = exact.try_emplace({p.x, p.y, p.z}, i);
      if (is_new) {
        const auto part = [&](double x) { return static_cast<std::int64_t>(std::floor(x / size)); };
        const Cell at{part(p.x), part(p.y), part(p.z)};
        found->second = nearby(points, cells, at, i, tolerance);
        if (found->second == i) cells.emplace(at, i);
      }
      result.push_back(found->second);
    }
    return result;
  }

  template <class Cells, class Cell>
  static Index nearby(const std::vector<Vec3>& points, const Cells& cells, const Cell& at, Index i,
                      double tolerance) {
    for (int n = 0; n < 27; ++n) {
      const auto found = cells.find({at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1, at[2] + n / 9 - 1});
      if (found != cells.end() && distance(points[found->second], points[i]) <= tolerance)
        return found->second;
    }
    return i;
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

  /// Two half-edges on the same two points are partners, whichever way they run; three or more have no
  /// partner.
  void pair_half_edges() {
    const Index n = 3 * triangle_count();
    std::vector<Index> order(n);
    for (Index h = 0; h < n; ++h) order[h] = h;
    const auto key = [&](Index h) {
      return std::pair{std::min(tail(h), head(h)), std::max(tail(h), head(h))};
    };
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
    return norm(cross(panel_.points[v[1]] - panel_.points[v[0]], panel_.points[v[2]] - panel_.points[v[0]])) /
           2;
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
      panel_.diagnostics.push_back(
          {"read.turned_over",
           Severity::note,
           no_index,
           {},
           std::to_string(turned_.size()) + " facets were turned over to agree with their neighbours",
           {}});
    pair_half_edges();
    for (Index h = 0; h < 3 * triangle_count(); ++h)
      if (partner_[h] != no_index && tail(h) == tail(partner_[h]))  // no orientation: cut there
        partner_[partner_[h]] = no_index, partner_[h] = no_index;
  }

  Vec3 normal_of(Index t) const {
    const Triangle& v = triangles_[t];
    return normalized(
        cross(panel_.points[v[1]] - panel_.points[v[0]], panel_.points[v[2]] - panel_.points[v[0]]));
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

  /// Half-edges that have their own region on one side only are lines; points where lines end, branch or bend
  /// are corners.
  bool is_line(Index h) const {
    return partner_[h] == no_index || region_[partner_[h] / 3] != region_[h / 3];
  }

  void mark_lines() {
    std::map<Index, std::vector<Index>> ends;  // point -> the other ends of the lines there
    std::map<std::pair<Index, Index>, int> seen;
    for (Index h = 0; h < 3 * triangle_count(); ++h) {
      if (!is_line(h)) continue;
      const auto key = std::minmax({tail(h), head(h)});
      if (seen[std::pair{key.first, key.second}]++ > 0) continue;
      ends[tail(h)].push_back(head(h));
      ends[head(h)].push_back(tail(h));
    }
    is_corner_.assign(panel_.points.size(), false);
    for (const auto& [p, others] : ends) {
      const Vec3 here = panel_.points[p];
      is_corner_[p] = others.size() != 2 || angle_between(here - panel_.points[others[0]],
                                                          panel_.points[others[1]] - here) > feature_angle_;
    }
  }

  void add_face(const std::vector<Triangle>& triangles) {
    PanelFace face;
    face.facets = facets_of_triangles(panel_.points, triangles);
    const Index id = static_cast<Index>(panel_.faces.size());
    face.number = id + 1;
    face.facets.triangle_surface.assign(triangles.size(), 0);
    for (std::vector<Index>& loop : face.facets.loops) face.loops.push_back(edges_of(loop, face.facets, id));
    panel_.faces.push_back(std::move(face));
  }

  /// Turns the loop to begin at a corner (or else at its smallest point, so that both its faces begin alike)
  /// and cuts it.
  std::vector<EdgeUse> edges_of(std::vector<Index>& loop, const Facets& facets, Index face) {
    const auto point = [&](Index v) { return facets.panel_points[v]; };
    auto start = std::find_if(loop.begin(), loop.end(), [&](Index v) { return is_corner_[point(v)]; });
    if (start == loop.end())
      start =
          std::min_element(loop.begin(), loop.end(), [&](Index a, Index b) { return point(a) < point(b); });
    std::rotate(loop.begin(), start, loop.end());
    std::vector<EdgeUse> uses;
    std::vector<Index> run{point(loop.front())};
    for (std::size_t i = 1; i <= loop.size(); ++i) {
      run.push_back(point(loop[i % loop.size()]));
      if (i < loop.size() && !is_corner_[run.back()]) continue;
      uses.push_back(edge_along(run, face));
      run = {run.back()};
    }
    return uses;
  }

  EdgeUse edge_along(const std::vector<Index>& run, Index face) {
    const std::pair<Index, Index> first{run[0], run[1]}, last{run.back(), run[run.size() - 2]};
    auto found = edge_from_.find(first);
    if (found == edge_from_.end()) {
      const Index e = static_cast<Index>(panel_.edges.size());
      PanelEdge edge;
      edge.points = run;
      panel_.edges.push_back(std::move(edge));
      edge_from_[last] = {e, true};
      found = edge_from_.insert_or_assign(first, EdgeUse{e, false}).first;
    }
    panel_.edges[found->second.edge].faces.push_back(face);
    return found->second;
  }

  const double feature_angle_;
  Panel panel_;
  std::vector<Triangle> triangles_;
  std::vector<Index> partner_, region_, turned_;
  std::vector<bool> is_corner_;
  std::map<std::pair<Index, Index>, EdgeUse> edge_from_;  // first segment -> the edge that begins with it
  Index region_count_ = 0;
};

}  // namespace

Panel panel_of_facets(const std::vector<std::array<Vec3, 3>>& facets, double feature_angle) {
  return SkinBuilder(feature_angle).build(facets);
}

}  // namespace beadmesh
