// SurfaceMap: point location in the flat image and the way back to the surface.
#include <algorithm>
#include <limits>

#include "beadmesh/flatten/facet_search.h"
#include "beadmesh/flatten/flat_face.h"
#include "beadmesh/flatten/triangle_geometry.h"
#include "beadmesh/flatten/triangle_topology.h"
#include "beadmesh/geometry/segment_search.h"

namespace beadmesh {
namespace {

constexpr int max_walk = 64;          // a longer walk costs more than the grid
constexpr double edge_slack = 1e-12;  // barycentric; a point on an edge belongs to either side
constexpr double crack_slack = 1e-6;  // the same, for a point that rounding has put between two triangles
constexpr double degenerate = 1e-12;  // doubled area over squared longest edge

/// Area-weighted normals of the vertices.
std::vector<Vec3> vertex_normals(const Facets& facets) {
  std::vector<Vec3> normals(facets.points.size());
  for (const Triangle& t : facets.triangles) {
    const Vec3 a = facets.points[t[0]];
    const Vec3 vector = cross(facets.points[t[1]] - a, facets.points[t[2]] - a);
    for (const Index v : t) normals[v] += vector;
  }
  for (Vec3& n : normals) n = normalized(n);
  return normals;
}

template <class V>
V blend(V a, V b, V c, const FacetPoint& at) {
  return a * at.weight[0] + b * at.weight[1] + c * at.weight[2];
}

FacetPoint facet_point_of(Index triangle, const std::array<double, 3>& weight) {
  FacetPoint at;
  at.triangle = triangle;
  std::copy(weight.begin(), weight.end(), at.weight);
  return at;
}

}  // namespace

/// A triangle as point location wants it: all in one place.
struct FlatTriangle {
  Vec2 a, b, c;
  double area = 0;  ///< doubled; 0: too thin to hold anything
};

/// Uniform cells over the flat image; each lists the triangles whose bounding boxes touch it, ascending.
struct SurfaceMap::Grid {
  const Facets& facets;
  const std::vector<Vec2>& flat;
  TriangleNeighbours neighbours;
  std::vector<std::pair<Index, int>> boundary_sides;  ///< (triangle, side)
  SegmentSearch boundary;                             ///< over boundary_sides
  std::vector<Vec3> normals;
  std::vector<FlatTriangle> triangles;
  Vec2 low;
  double cell = 1;
  Index columns = 1, rows = 1;
  std::vector<Index> begin, items;  ///< cell i lists items[begin[i] .. begin[i + 1])

  Grid(const Facets& of, const std::vector<Vec2>& positions)
      : facets(of),
        flat(positions),
        neighbours(triangle_neighbours(of.triangles)),
        boundary_sides(sides_without_neighbour(neighbours)),
        boundary(boundary_segments()),
        normals(vertex_normals(of)) {
    for (const Triangle& t : facets.triangles) triangles.push_back(flat_triangle(t));
    lay_out();
    fill();
  }

  void lay_out() {
    if (flat.empty()) return;
    Vec2 high = low = flat[0];
    for (const Vec2 p : flat) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double width = high.x - low.x, height = high.y - low.y;
    const double count = 1 + static_cast<double>(facets.triangles.size());
    cell = std::max(std::sqrt(width * height / count), std::max(width, height) / count);
    if (!(cell > 0)) cell = 1;
    columns = 1 + static_cast<Index>(width / cell);
    rows = 1 + static_cast<Index>(height / cell);
  }

  Index column_of(double x) const {
    return static_cast<Index>(std::clamp((x - low.x) / cell, 0.0, static_cast<double>(columns - 1)));
  }
  Index row_of(double y) const {
    return static_cast<Index>(std::clamp((y - low.y) / cell, 0.0, static_cast<double>(rows - 1)));
  }

