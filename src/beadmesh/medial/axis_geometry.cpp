#include "beadmesh/medial/axis_geometry.h"

#include <algorithm>
#include <cmath>

#include "beadmesh/medial/axis_smoothing.h"
#include "beadmesh/medial/circle_fit.h"

namespace beadmesh {
namespace {

class Placer {
 public:
  Placer(const AxisTriangles& axis, const AxisGraph& graph, const BoundaryCurve& curve,
         const BoundarySamples& samples, const MedialOptions& options)
      : axis_(axis), graph_(graph), curve_(curve), samples_(samples), options_(options) {}

  PlacedAxis run() {
    PlacedAxis placed;
    for (const AxisNode& node : graph_.nodes) placed.nodes.push_back(place(node));
    for (const AxisEdge& edge : graph_.edges) placed.edges.push_back(place(edge, placed.nodes));
    return placed;
  }

 private:
  SegmentRun run_after(Index half_edge) const {
    return run_of(curve_, samples_, axis_.sector_after(half_edge));
  }

  PlacedNode place(const AxisNode& node) const {
    const Cluster& cluster = axis_.cluster(axis_.find(node.triangle));
    if (cluster.corner != no_index)
      return {cluster.circle, {contact_of(cluster.corner, cluster.circle.centre)}};
    if (node.out.empty()) return place_isolated(cluster.circle);
    if (node.out.size() == 1) return place_end(cluster.circle, node.out[0]);
    return place_junction(cluster, node.out);
  }

  Contact contact_of(Index sample, Vec2 from) const {
    const BoundarySample& at = samples_.samples[sample];
    const Index segment = curve_.segment_at(at.loop, at.position);
    const double start = curve_.position(at.loop, segment, 0), end = curve_.position(at.loop, segment, 1);
    const double length = end > start ? end - start : curve_.length(at.loop) - start;
    const double t = std::clamp((at.position - start) / length, 0.0, 1.0);
    return {at.loop, segment, t, at.point, distance(at.point, from)};
  }

  PlacedNode place_junction(const Cluster& cluster, const std::vector<Index>& out) const {
    std::vector<SegmentRun> runs;
    for (const Index h : out) runs.push_back(run_after(h));
    PlacedNode placed{cluster.circle, {}};
    placed.merged = cluster.merged;
    if (options_.polish && cluster.merged)
      placed.feet = polish_merged(curve_, runs, placed.circle);
    else if (options_.polish)
      placed.feet = polish(curve_, runs, placed.circle);
    if (placed.feet.empty()) {
      placed = unmoved(cluster.circle, runs);
      placed.settled = !options_.polish;
    }
    // Contraction may have joined junctions a little apart: no disc touches all their sectors then.
    for (const Contact& foot : placed.feet)
      if (foot.distance > placed.circle.radius + 1e-12 * curve_.size() && out.size() > 3)
        placed.merged = true;
    return placed;
  }

  PlacedNode unmoved(Circle circle, const std::vector<SegmentRun>& runs) const {
    PlacedNode placed{circle, feet_of(curve_, runs, circle.centre)};
    placed.circle.radius = placed.feet[0].distance;
    for (const Contact& foot : placed.feet)
      placed.circle.radius = std::min(placed.circle.radius, foot.distance);
    return placed;
  }

  /// The contact of a smooth end: all samples of its sector that the disc reaches, but at least the nearest
  /// point.
  PlacedNode place_end(Circle circle, Index out) const {
    const Sector sector = axis_.sector_after(out);
    const Contact nearest = curve_.nearest(circle.centre, run_of(curve_, samples_, sector));
    const double band = std::max(2e-3 * circle.radius, 2 * curve_.noise());
    std::vector<Index> reached;
    for (Index i = sector.first;; i = next_sample(samples_, i)) {
      if (std::abs(distance(samples_.samples[i].point, circle.centre) - circle.radius) <= band)
        reached.push_back(i);
      if (i == sector.last) break;
    }
    circle.radius = nearest.distance;
    if (reached.empty()) return {circle, {nearest, nearest, nearest}};
    const double length = curve_.length(nearest.loop);
    const double start = samples_.samples[reached.front()].position,
                 end = samples_.samples[reached.back()].position;
    double middle = start + std::fmod(end - start + length, length) / 2;
    if (middle >= length) middle -= length;
    const SegmentRun at_middle{nearest.loop, curve_.segment_at(nearest.loop, middle), 1};
    return {circle,
            {contact_of(reached.front(), circle.centre), contact_of(reached.back(), circle.centre),
             at_position(at_middle, middle, circle.centre)}};
  }

  Contact at_position(const SegmentRun& run, double position, Vec2 from) const {
    const double start = curve_.position(run.loop, run.segment, 0);
    const double half = curve_.position(run.loop, run.segment, 0.5) - start;
    const Vec2 point = curve_.curve_point(run.loop, position);
    return {run.loop, run.segment, std::clamp((position - start) / (2 * half), 0.0, 1.0), point,
            distance(point, from)};
  }

