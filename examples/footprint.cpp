#include "examples/footprint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace beadmesh::examples {
namespace {

Vec2 unit(double angle) {
  return {std::cos(angle), std::sin(angle)};
}
Vec2 turned(Vec2 p, double angle) {
  const Vec2 u = unit(angle);
  return {u.x * p.x - u.y * p.y, u.y * p.x + u.x * p.y};
}

double edge_distance(const PlanEdge& edge, Vec2 p) {
  if (!edge.is_arc()) {
    const Vec2 along = edge.end - edge.start;
    const double t = std::clamp(dot(p - edge.start, along) / squared_norm(along), 0.0, 1.0);
    return distance(p, edge.start + along * t);
  }
  const Vec2 arm = p - edge.centre;
  double turn = std::atan2(arm.y, arm.x) - edge.start_angle;
  turn = edge.sweep > 0 ? turn - 2 * pi * std::floor(turn / (2 * pi))
                        : turn - 2 * pi * std::ceil(turn / (2 * pi));
  if (std::abs(turn) <= std::abs(edge.sweep)) return std::abs(norm(arm) - edge.radius);
  return std::min(distance(p, edge.start), distance(p, edge.end));
}

/// The middle of the bounding box of a loop.
Vec2 middle(const PlanLoop& loop) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Vec2 low{inf, inf}, high{-inf, -inf};
  for (const Vec2 p : sampled(loop)) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return (low + high) / 2;
}

void set_centrelines(Footprint& footprint, std::vector<PlanLoop> chains) {
  footprint.centrelines = std::move(chains);
  for (const PlanLoop& chain : footprint.centrelines)
    for (const PlanEdge& edge : chain) footprint.centreline_length += edge.length();
}

double signed_area(const PlanLoop& loop) {
  const std::vector<Vec2> points = sampled(loop);
  double twice = 0;
  for (std::size_t i = 0; i < points.size(); ++i) twice += cross(points[i], points[(i + 1) % points.size()]);
  return twice / 2;
}

/// The path's edges shifted to the left by `offset`.
PlanLoop offset_path(const std::vector<PathStep>& path, double offset) {
  PlanLoop edges;
  Vec2 at;
  double heading = 0;
  for (const PathStep& step : path) {
    if (step.turn == 0) {
      const Vec2 shift = left_normal(unit(heading)) * offset, next = at + unit(heading) * step.length;
      edges.push_back(line(at + shift, next + shift));
      at = next;
      continue;
    }
    const double side = step.turn > 0 ? 1 : -1;
    const Vec2 centre = at + left_normal(unit(heading)) * (side * step.radius);
    const double start_angle = heading - side * pi / 2;
    edges.push_back(arc(centre, step.radius - side * offset, start_angle, step.turn));
    at = centre + unit(start_angle + step.turn) * step.radius;
    heading += step.turn;
  }
  return edges;
}

/// A corner of a network's outline, between two neighbouring arms at a node.
struct Corner {
  Vec2 at;
  double radius;
};

class NetworkOutline {
 public:
  NetworkOutline(const std::vector<Vec2>& nodes, const std::vector<std::pair<int, int>>& arms, double width,
                 double fillet)
      : nodes_(nodes), neighbours_(nodes.size()), half_(width / 2), fillet_(fillet) {
    for (const auto& [a, b] : arms) {
      neighbours_[a].push_back(b);
      neighbours_[b].push_back(a);
    }
    for (int node = 0; node < int(nodes.size()); ++node) sort_by_angle(node);
  }

  /// Walks around every face of the arms' plane graph; the outline lies to the right of each arm.
  std::vector<PlanLoop> loops() {
    std::vector<std::pair<int, int>> done;
    std::vector<PlanLoop> result;
    for (int a = 0; a < int(nodes_.size()); ++a)
      for (const int b : neighbours_[a])
        if (std::find(done.begin(), done.end(), std::pair(a, b)) == done.end())
          result.push_back(walk(a, b, done));
    std::stable_partition(result.begin(), result.end(), [](const PlanLoop& l) { return signed_area(l) > 0; });
    return result;
  }

 private:
  double angle(int from, int to) const {
    const Vec2 d = nodes_[to] - nodes_[from];
    return std::atan2(d.y, d.x);
  }
  void sort_by_angle(int node) {
    std::sort(neighbours_[node].begin(), neighbours_[node].end(),
              [&](int a, int b) { return angle(node, a) < angle(node, b); });
  }
  /// Keeping the arm on the left, the next arm at `node` after coming from `from`: the next
  /// counter-clockwise.
  int next(int from, int node) const {
    const std::vector<int>& around = neighbours_[node];
    const auto it = std::find(around.begin(), around.end(), from);
    return it + 1 == around.end() ? around.front() : *(it + 1);
  }
  PlanLoop walk(int a, int b, std::vector<std::pair<int, int>>& done) const {
    std::vector<Vec2> points;
    std::vector<double> radii;
    while (std::find(done.begin(), done.end(), std::pair(a, b)) == done.end()) {
      done.emplace_back(a, b);
      const int c = next(a, b);
      for (const Corner& corner : corners(a, b, c)) {
        points.push_back(corner.at);
        radii.push_back(corner.radius);
      }
      a = b;
      b = c;
    }
    return rounded_polygon(points, radii);
  }
  std::vector<Corner> corners(int a, int b, int c) const {
    const Vec2 in = normalized(nodes_[b] - nodes_[a]), out = normalized(nodes_[c] - nodes_[b]);
    const Vec2 right = -left_normal(in) * half_;
    if (c == a) {
      const Vec2 tip = nodes_[b] + in * half_;
      return {{tip + right, half_}, {tip - right, half_}};
    }
    const double turn = std::atan2(cross(in, out), dot(in, out));
    if (std::abs(turn) < 1e-6) return {};
    const Vec2 at = nodes_[b] + right - in * (half_ * std::tan(-turn / 2));
    return {{at, turn < 0 ? fillet_ : fillet_ + 2 * half_}};
  }

