// Brute force on purpose: shares nothing with the code that it checks.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "beadmesh/medial/medial_object.h"

namespace beadmesh {
namespace {

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 along = b - a;
  const double square = squared_norm(along);
  const double t = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
  return distance(p, a + along * t);
}

const PlanarCurve* curve_of(const PlanarRegion& region, const PlanarLoop& loop, std::size_t i) {
  return loop.curve.empty() || loop.curve[i] == no_index ? nullptr : region.curves[loop.curve[i]].get();
}

/// Scan and golden section.
double distance_to_curve(Vec2 p, const PlanarCurve& curve, double from, double to) {
  constexpr int scanned = 8, halvings = 70;
  const double golden = (std::sqrt(5.0) - 1) / 2, step = (to - from) / scanned;
  const auto at = [&](double t) { return distance(p, curve.at(t).point); };
  int nearest = 0;
  for (int k = 1; k <= scanned; ++k)
    if (at(from + k * step) < at(from + nearest * step)) nearest = k;
  double low = from + std::max(0, nearest - 1) * step, high = from + std::min(scanned, nearest + 1) * step;
  for (int k = 0; k < halvings; ++k) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (at(a) < at(b) ? high : low) = at(a) < at(b) ? b : a;
  }
  return std::min({at((low + high) / 2), at(from), at(to)});
}

double distance_to_boundary(Vec2 p, const PlanarRegion& region) {
  double least = std::numeric_limits<double>::infinity();
  for (const PlanarLoop& loop : region.loops)
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const Vec2 a = loop.points[i], b = loop.points[(i + 1) % loop.points.size()];
      const double chord = distance_to_segment(p, a, b);
      const PlanarCurve* curve = curve_of(region, loop, i);
      if (!curve)
        least = std::min(least, chord);
      else if (chord - distance(a, b) < least)
        least = std::min(least, distance_to_curve(p, *curve, loop.parameters[i][0], loop.parameters[i][1]));
    }
  return least;
}

/// The point of a loop at an arc length of its polyline: on the exact curve where there is one.
Vec2 point_of_loop(const PlanarRegion& region, const PlanarLoop& loop, double position) {
  const std::size_t n = loop.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = loop.points[i], b = loop.points[(i + 1) % n];
    const double length = distance(a, b);
    if (position <= length) {
      const double part = length > 0 ? position / length : 0;
      const PlanarCurve* curve = curve_of(region, loop, i);
      if (!curve) return lerp(a, b, part);
      return curve->at(loop.parameters[i][0] * (1 - part) + loop.parameters[i][1] * part).point;
    }
    position -= length;
  }
  return loop.points[0];
}

class Verifier {
 public:
  Verifier(const MedialObject& object, const PlanarRegion& region, double tolerance)
      : object_(object), region_(region), tolerance_(tolerance) {}

  std::vector<std::string> run() {
    if (check_indices()) {
      check_topology();
      for (std::size_t v = 0; v < object_.vertices.size(); ++v) check_vertex(v);
      for (std::size_t e = 0; e < object_.edges.size(); ++e) check_edge(e);
    }
    return std::move(violations_);
  }

 private:
  using V = MedialVertexType;

  void note(std::string what) { violations_.push_back(std::move(what)); }
  static std::string named(const char* what, std::size_t i) {
    return std::string(what) + " " + std::to_string(i);
  }

  bool check_indices() {
    const auto valid = [](Index i, std::size_t n) { return i >= 0 && i < static_cast<Index>(n); };
    for (std::size_t e = 0; e < object_.edges.size(); ++e) {
      const MedialEdge& edge = object_.edges[e];
      const bool closed = edge.type == MedialEdgeType::N;
      if (closed ? edge.start != no_index || edge.end != no_index
                 : !valid(edge.start, object_.vertices.size()) || !valid(edge.end, object_.vertices.size()))
        note(named("edge", e) + ": bad end vertices");
      if (edge.points.size() < (closed ? 3u : 2u)) note(named("edge", e) + ": too few points");
    }
    for (std::size_t v = 0; v < object_.vertices.size(); ++v)
      for (const Index e : object_.vertices[v].edges)
        if (!valid(e, object_.edges.size())) note(named("vertex", v) + ": bad edge");
    return violations_.empty();
  }

  void check_topology() {
    std::vector<Index> piece(object_.vertices.size());
    std::iota(piece.begin(), piece.end(), 0);
    const auto find = [&](Index v) {
      while (piece[v] != v) v = piece[v] = piece[piece[v]];
      return v;
    };
    Index pieces = static_cast<Index>(piece.size()), closed = 0;
    for (const MedialEdge& edge : object_.edges) {
      if (edge.type == MedialEdgeType::N) {
        ++closed;
      } else if (const Index a = find(edge.start), b = find(edge.end); a != b) {
        piece[a] = b;
        --pieces;
      }
    }
    // A closed edge counts as one edge and one vertex, and as a piece.
    const auto edges = static_cast<Index>(object_.edges.size()) - closed;
    const auto vertices = static_cast<Index>(object_.vertices.size());
    const auto holes = static_cast<Index>(region_.loops.size()) - 1;
    pieces += closed;
    if (pieces != 1) note("the axis has " + std::to_string(pieces) + " pieces");
    if (edges - vertices + pieces != holes)
      note("E - V + pieces is " + std::to_string(edges - vertices + pieces) + ", but there are " +
           std::to_string(holes) + " holes");
    if (closed > 0 && holes != 1) note("a closed edge needs exactly two loops");
    if (object_.loops != static_cast<Index>(region_.loops.size())) note("wrong number of loops");
  }

