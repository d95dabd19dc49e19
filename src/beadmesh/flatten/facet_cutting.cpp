#include "beadmesh/flatten/facet_cutting.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace beadmesh {
namespace {

using Side = std::pair<Index, Index>;

Side side(Index a, Index b) {
  return std::minmax(a, b);
}

/// Representatives of corners that are one vertex.
class Unions {
 public:
  explicit Unions(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(Index a, Index b) {
    a = find(a), b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<Index> parent_;
};

/// Facets of the given triangles over vertices with points and origins; what else a triangle or a vertex
/// knows comes along.
CutFacets traced(const Facets& all, const std::vector<Index>& origin) {
  CutFacets result;
  result.facets = facets_of_triangles(all.points, all.triangles);
  for (Index& p : result.facets.panel_points) {
    result.origin.push_back(origin[p]);
    p = all.panel_points[p];
  }
  result.facets.triangle_uv = all.triangle_uv;
  result.facets.triangle_surface = all.triangle_surface;
  result.facets.surfaces = all.surfaces;
  return result;
}

class Cutter {
 public:
  Cutter(const CutFacets& piece, const std::vector<PathStop>& way) : piece_(piece), way_(way) {}

  /// Nothing where the way crosses a triangle twice.
  bool run(CutFacets& result) {
    work_ = piece_.facets;
    work_.triangles.clear(), work_.triangle_uv.clear(), work_.triangle_surface.clear();
    origin_ = piece_.origin;
    add_points();
    if (!collect_crossings()) return false;
    for (Index t = 0; t < static_cast<Index>(piece_.facets.triangles.size()); ++t) add_triangle(t);
    part_vertices();
    result = traced(work_, origin_);
    return true;
  }

 private:
  void add_points() {
    Index next_origin = 0;
    for (const Index o : origin_) next_origin = std::max(next_origin, o + 1);
    for (const PathStop& stop : way_) {
      if (stop.is_vertex()) {
        vertex_.push_back(stop.from);
        continue;
      }
      vertex_.push_back(static_cast<Index>(work_.points.size()));
      work_.points.push_back(lerp(work_.points[stop.from], work_.points[stop.to], stop.at));
      work_.panel_points.push_back(no_index);
      origin_.push_back(next_origin++);
    }
    for (std::size_t i = 0; i + 1 < vertex_.size(); ++i) cuts_.insert(side(vertex_[i], vertex_[i + 1]));
  }

  /// Which triangle is crossed by which step of the way.
  bool collect_crossings() {
    std::map<Side, std::vector<Index>> at_edge;
    const auto& triangles = piece_.facets.triangles;
    for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t)
      for (int k = 0; k < 3; ++k) at_edge[side(triangles[t][k], triangles[t][(k + 1) % 3])].push_back(t);
    crossing_.assign(triangles.size(), no_index);
    for (std::size_t i = 0; i + 1 < way_.size(); ++i) {
      const bool ends = way_[i].is_vertex() && way_[i + 1].is_vertex();
      if (ends) continue;  // along an edge
      const PathStop& on_edge = way_[i].is_vertex() ? way_[i + 1] : way_[i];
      const PathStop& other = way_[i].is_vertex() ? way_[i] : way_[i + 1];
      for (const Index t : at_edge[side(on_edge.from, on_edge.to)]) {
        if (!has(triangles[t], other.from) || !has(triangles[t], other.to)) continue;
        if (crossing_[t] != no_index) return false;
        crossing_[t] = static_cast<Index>(i);
      }
    }
    return true;
  }

  static bool has(const Triangle& t, Index v) { return t[0] == v || t[1] == v || t[2] == v; }

  /// A corner of a triangle or a point on its side, with its parameters.
  struct Corner {
    Index vertex;
    Vec2 uv;
  };

  /// The corners and stops around a triangle, split along the step between two of them.
  void add_triangle(Index t) {
    const Triangle& v = piece_.facets.triangles[t];
    const Index step = crossing_[t];
    std::vector<Corner> around;
    std::vector<std::size_t> ends;
    for (int k = 0; k < 3; ++k) {
      const Index a = v[k], b = v[(k + 1) % 3];
      const Vec2 uv_a = uv(t, k), uv_b = uv(t, (k + 1) % 3);
      if (step != no_index && is_stop(step, a)) ends.push_back(around.size());
      around.push_back({a, uv_a});
      for (int s = 0; step != no_index && s < 2; ++s) {
        const PathStop& stop = way_[step + s];
        if (stop.is_vertex() || side(a, b) != side(stop.from, stop.to)) continue;
        ends.push_back(around.size());
        around.push_back({vertex_[step + s], lerp(uv_a, uv_b, stop.from == a ? stop.at : 1 - stop.at)});
      }
    }
    if (step == no_index) return add_polygon(t, around);
    std::vector<Corner> one(around.begin() + ends[0], around.begin() + ends[1] + 1), other;
    for (std::size_t i = ends[1]; i != ends[0] + 1; i = (i + 1) % around.size()) other.push_back(around[i]);
    add_polygon(t, one);
    add_polygon(t, other);
  }

  bool is_stop(Index step, Index vertex) const {
    return (way_[step].is_vertex() && way_[step].from == vertex) ||
           (way_[step + 1].is_vertex() && way_[step + 1].from == vertex);
  }

  Vec2 uv(Index t, int k) const {
    return piece_.facets.triangle_uv.empty() ? Vec2{} : piece_.facets.triangle_uv[t][k];
  }

  /// A triangle, or a quadrangle by its shorter diagonal.
  void add_polygon(Index t, const std::vector<Corner>& polygon) {
    if (polygon.size() == 3) return add_part(t, polygon[0], polygon[1], polygon[2]);
    const auto length = [&](int a, int b) {
      return distance(work_.points[polygon[a].vertex], work_.points[polygon[b].vertex]);
    };
    const int shift = length(0, 2) <= length(1, 3) ? 0 : 1;
    const auto corner = [&](int k) { return polygon[(k + shift) % 4]; };
    add_part(t, corner(0), corner(1), corner(2));
    add_part(t, corner(0), corner(2), corner(3));
  }

  void add_part(Index t, const Corner& a, const Corner& b, const Corner& c) {
    work_.triangles.push_back({a.vertex, b.vertex, c.vertex});
    if (!piece_.facets.triangle_uv.empty()) work_.triangle_uv.push_back({a.uv, b.uv, c.uv});
    if (!piece_.facets.triangle_surface.empty())
      work_.triangle_surface.push_back(piece_.facets.triangle_surface[t]);
  }

  /// Corners of triangles that meet over a side that is not cut are one vertex; nothing else is.
  void part_vertices() {
    std::map<Side, std::vector<Index>> at_side;  // half-edges 3 t + k
    for (std::size_t t = 0; t < work_.triangles.size(); ++t)
      for (int k = 0; k < 3; ++k)
        at_side[side(work_.triangles[t][k], work_.triangles[t][(k + 1) % 3])].push_back(
            static_cast<Index>(3 * t + k));
    Unions corners(3 * work_.triangles.size());
    for (const auto& [ends, halves] : at_side) {
      if (halves.size() != 2 || cuts_.contains(ends)) continue;
      const auto next = [](Index c) { return c % 3 == 2 ? c - 2 : c + 1; };
      corners.join(halves[0], next(halves[1]));
      corners.join(next(halves[0]), halves[1]);
    }
    Facets parted = work_;
    parted.points.clear(), parted.panel_points.clear();
    std::vector<Index> origin, number(3 * work_.triangles.size(), no_index);
    for (Index c = 0; c < static_cast<Index>(number.size()); ++c) {
      const Index root = corners.find(c), old = work_.triangles[c / 3][c % 3];
      if (number[root] == no_index) {
        number[root] = static_cast<Index>(parted.points.size());
        parted.points.push_back(work_.points[old]);
        parted.panel_points.push_back(work_.panel_points[old]);
        origin.push_back(origin_[old]);
      }
      parted.triangles[c / 3][c % 3] = number[root];
    }
    work_ = std::move(parted);
    origin_ = std::move(origin);
  }

  const CutFacets& piece_;
  const std::vector<PathStop>& way_;
  Facets work_;
  std::vector<Index> origin_;
  std::vector<Index> vertex_;    // per stop
  std::set<Side> cuts_;          // sides along the way
  std::vector<Index> crossing_;  // per triangle: the step that crosses it
};

}  // namespace

bool cut_along(CutFacets& piece, const std::vector<PathStop>& way) {
  CutFacets result;
  if (way.size() < 2 || !Cutter(piece, way).run(result)) return false;
  piece = std::move(result);
  return true;
}

std::vector<std::vector<bool>> cut_sides(const std::vector<std::vector<Index>>& loops,
                                         const std::vector<Index>& origin) {
  std::set<Side> runs;
  const auto run = [&](const std::vector<Index>& loop, std::size_t i) {
    return Side{origin[loop[i]], origin[loop[(i + 1) % loop.size()]]};
  };
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) runs.insert(run(loop, i));
  std::vector<std::vector<bool>> sides;
  for (const auto& loop : loops) {
    std::vector<bool>& of_loop = sides.emplace_back();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const auto [a, b] = run(loop, i);
      of_loop.push_back(a != b && runs.contains({b, a}));
    }
  }
  return sides;
}

CutFacets sewn(const Facets& facets, const std::vector<Index>& origin) {
  std::map<Index, Index> first;  // vertex of each origin
  Facets joined = facets;
  for (Index v = 0; v < static_cast<Index>(origin.size()); ++v) first.try_emplace(origin[v], v);
  for (Triangle& t : joined.triangles)
    for (Index& v : t) v = first[origin[v]];
  return traced(joined, origin);
}

}  // namespace beadmesh