  std::vector<Vec2> nodes_;
  std::vector<std::vector<int>> neighbours_;
  double half_, fillet_;
};

}  // namespace

double PlanEdge::length() const {
  return is_arc() ? radius * std::abs(sweep) : distance(start, end);
}

Vec2 PlanEdge::point(double t) const {
  return is_arc() ? centre + unit(start_angle + t * sweep) * radius : lerp(start, end, t);
}

PlanEdge line(Vec2 start, Vec2 end) {
  return {.start = start, .end = end, .centre = {}};
}

PlanEdge arc(Vec2 centre, double radius, double start_angle, double sweep) {
  return {centre + unit(start_angle) * radius,
          centre + unit(start_angle + sweep) * radius,
          centre,
          radius,
          start_angle,
          sweep};
}

PlanLoop reversed(const PlanLoop& loop) {
  PlanLoop result(loop.rbegin(), loop.rend());
  for (PlanEdge& edge : result) {
    std::swap(edge.start, edge.end);
    edge.start_angle += edge.sweep;
    edge.sweep = -edge.sweep;
  }
  return result;
}

PlanLoop placed(const PlanLoop& loop, Vec2 origin, double angle) {
  PlanLoop result = loop;
  for (PlanEdge& edge : result) {
    edge.start = origin + turned(edge.start, angle);
    edge.end = origin + turned(edge.end, angle);
    edge.centre = origin + turned(edge.centre, angle);
    if (edge.is_arc()) edge.start_angle += angle;
  }
  return result;
}

std::vector<Vec2> sampled(const PlanLoop& loop) {
  std::vector<Vec2> points;
  for (const PlanEdge& edge : loop) {
    const double step = edge.is_arc() ? 2 * std::acos(1 - std::min(1.0, 0.01 / edge.radius)) : 1;
    const int pieces = edge.is_arc() ? std::max(2, int(std::ceil(std::abs(edge.sweep) / step))) : 1;
    for (int i = 0; i < pieces; ++i) points.push_back(edge.point(double(i) / pieces));
  }
  return points;
}

PlanLoop rounded_polygon(const std::vector<Vec2>& corners, const std::vector<double>& radii) {
  const std::size_t n = corners.size();
  PlanLoop arcs;  // a corner's arc, of zero radius where it stays sharp
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 in = normalized(corners[i] - corners[(i + n - 1) % n]);
    const Vec2 out = normalized(corners[(i + 1) % n] - corners[i]);
    const double turn = std::atan2(cross(in, out), dot(in, out));
    const double cut = radii[i] * std::tan(std::abs(turn) / 2), side = turn > 0 ? 1 : -1;
    const Vec2 start = corners[i] - in * cut;
    if (radii[i] == 0) {
      arcs.push_back({.start = start, .end = start, .centre = {}});
      continue;
    }
    const Vec2 centre = start + left_normal(in) * (side * radii[i]);
    arcs.push_back(arc(centre, radii[i], std::atan2(start.y - centre.y, start.x - centre.x), turn));
  }
  PlanLoop loop;
  for (std::size_t i = 0; i < n; ++i) {
    if (arcs[i].is_arc()) loop.push_back(arcs[i]);
    const PlanEdge& next = arcs[(i + 1) % n];
    if (distance(arcs[i].end, next.start) > 1e-6) loop.push_back(line(arcs[i].end, next.start));
  }
  return loop;
}

PlanLoop rounded_rectangle(double length, double width, double corner_radius) {
  const double x = length / 2, y = width / 2;
  return rounded_polygon({{-x, -y}, {x, -y}, {x, y}, {-x, y}}, std::vector<double>(4, corner_radius));
}

PlanLoop circle(double radius, int edges) {
  PlanLoop loop;
  for (int i = 0; i < edges; ++i) loop.push_back(arc({}, radius, 2 * pi * i / edges, 2 * pi / edges));
  return loop;
}

void centre_on_origin(Footprint& footprint) {
  const Vec2 shift = -middle(footprint.loops.front());
  for (PlanLoop& loop : footprint.loops) loop = placed(loop, shift, 0);
  for (PlanLoop& chain : footprint.centrelines) chain = placed(chain, shift, 0);
}