  void check_vertex(std::size_t v) {
    const MedialVertex& vertex = object_.vertices[v];
    const std::size_t degree = vertex.edges.size();
    const bool fits = vertex.type == V::J          ? degree >= 3
                      : vertex.type == V::isolated ? degree == 0
                                                   : degree == 1;
    if (!fits)
      note(named("vertex", v) + ": type " + name_of(vertex.type) + " with " + std::to_string(degree) +
           " edges");
    for (const Index e : vertex.edges) {
      const MedialEdge& edge = object_.edges[e];
      if (edge.start != static_cast<Index>(v) && edge.end != static_cast<Index>(v))
        note(named("vertex", v) + ": its edge " + std::to_string(e) + " does not end there");
    }
    check_disc(named("vertex", v), vertex.point, vertex.radius, vertex.touching_points.data(),
               vertex.touching_points.size(), !vertex.merged);
    if (vertex.type == V::C && vertex.radius != 0) note(named("vertex", v) + ": a corner with a radius");
    if (vertex.touching_points.size() < (vertex.type == V::C ? 1u : 3u))
      note(named("vertex", v) + ": too few touching points");
  }

  void check_edge(std::size_t e) {
    const MedialEdge& edge = object_.edges[e];
    const std::string name = named("edge", e);
    double length = 0;
    for (std::size_t i = 0; i < edge.points.size(); ++i) {
      const MedialPoint& point = edge.points[i];
      const bool inner = edge.type == MedialEdgeType::N || (i > 0 && i + 1 < edge.points.size());
      check_disc(name + ", point " + std::to_string(i), point.point, point.radius, point.feet.data(), 2,
                 inner);
      if (i > 0) length += distance(edge.points[i - 1].point, point.point);
      if (inner) check_sides(name + ", point " + std::to_string(i), edge, i);
    }
    if (edge.type == MedialEdgeType::N)
      length += distance(edge.points.back().point, edge.points.front().point);
    if (std::abs(length - edge.length) > 1e-9 * object_.size) note(name + ": wrong length");
    const Thickness& thickness = edge.thickness;
    if (!(thickness.min <= thickness.mean * (1 + 1e-12) && thickness.mean <= thickness.max * (1 + 1e-12)))
      note(name + ": thickness is not min <= mean <= max");
    if (edge.type != MedialEdgeType::N) check_ends(name, edge, static_cast<Index>(e));
  }

  void check_ends(const std::string& name, const MedialEdge& edge, Index e) {
    const MedialVertex &start = object_.vertices[edge.start], &end = object_.vertices[edge.end];
    if (!(edge.points.front().point == start.point && edge.points.back().point == end.point))
      note(name + ": does not run from its start to its end");
    std::string ends{name_of(start.type)[0], '-', name_of(end.type)[0]};
    std::string other(ends.rbegin(), ends.rend());
    if (name_of(edge.type) != ends && name_of(edge.type) != other)
      note(name + ": type " + name_of(edge.type) + " between " + ends);
    const auto count = [&](const MedialVertex& vertex) {
      return std::count(vertex.edges.begin(), vertex.edges.end(), e);
    };
    const auto wanted = edge.start == edge.end ? 2 : 1;
    if (count(start) != wanted || count(end) != wanted) note(name + ": is not listed by its vertices");
  }

  /// The left foot lies left of the edge, the right one right.
  void check_sides(const std::string& name, const MedialEdge& edge, std::size_t i) {
    const std::size_t n = edge.points.size();
    const Vec2 along = edge.points[(i + 1) % n].point - edge.points[(i + n - 1) % n].point;
    const MedialPoint& point = edge.points[i];
    const Vec2 across = point.feet[0].point - point.feet[1].point;
    if (cross(along, across) < 0) note(name + ": feet on the wrong sides");
  }

  void check_disc(const std::string& name, Vec2 centre, double radius, const Foot* feet, std::size_t count,
                  bool touches_all) {
    if (!std::isfinite(centre.x) || !std::isfinite(centre.y) || !(radius >= 0))
      return note(name + ": not finite");
    if (radius > tolerance_ && !contains(region_, centre)) note(name + ": outside the region");
    const double free = distance_to_boundary(centre, region_);
    if (std::abs(free - radius) > tolerance_)
      note(name + ": radius " + std::to_string(radius) + ", distance to the boundary " +
           std::to_string(free));
    for (std::size_t i = 0; i < count; ++i) {
      const Foot& foot = feet[i];
      if (foot.loop < 0 || foot.loop >= static_cast<Index>(region_.loops.size())) {
        note(name + ": foot on no loop");
        continue;
      }
      const Vec2 there = point_of_loop(region_, region_.loops[foot.loop], foot.position);
      if (distance(there, foot.point) > std::max(tolerance_, 1e-9 * object_.size))
        note(name + ": foot is not at its position");
      const double reach = distance(foot.point, centre);
      if (reach < radius - tolerance_ || (touches_all && reach > radius + tolerance_))
        note(name + ": foot at a distance of " + std::to_string(reach) + " from the centre, radius " +
             std::to_string(radius));
    }
  }

  const MedialObject& object_;
  const PlanarRegion& region_;
  double tolerance_;
  std::vector<std::string> violations_;
};

}  // namespace

std::vector<std::string> verify_medial_object(const MedialObject& object, const PlanarRegion& region,
                                              double tolerance) {
  return Verifier(object, region, tolerance).run();
}

}  // namespace beadmesh