  /// Row by row, so that a long thin triangle is listed only where it runs; a little wider, so that rounding
  /// at the border of a cell loses none.
  template <class Visit>
  void for_each_cell(const Triangle& t, Visit visit) const {
    const Vec2 a = flat[t[0]], b = flat[t[1]], c = flat[t[2]];
    const double margin = 1e-9 * cell;
    const Index bottom = row_of(std::min({a.y, b.y, c.y}) - margin),
                top = row_of(std::max({a.y, b.y, c.y}) + margin);
    for (Index r = bottom; r <= top; ++r) {
      double left = std::numeric_limits<double>::infinity(), right = -left;
      for (const auto& [p, q] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
        widen(p, q, low.y + r * cell - margin, low.y + (r + 1) * cell + margin, left, right);
      const Index last = column_of(right + margin);
      for (Index k = column_of(left - margin); k <= last; ++k) visit(r * columns + k);
    }
  }

  /// Widens [left, right] by the part of segment pq between heights `bottom` and `top`.
  static void widen(Vec2 p, Vec2 q, double bottom, double top, double& left, double& right) {
    if (p.y > q.y) std::swap(p, q);
    if (q.y < bottom || p.y > top) return;
    const double rise = q.y - p.y;
    const double from = p.y < bottom ? (bottom - p.y) / rise : 0, to = q.y > top ? (top - p.y) / rise : 1;
    for (const double x : {p.x + (q.x - p.x) * from, p.x + (q.x - p.x) * to}) {
      left = std::min(left, x);
      right = std::max(right, x);
    }
  }

  void fill() {
    begin.assign(static_cast<std::size_t>(columns) * rows + 1, 0);
    for (const Triangle& t : facets.triangles) for_each_cell(t, [&](Index i) { ++begin[i + 1]; });
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    items.resize(begin.back());
    std::vector<Index> next(begin.begin(), begin.end() - 1);
    for (Index t = 0; t < static_cast<Index>(facets.triangles.size()); ++t)
      for_each_cell(facets.triangles[t], [&](Index i) { items[next[i]++] = t; });
  }

  FlatTriangle flat_triangle(const Triangle& v) const {
    FlatTriangle t{flat[v[0]], flat[v[1]], flat[v[2]], 0};
    const double area = cross(t.b - t.a, t.c - t.a);
    const double longest =
        std::max({squared_norm(t.b - t.a), squared_norm(t.c - t.b), squared_norm(t.a - t.c)});
    if (area > degenerate * longest) t.area = area;
    return t;
  }

  /// Barycentric weights times the doubled area, which is returned; not positive: the triangle holds nothing.
  double scaled_weights(Index t, Vec2 p, std::array<double, 3>& weight) const {
    const auto& [a, b, c, area] = triangles[t];
    weight = {cross(c - b, p - b), cross(a - c, p - c), cross(b - a, p - a)};
    return area;
  }

  /// Does t hold p? Fills `at`.
  bool holds(Index t, Vec2 p, double slack, FacetPoint& at) const {
    std::array<double, 3> weight;
    const double area = scaled_weights(t, p, weight);
    if (area <= 0 || std::min({weight[0], weight[1], weight[2]}) < -slack * area) return false;
    at = clamped(t, weight);
    return true;
  }

  static FacetPoint clamped(Index t, std::array<double, 3> weight) {
    double sum = 0;
    for (double& w : weight) sum += w = std::max(w, 0.0);
    return facet_point_of(t, {weight[0] / sum, weight[1] / sum, weight[2] / sum});
  }

  /// Straight to p from triangle t across the edge p lies furthest beyond. False: the walk left the piece,
  /// ran long or met a degenerate triangle.
  bool walk(Index t, Vec2 p, FacetPoint& at) const {
    for (int step = 0; step < max_walk && t != no_index; ++step) {
      std::array<double, 3> weight;
      const double area = scaled_weights(t, p, weight);
      if (!(area > 0)) return false;
      const int least =
          weight[0] <= weight[1] ? (weight[0] <= weight[2] ? 0 : 2) : (weight[1] <= weight[2] ? 1 : 2);
      if (!(weight[least] < -edge_slack * area)) {
        at = clamped(t, weight);
        return true;
      }
      t = neighbours[t][(least + 1) % 3];  // the edge opposite to corner `least`
    }
    return false;
  }

  /// Outside, the nearest point lies on the boundary.
  FacetPoint search(Vec2 p) const {
    FacetPoint at;
    const Index home = row_of(p.y) * columns + column_of(p.x);
    for (Index i = begin[home]; i < begin[home + 1]; ++i)
      if (holds(items[i], p, edge_slack, at)) return at;
    for (Index i = begin[home]; i < begin[home + 1]; ++i)
      if (holds(items[i], p, crack_slack, at)) return at;
    const NearestOnSegments near = boundary.nearest(p);
    if (near.segment == no_index) return at;
    const auto [t, k] = boundary_sides[near.segment];
    std::array<double, 3> weight{0, 0, 0};
    weight[k] = 1 - near.t;
    weight[(k + 1) % 3] = near.t;
    return facet_point_of(t, weight);
  }

  static std::vector<std::pair<Index, int>> sides_without_neighbour(const TriangleNeighbours& neighbours) {
    std::vector<std::pair<Index, int>> sides;
    for (Index t = 0; t < static_cast<Index>(neighbours.size()); ++t)
      for (int k = 0; k < 3; ++k)
        if (neighbours[t][k] == no_index) sides.push_back({t, k});
    return sides;
  }

  std::vector<std::array<Vec2, 2>> boundary_segments() const {
    std::vector<std::array<Vec2, 2>> segments;
    for (const auto& [t, k] : boundary_sides) {
      const Triangle& v = facets.triangles[t];
      segments.push_back({flat[v[k]], flat[v[(k + 1) % 3]]});
    }
    return segments;
  }
};

SurfaceMap::SurfaceMap(const Facets& facets, const FlatFace& flat)
    : facets_(&facets), flat_(&flat), grid_(std::make_unique<Grid>(facets, flat.positions)) {}
SurfaceMap::~SurfaceMap() = default;
SurfaceMap::SurfaceMap(SurfaceMap&&) noexcept = default;

FacetPoint SurfaceMap::locate(Vec2 flat, Index hint) const {
  FacetPoint at;
  if (facets_->triangles.empty() || !std::isfinite(flat.x) || !std::isfinite(flat.y)) return at;
  const bool has_hint = hint >= 0 && hint < static_cast<Index>(facets_->triangles.size());
  if (has_hint && grid_->walk(hint, flat, at)) return at;
  return grid_->search(flat);
}

Vec3 SurfaceMap::facet_point(const FacetPoint& at) const {
  const Triangle& t = facets_->triangles[at.triangle];
  return blend(facets_->points[t[0]], facets_->points[t[1]], facets_->points[t[2]], at);
}

Vec3 SurfaceMap::surface_point(const FacetPoint& at) const {
  const Vec3 on_facet = facet_point(at);
  const SurfaceEvaluator* surface = surface_of(at.triangle);
  if (!surface) return on_facet;
  const auto& uv = facets_->triangle_uv[at.triangle];
  const Vec3 exact = surface->point(blend(uv[0], uv[1], uv[2], at));
  // Parameters that jump within a facet (at a pole, or across a seam) lead astray: a facet is no guess that
  // bad.
  const double longest = longest_edge(rest_triangle(*facets_, at.triangle));
  return squared_norm(exact - on_facet) <= longest * longest ? exact : on_facet;
}

Vec3 SurfaceMap::normal(const FacetPoint& at) const {
  if (const SurfaceEvaluator* surface = surface_of(at.triangle)) {
    const auto& uv = facets_->triangle_uv[at.triangle];
    const Vec3 exact = surface->normal(blend(uv[0], uv[1], uv[2], at));
    if (std::isfinite(exact.x + exact.y + exact.z) && squared_norm(exact) > 0.25) return exact;
  }
  const Triangle& t = facets_->triangles[at.triangle];
  const std::vector<Vec3>& normals = grid_->normals;
  return normalized(blend(normals[t[0]], normals[t[1]], normals[t[2]], at));
}

double SurfaceMap::stretch(const FacetPoint& at, Vec2 direction) const {
  const auto& [a, b, c, area] = grid_->triangles[at.triangle];
  const Triangle& t = facets_->triangles[at.triangle];
  if (!(area > 0)) return 1;
  const double along_b = cross(direction, c - a) / area, along_c = cross(b - a, direction) / area;
  return norm((facets_->points[t[1]] - facets_->points[t[0]]) * along_b +
              (facets_->points[t[2]] - facets_->points[t[0]]) * along_c);
}

const SurfaceEvaluator* SurfaceMap::surface_of(Index triangle) const {
  if (triangle >= static_cast<Index>(facets_->triangle_uv.size()) ||
      triangle >= static_cast<Index>(facets_->triangle_surface.size()))
    return nullptr;
  const Index face = facets_->triangle_surface[triangle];
  if (face < 0 || face >= static_cast<Index>(facets_->surfaces.size())) return nullptr;
  return facets_->surfaces[face].get();
}

const Facets& SurfaceMap::facets() const {
  return *facets_;
}
const FlatFace& SurfaceMap::flat() const {
  return *flat_;
}

}  // namespace beadmesh
