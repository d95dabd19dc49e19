#include <algorithm>
#include <cmath>

#include "beadmesh/medial/axis_geometry.h"
#include "beadmesh/medial/axis_refinement.h"
#include "beadmesh/medial/axis_smoothing.h"

namespace beadmesh {
namespace {

constexpr double most_points = 1e5, most_points_per_sample = 4;  // that the default chord may ask for

/// An edge starts or ends at a node's disc; a closed edge has none.
struct EdgeEnds {
  const PlacedNode* start = nullptr;
  const PlacedNode* end = nullptr;
};

class EdgePlacer {
 public:
  EdgePlacer(const AxisOnBoundary& axis, const std::vector<PlacedNode>& nodes, const MedialOptions& options)
      : axis_(axis.triangles),
        curve_(axis.curve),
        samples_(axis.samples),
        nodes_(nodes),
        options_(options),
        is_noisy_(curve_.noise() > 0) {}

  std::vector<PlacedEdge> run(const AxisGraph& graph) const {
    std::vector<PlacedEdge> placed;
    placed.reserve(graph.edges.size());
    for (const AxisEdge& edge : graph.edges) placed.push_back(place(edge));
    if (options_.polish) refine(placed, graph);
    return placed;
  }

 private:
  PlacedEdge place(const AxisEdge& edge) const {
    EdgeEnds ends;
    if (edge.start != no_index) ends = {&nodes_[edge.start], &nodes_[edge.end]};
    PlacedEdge points = clusters_of(edge);
    thin_out(points, ends);
    straighten(points, ends);
    if (options_.smoothing_passes > 0 && !points.empty() && (is_noisy_ || !options_.polish)) {
      smooth(points, ends);
      thin_out(points, ends);
    }
    return points;
  }

  PlacedEdge clusters_of(const AxisEdge& edge) const {
    const bool closed = edge.start == no_index;
    const std::size_t count = edge.half_edges.size();
    PlacedEdge points;
    points.reserve(count + 1);
    for (std::size_t i = 0; i + (closed ? 0 : 1) < count; ++i)
      add_cluster(points, edge.half_edges[i], edge.half_edges[i + 1 < count ? i + 1 : 0]);
    if (!closed && count == 1) add_crossing(points, edge.half_edges[0]);
    return points;
  }

  Vec2 sample(Index i) const { return samples_.samples[i].point; }

  /// The cluster between entering through `in` and leaving through `out`.
  void add_cluster(PlacedEdge& points, Index in, Index out) const {
    const Index back = axis_.twin(in);
    const Sector left{axis_.left(out), axis_.right(back)}, right{axis_.left(back), axis_.right(out)};
    const Vec2 to_left = lerp(sample(left.first), sample(left.last), 0.5);
    const Vec2 to_right = lerp(sample(right.first), sample(right.last), 0.5);
    const Circle middle{lerp(to_left, to_right, 0.5), distance(to_left, to_right) / 2};
    const Circle& circle = axis_.cluster(axis_.cluster_of(out)).circle;
    // The circumcentre of an obtuse triangle is far from where the axis passes it.
    const bool is_far = circle.radius > 3 * middle.radius;
    const std::array<SegmentRun, 2> runs{run_of(curve_, samples_, left), run_of(curve_, samples_, right)};
    if (!add_point(points, runs, is_far ? middle : circle)) add_point(points, runs, is_far ? circle : middle);
  }

  /// An edge without clusters between its nodes gets a point where it passes from one triangle to the next.
  void add_crossing(PlacedEdge& points, Index h) const {
    const Index left = axis_.left(h), right = axis_.right(h);
    const Circle circle{lerp(sample(left), sample(right), 0.5), distance(sample(left), sample(right)) / 2};
    add_point(points, {run_of(curve_, samples_, {left, left}), run_of(curve_, samples_, {right, right})},
              circle);
  }

  bool add_point(PlacedEdge& points, const std::array<SegmentRun, 2>& runs, const Circle& circle) const {
    AxisPoint point{
        circle,
        {curve_.nearest_chord(circle.centre, runs[0]), curve_.nearest_chord(circle.centre, runs[1])},
        {}};
    if (!options_.polish)
      set_feet(curve_, point);
    else if (!polish_between(runs, point))
      return false;
    points.push_back(point);
    return true;
  }

  /// A foot that came to the back of a wall, around a concave corner, is no contact.
  bool is_before_walls(const AxisPoint& point) const {
    for (const BoundaryPlace& foot : point.feet)
      if (foot.t > 0 && foot.t < 1 && !curve_.is_before(point.circle.centre, foot)) return false;
    return true;
  }

  /// Polished, and no other place of the runs is nearer: on an exact curve a long run may have several places
  /// that are nearer than those around them.
  bool polish_between(const std::array<SegmentRun, 2>& runs, AxisPoint& point) const {
    constexpr int most_rounds = 5;
    for (int round = 0; round < most_rounds; ++round) {
      if (!polish(curve_, point) || !is_before_walls(point)) return false;
      bool is_nearest = true;
      for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
        if (!curve_.is_exact(runs[side].loop)) continue;
        const Contact found = curve_.nearest(point.circle.centre, runs[side]);
        if (found.distance > point.circle.radius - curve_.tolerances().rounding) continue;
        point.feet[side] = found.place;
        is_nearest = false;
      }
      if (is_nearest) return true;
    }
    return false;
  }