  /// A full disc touches everywhere; a domain of one triangle is treated alike.
  PlacedNode place_isolated(Circle circle) const {
    std::vector<Vec2> points;
    for (const BoundarySample& sample : samples_.samples) points.push_back(sample.point);
    if (const auto fit = fitted_circle(points, circle); fit && points.size() > 3) circle = *fit;
    const Contact nearest = curve_.nearest(circle.centre, {0, 0, curve_.segments(0)});
    PlacedNode placed{{circle.centre, nearest.distance}, {nearest}};
    const double start = curve_.position(0, nearest.segment, nearest.t), length = curve_.length(0);
    for (const double part : {1.0 / 3, 2.0 / 3}) {
      const double position = std::fmod(start + part * length, length);
      placed.feet.push_back(at_position({0, curve_.segment_at(0, position), 1}, position, circle.centre));
    }
    return placed;
  }

  PlacedEdge place(const AxisEdge& edge, const std::vector<PlacedNode>& nodes) const {
    const bool closed = edge.start == no_index;
    const Circle* start = closed ? nullptr : &nodes[edge.start].circle;
    const Circle* end = closed ? nullptr : &nodes[edge.end].circle;
    PlacedEdge points;
    const std::size_t count = edge.half_edges.size();
    for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i)
      add_point(points, edge.half_edges[i], edge.half_edges[(i + 1) % count]);
    if (!closed && count == 1) add_crossing(points, edge.half_edges[0]);
    thin_out(points, start, end);
    if (start && is_merged(edge.start)) straighten_start(points, *start);
    if (end && is_merged(edge.end)) {
      std::reverse(points.begin(), points.end());
      straighten_start(points, *end);
      std::reverse(points.begin(), points.end());
    }
    if (options_.smoothing_passes > 0 && !points.empty()) {
      smooth(points, start, end);
      thin_out(points, start, end);
    }
    return points;
  }

  bool is_merged(Index node) const { return axis_.cluster(axis_.find(graph_.nodes[node].triangle)).merged; }