Footprint strip(const std::vector<PathStep>& path, double width) {
  Footprint result;
  const double half = width / 2;
  PlanLoop loop = offset_path(path, -half);
  const PlanLoop centre = offset_path(path, 0), back = reversed(offset_path(path, half));
  const Vec2 tip = loop.back().end - centre.back().end, tail = back.back().end - centre.front().start;
  loop.push_back(arc(centre.back().end, half, std::atan2(tip.y, tip.x), pi));
  loop.insert(loop.end(), back.begin(), back.end());
  loop.push_back(arc(centre.front().start, half, std::atan2(tail.y, tail.x), pi));
  result.loops = {loop};
  result.half_width = result.end_half_width = half;
  result.mean_width = width;
  set_centrelines(result, {centre});
  centre_on_origin(result);
  return result;
}

Footprint taper(double length, double start_width, double end_width) {
  const double r0 = start_width / 2, r1 = end_width / 2;
  const double lean = std::asin((r0 - r1) / length);  // of the flanks towards the axis
  const Vec2 a{-length / 2, 0}, b{length / 2, 0};
  const PlanEdge tail = arc(a, r0, pi / 2 - lean, pi + 2 * lean),
                 tip = arc(b, r1, lean - pi / 2, pi - 2 * lean);
  Footprint result;
  result.loops = {{tail, line(tail.end, tip.start), tip, line(tip.end, tail.start)}};
  result.half_width = r0;
  result.end_half_width = r1;
  result.axis_start = a;
  result.axis_end = b;
  set_centrelines(result, {{line(a, b)}});
  result.mean_width = r0 + r1;
  return result;
}

Footprint network(const std::vector<Vec2>& nodes, const std::vector<std::pair<int, int>>& arms, double width,
                  double fillet) {
  Footprint result;
  result.loops = NetworkOutline(nodes, arms, width, fillet).loops();
  result.half_width = result.end_half_width = width / 2;
  result.mean_width = width;
  std::vector<PlanLoop> centres;
  for (const auto& [a, b] : arms) centres.push_back({line(nodes[a], nodes[b])});
  set_centrelines(result, std::move(centres));
  centre_on_origin(result);
  return result;
}

Footprint ring(const PlanLoop& outer, const PlanLoop& centre, const PlanLoop& inner, double width) {
  Footprint result;
  result.loops = {outer, reversed(inner)};
  result.half_width = result.end_half_width = width / 2;
  result.mean_width = width;
  if (!centre.empty()) set_centrelines(result, {centre});
  return result;
}

Footprint circular_ring(double outer_radius, double width) {
  return ring(circle(outer_radius), circle(outer_radius - width / 2), circle(outer_radius - width), width);
}

Footprint rounded_ring(double length, double height, double corner_radius, double width) {
  const auto inset = [&](double by) {
    return rounded_rectangle(length - 2 * by, height - 2 * by, corner_radius - by);
  };
  return ring(inset(0), inset(width / 2), inset(width), width);
}

Footprint eccentric_ring(double outer_radius, double width, double offset) {
  const double inner_radius = outer_radius - width;
  // The middle line is an ellipse with the two centres as foci: a circle to within offset^2 / (4 radius).
  const PlanLoop middle_line = placed(circle((outer_radius + inner_radius) / 2), {offset / 2, 0}, 0);
  Footprint result =
      ring(circle(outer_radius), middle_line, placed(circle(inner_radius), {offset, 0}, 0), width);
  result.between_loops = true;
  return result;
}

Footprint oval_with_round_window(double length, double height, double width) {
  const double inner_radius = height / 2 - width;
  const PlanLoop outer = rounded_rectangle(length, height, height / 2);
  double perimeter = 2 * pi * inner_radius;
  for (const PlanEdge& edge : outer) perimeter += edge.length();
  Footprint result = ring(outer, {}, circle(inner_radius), width + (length - height) / 4);
  result.centreline_length = perimeter / 2;
  result.between_loops = true;
  return result;
}

Footprint blob(const PlanLoop& loop, double half_width) {
  Footprint result;
  result.loops = {loop};
  result.half_width = result.end_half_width = half_width;
  result.mean_width = 2 * half_width;
  return result;
}

BoundaryDistance::BoundaryDistance(std::vector<PlanLoop> loops) : loops_(std::move(loops)) {
  for (const PlanLoop& loop : loops_) polygons_.push_back(sampled(loop));
}

double BoundaryDistance::operator()(Vec2 p) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < int(loops_.size()); ++i) nearest = std::min(nearest, to_loop(i, p));
  return contains(p) ? nearest : -nearest;
}

double BoundaryDistance::to_loop(int index, Vec2 p) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const PlanEdge& edge : loops_[index]) nearest = std::min(nearest, edge_distance(edge, p));
  return nearest;
}

bool BoundaryDistance::contains(Vec2 p) const {
  bool inside = false;
  for (const std::vector<Vec2>& polygon : polygons_)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
  return inside;
}

}  // namespace beadmesh::examples