  /// Distance below which two points of an edge are one: 0.3 of the samples' spacing at its feet.
  double least_step(const AxisPoint& point) const {
    double spacing = 0.5 * point.circle.radius;
    for (const BoundaryPlace& foot : point.feet)
      spacing = std::min(spacing, curve_.chord(foot.loop, foot.segment));
    return 0.3 * spacing;
  }

  /// Removes points nearer than least_step to the one before or to a node, and points where the line turns
  /// back.
  void thin_out(PlacedEdge& points, const EdgeEnds& ends) const {
    std::size_t kept = 0;
    for (const AxisPoint& point : points) {
      const double step = least_step(point), square = step * step;
      const Vec2 at = point.circle.centre;
      const auto is_near = [&](Vec2 other) { return squared_norm(other - at) < square; };
      if (ends.start && (is_near(ends.start->circle.centre) || is_near(ends.end->circle.centre))) continue;
      if (kept > 0 && is_near(points[kept - 1].circle.centre)) continue;
      points[kept++] = point;
    }
    if (!ends.start && kept > 3 &&
        distance(points.front().circle.centre, points[kept - 1].circle.centre) < least_step(points[kept - 1]))
      --kept;
    points.resize(kept);
    while (remove_reversal(points, ends)) continue;
  }

  static bool remove_reversal(PlacedEdge& points, const EdgeEnds& ends) {
    const std::size_t n = points.size();
    if (n == 0 || (!ends.start && n < 4)) return false;
    const Vec2 last = points[n - 1].circle.centre, first = points[0].circle.centre;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 at = points[i].circle.centre;
      const Vec2 before = kept > 0     ? points[kept - 1].circle.centre
                          : ends.start ? ends.start->circle.centre
                                       : last;
      const Vec2 after = i + 1 < n ? points[i + 1].circle.centre : ends.end ? ends.end->circle.centre : first;
      if (dot(at - before, after - at) > 0)
        points[kept++] = points[i];
      else if (i + 1 < n && ++i < n)
        points[kept++] = points[i];  // look at the next one again in another round
    }
    points.resize(kept);
    return kept < n;
  }

  static void straighten(PlacedEdge& points, const EdgeEnds& ends) {
    if (ends.start && ends.start->crossing) straighten_start(points, ends.start->circle);
    if (!ends.end || !ends.end->crossing) return;
    std::reverse(points.begin(), points.end());
    straighten_start(points, ends.end->circle);
    std::reverse(points.begin(), points.end());
  }

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

  void smooth(PlacedEdge& points, const EdgeEnds& ends) const {
    std::vector<Vec2> line;
    line.reserve(points.size() + 2);
    if (ends.start) line.push_back(ends.start->circle.centre);
    for (const AxisPoint& point : points) line.push_back(point.circle.centre);
    if (ends.end) line.push_back(ends.end->circle.centre);
    for (int pass = 0; pass < options_.smoothing_passes; ++pass) smooth_cubic(line, ends.start == nullptr);
    for (std::size_t i = 0; i < points.size(); ++i) settle(points[i], line[i + (ends.start ? 1 : 0)]);
  }

  /// Takes over a smoothed position: as it is where noise allows, else polished; the old one where that
  /// fails.
  void settle(AxisPoint& point, Vec2 smoothed) const {
    AxisPoint moved = point;
    moved.circle.centre = smoothed;
    const double gap = set_feet(curve_, moved);
    if (options_.polish && gap > 2 * curve_.noise() && !polish(curve_, moved)) return;
    point = moved;
  }

  /// Points between the points where the line between them is off the axis.
  void refine(std::vector<PlacedEdge>& placed, const AxisGraph& graph) const {
    AxisRefiner refiner(curve_, options_.chord > 0 ? options_.chord : curve_.tolerances().chord);
    if (options_.chord <= 0) {
      double wanted = 0;
      for (std::size_t i = 0; i < placed.size(); ++i) wanted += refiner.points_wanted(placed[i]);
      const double most = most_points + most_points_per_sample * static_cast<double>(samples_.samples.size());
      // The number of points goes with the square root of the chord.
      if (wanted > most) refiner.set_chord(curve_.tolerances().chord * (wanted / most) * (wanted / most));
    }
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const AxisEdge& edge = graph.edges[i];
      if (edge.start == no_index) {
        refiner.refine_closed(placed[i]);
        continue;
      }
      const AxisPoint start = leaving(edge.start, edge.start_slot);
      AxisPoint end = leaving(edge.end, edge.end_slot);
      std::swap(end.feet[0], end.feet[1]);
      refiner.refine_open(placed[i], start, nodes_[edge.start].crossing, end, nodes_[edge.end].crossing);
    }
  }

  AxisPoint leaving(Index node, Index slot) const {
    const std::array<Contact, 2> feet = feet_leaving(nodes_[node], slot);
    return {nodes_[node].circle, {feet[0].place, feet[1].place}, feet[0].point - feet[1].point};
  }

  const AxisTriangles& axis_;
  const BoundaryCurve& curve_;
  const BoundarySamples& samples_;
  const std::vector<PlacedNode>& nodes_;
  const MedialOptions& options_;
  bool is_noisy_;
};

}  // namespace

std::vector<PlacedEdge> placed_edges(const AxisOnBoundary& axis, const std::vector<PlacedNode>& nodes,
                                     const MedialOptions& options) {
  return EdgePlacer(axis, nodes, options).run(axis.graph);
}

}  // namespace beadmesh