  /// An edge first went to one of the junctions that were merged; now it goes straight to where they all are.
  static void straighten_start(PlacedEdge& points, const Circle& node) {
    constexpr double straight = radians(3);
    std::size_t first = 0;
    while (first + 2 < points.size()) {
      const Vec2 at = points[first].circle.centre, onwards = points[first + 1].circle.centre - at;
      const bool beyond = distance(at, node.centre) > 2.5 * node.radius;
      if (beyond || angle_between(at - node.centre, onwards) < straight) break;
      ++first;
    }
    points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first));
  }

  /// The cluster between entering through `in` and leaving through `out`.
  void add_point(PlacedEdge& points, Index in, Index out) const {
    const Index back = axis_.twin(in);
    AxisPoint point{axis_.cluster(axis_.cluster_of(out)).circle, {run_after(out), run_after(back)}, {}};
    const auto sample = [&](Index i) { return samples_.samples[i].point; };
    const Vec2 left = lerp(sample(axis_.left(out)), sample(axis_.right(back)), 0.5);
    const Vec2 right = lerp(sample(axis_.right(out)), sample(axis_.left(back)), 0.5);
    add_placed(points, point, {lerp(left, right, 0.5), distance(left, right) / 2});
  }

  /// An edge without clusters between its nodes gets a point where it passes from one triangle to the next.
  void add_crossing(PlacedEdge& points, Index h) const {
    const Index left = axis_.left(h), right = axis_.right(h);
    const Vec2 a = samples_.samples[left].point, b = samples_.samples[right].point;
    const Circle circle{lerp(a, b, 0.5), distance(a, b) / 2};
    add_placed(
        points,
        {circle, {run_of(curve_, samples_, {left, left}), run_of(curve_, samples_, {right, right})}, {}},
        circle);
  }

  void add_placed(PlacedEdge& points, AxisPoint point, const Circle& fallback) const {
    const std::vector<SegmentRun> runs{point.runs[0], point.runs[1]};
    std::vector<Contact> feet;
    if (options_.polish) {
      feet = polish(curve_, runs, point.circle);
      if (feet.empty()) feet = polish(curve_, runs, point.circle = fallback);
      if (feet.empty()) return;
    } else {
      feet = feet_of(curve_, runs, point.circle.centre);
      point.circle.radius = std::min(feet[0].distance, feet[1].distance);
    }
    point.feet = {feet[0], feet[1]};
    points.push_back(point);
  }

  /// Distance below which two points of an edge are one: 0.3 of the samples' spacing at its feet.
  double least_step(const AxisPoint& point) const {
    double spacing = 0;
    for (const SegmentRun& run : point.runs) {
      const double along = distance(curve_.polyline_point(run.loop, run.segment, 0),
                                    curve_.polyline_point(run.loop, run.segment, 1));
      spacing = spacing == 0 ? along : std::min(spacing, along);
    }
    return 0.3 * std::min(spacing, 0.5 * point.circle.radius);
  }

  /// Removes points nearer than least_step to the one before or to a node, and points where the line turns
  /// back.
  void thin_out(PlacedEdge& points, const Circle* start, const Circle* end) const {
    PlacedEdge kept;
    for (const AxisPoint& point : points) {
      const double step = least_step(point);
      const Vec2 at = point.circle.centre;
      if (start && distance(at, start->centre) < step) continue;
      if (end && distance(at, end->centre) < step) continue;
      if (!kept.empty() && distance(at, kept.back().circle.centre) < step) continue;
      kept.push_back(point);
    }
    if (!start && kept.size() > 3 &&
        distance(kept.front().circle.centre, kept.back().circle.centre) < least_step(kept.back()))
      kept.pop_back();
    while (remove_reversal(kept, start, end)) continue;
    points = std::move(kept);
  }

  static bool remove_reversal(PlacedEdge& points, const Circle* start, const Circle* end) {
    const std::size_t n = points.size();
    if (!start && n < 4) return false;
    PlacedEdge kept;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 at = points[i].circle.centre;
      const Vec2 before = !kept.empty() ? kept.back().circle.centre
                          : start       ? start->centre
                                        : points[n - 1].circle.centre;
      const Vec2 after = i + 1 < n ? points[i + 1].circle.centre
                         : end     ? end->centre
                                   : points[0].circle.centre;
      if (dot(at - before, after - at) > 0)
        kept.push_back(points[i]);
      else if (i + 1 < n && ++i < n)
        kept.push_back(points[i]);  // look at the next one again in another round
    }
    const bool removed = kept.size() < n;
    points = std::move(kept);
    return removed;
  }

  void smooth(PlacedEdge& points, const Circle* start, const Circle* end) const {
    std::vector<Vec2> line;
    if (start) line.push_back(start->centre);
    for (const AxisPoint& point : points) line.push_back(point.circle.centre);
    if (end) line.push_back(end->centre);
    for (int pass = 0; pass < options_.smoothing_passes; ++pass) smooth_cubic(line, start == nullptr);
    for (std::size_t i = 0; i < points.size(); ++i) settle(points[i], line[i + (start ? 1 : 0)]);
  }

  /// Takes over a smoothed position: as it is where noise allows, else polished; the old one where that
  /// fails.
  void settle(AxisPoint& point, Vec2 smoothed) const {
    const std::vector<SegmentRun> runs{point.runs[0], point.runs[1]};
    std::vector<Contact> feet = feet_of(curve_, runs, smoothed);
    Circle circle{smoothed, std::min(feet[0].distance, feet[1].distance)};
    const double gap = std::abs(feet[0].distance - feet[1].distance);
    if (options_.polish && gap > 2 * curve_.noise()) feet = polish(curve_, runs, circle);
    if (feet.empty()) return;
    point.circle = circle;
    point.feet = {feet[0], feet[1]};
  }

  const AxisTriangles& axis_;
  const AxisGraph& graph_;
  const BoundaryCurve& curve_;
  const BoundarySamples& samples_;
  const MedialOptions& options_;
};

}  // namespace

PlacedAxis placed_axis(const AxisTriangles& axis, const AxisGraph& graph, const BoundaryCurve& curve,
                       const BoundarySamples& samples, const MedialOptions& options) {
  return Placer(axis, graph, curve, samples, options).run();
}

std::vector<Contact> doubtful_contacts(const AxisGraph& graph, const PlacedAxis& placed, double tolerance) {
  std::vector<Contact> doubtful;
  const auto add = [&](const PlacedNode& node) {
    for (const Contact& foot : node.feet)
      if (foot.t > 0 && foot.t < 1) doubtful.push_back(foot);
  };
  for (const PlacedNode& node : placed.nodes)
    if (!node.settled) add(node);
  for (const AxisEdge& edge : graph.edges) {
    if (edge.start == no_index || edge.start == edge.end) continue;
    const PlacedNode &start = placed.nodes[edge.start], &end = placed.nodes[edge.end];
    const auto holds_foot = [&](const PlacedNode& a, const PlacedNode& b) {
      return !a.merged && !b.merged && std::any_of(b.feet.begin(), b.feet.end(), [&](const Contact& foot) {
        return distance(foot.point, a.circle.centre) < a.circle.radius - tolerance;
      });
    };
    if (!holds_foot(start, end) && !holds_foot(end, start)) continue;
    add(start);
    add(end);
  }
  return doubtful;
}

}  // namespace beadmesh
