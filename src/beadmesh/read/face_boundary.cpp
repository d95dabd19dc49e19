#include "beadmesh/read/face_boundary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace beadmesh {
namespace {

Vec2 stretched(Vec2 uv, Vec2 stretch) {
  return {uv.x * stretch.x, uv.y * stretch.y};
}

class BoundaryBuilder {
 public:
  BoundaryBuilder(const CadTopology& topology, Vec2 stretch, FaceNodes& nodes)
      : topology_(topology), stretch_(stretch), nodes_(nodes) {}

  void add_loop(const std::vector<CadUse>& loop) {
    std::vector<NodeRun> runs;
    for (const CadUse& use : loop) runs.push_back(run_of(use));
    for (std::size_t i = 0; i < runs.size(); ++i) join(runs, i, (i + 1) % runs.size());
    insert_hidden_poles(runs, loop);
    nodes_.loops.push_back(std::move(runs));
  }

 private:
  Index add_node(Vec2 uv, Vec3 point) {
    nodes_.uv.push_back(uv);
    nodes_.points.push_back(point);
    return static_cast<Index>(nodes_.uv.size()) - 1;
  }

  NodeRun run_of(const CadUse& use) {
    const CadEdge& edge = topology_.edges[use.edge];
    NodeRun run;
    if (edge.is_pole()) {
      run.vertex = edge.first_vertex;
      const Vec3 pole = topology_.vertices[run.vertex];
      run.nodes = {add_node(use.uv(edge, use.first), pole), add_node(use.uv(edge, use.last), pole)};
    } else {
      run.edge = use.edge;
      run.reversed = use.reversed;
      const std::size_t last = edge.points.size() - 1;
      for (std::size_t i = 0; i <= last; ++i) {
        const Vec3 point = i == 0      ? topology_.vertices[edge.first_vertex]
                           : i == last ? topology_.vertices[edge.last_vertex]
                                       : edge.points[i];
        run.nodes.push_back(add_node(use.uv(edge, edge.parameters[i]), point));
      }
    }
    if (use.reversed) std::reverse(run.nodes.begin(), run.nodes.end());
    return run;
  }

  double length(const NodeRun& run) const {
    double sum = 0;
    for (std::size_t i = 1; i < run.nodes.size(); ++i)
      sum += distance(stretched(nodes_.uv[run.nodes[i - 1]], stretch_),
                      stretched(nodes_.uv[run.nodes[i]], stretch_));
    return sum;
  }

  /// The end of one run and the start of the next are one node, unless the parameters jump (a pole without an
  /// edge).
  void join(std::vector<NodeRun>& runs, std::size_t i, std::size_t next) {
    const Index end = runs[i].nodes.back(), start = runs[next].nodes.front();
    const double gap = distance(stretched(nodes_.uv[end], stretch_), stretched(nodes_.uv[start], stretch_));
    if (gap <= 0.2 * std::min(length(runs[i]), length(runs[next])) + 1e-6) runs[i].nodes.back() = start;
  }

  void insert_hidden_poles(std::vector<NodeRun>& runs, const std::vector<CadUse>& loop) const {
    for (std::size_t i = runs.size(); i-- > 0;) {
      const std::size_t next = (i + 1) % runs.size();
      if (runs[i].nodes.back() == runs[next].nodes.front()) continue;
      NodeRun pole;
      const CadEdge& edge = topology_.edges[loop[i].edge];
      pole.vertex = loop[i].reversed ? edge.first_vertex : edge.last_vertex;
      pole.nodes = {runs[i].nodes.back(), runs[next].nodes.front()};
      runs.insert(runs.begin() + static_cast<std::ptrdiff_t>(i) + 1, std::move(pole));
    }
  }

  const CadTopology& topology_;
  Vec2 stretch_;
  FaceNodes& nodes_;
};

/// Forgets the nodes that gave way to another at a joint.
void drop_unused(FaceNodes& nodes) {
  std::vector<Index> renumbered(nodes.uv.size(), no_index);
  std::vector<Vec2> uv;
  std::vector<Vec3> points;
  for (std::vector<NodeRun>& loop : nodes.loops)
    for (NodeRun& run : loop)
      for (Index& n : run.nodes) {
        if (renumbered[n] == no_index) {
          renumbered[n] = static_cast<Index>(uv.size());
          uv.push_back(nodes.uv[n]);
          points.push_back(nodes.points[n]);
        }
        n = renumbered[n];
      }
  nodes.uv = std::move(uv);
  nodes.points = std::move(points);
}

std::vector<Index> polygon_of(const std::vector<NodeRun>& loop) {
  std::vector<Index> polygon;
  for (const NodeRun& run : loop) polygon.insert(polygon.end(), run.nodes.begin(), run.nodes.end() - 1);
  return polygon;
}

double signed_area_of(const std::vector<Index>& polygon, const FaceNodes& nodes, Vec2 stretch) {
  double sum = 0;
  const Vec2 origin = stretched(nodes.uv[polygon.front()], stretch);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += cross(stretched(nodes.uv[polygon[i]], stretch) - origin,
                 stretched(nodes.uv[polygon[i + 1]], stretch) - origin) /
           2;
  return sum;
}

void turn_loop(std::vector<NodeRun>& loop) {
  std::reverse(loop.begin(), loop.end());
  for (NodeRun& run : loop) {
    run.reversed = !run.reversed;
    std::reverse(run.nodes.begin(), run.nodes.end());
  }
}

constexpr double least_angle = 0.03;  // two samplings of nearly tangent curves may overlap a little
constexpr double touch = 1e-6;        // of a segment: as near as this to its end is at its end

/// A polygon on its way through a point.
struct Passage {
  Vec2 from, to;
};

/// Do two polygons that meet at `x` change sides there?
bool change_sides(Vec2 x, const Passage& one, const Passage& other) {
  const Vec2 out = other.to - x;
  const auto turn = [&](Vec2 p) {
    const double angle = std::atan2(cross(out, p - x), dot(out, p - x));
    return angle < 0 ? angle + 2 * pi : angle;
  };
  const double sector = turn(other.from), a = turn(one.from), b = turn(one.to);
  for (const double angle : {a, b})
    if (angle < least_angle || 2 * pi - angle < least_angle || std::abs(angle - sector) < least_angle)
      return false;
  return (a < sector) != (b < sector);
}

class CrossingSearch {
 public:
  CrossingSearch(const std::vector<std::vector<Index>>& polygons, const std::vector<Vec2>& points)
      : points_(points) {
    for (const std::vector<Index>& polygon : polygons)
      for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
        Segment s{polygon[(i + n - 1) % n], polygon[i], polygon[(i + 1) % n], polygon[(i + 2) % n], 0, 0};
        s.low = std::min(points[s.a].x, points[s.b].x);
        s.high = std::max(points[s.a].x, points[s.b].x);
        segments_.push_back(s);
      }
    std::stable_sort(segments_.begin(), segments_.end(),
                     [](const Segment& s, const Segment& t) { return s.low < t.low; });
  }

  /// A node at the first crossing, or no_index.
  Index find() const {
    for (std::size_t i = 0; i < segments_.size(); ++i)
      for (std::size_t j = i + 1; j < segments_.size() && segments_[j].low <= segments_[i].high; ++j)
        if (cross_each_other(segments_[i], segments_[j])) return segments_[i].a;
    return no_index;
  }

 private:
  struct Segment {
    Index before, a, b, after;
    double low, high;
  };

  Passage passage(const Segment& s, double at) const {
    return {points_[at < touch ? s.before : s.a], points_[at > 1 - touch ? s.after : s.b]};
  }

  bool cross_each_other(const Segment& s, const Segment& t) const {
    if (s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b) return false;
    const Vec2 u = points_[s.b] - points_[s.a], v = points_[t.b] - points_[t.a];
    const double turn = cross(u, v);
    if (std::abs(turn) <= least_angle / 2 * norm(u) * norm(v)) return false;
    const Vec2 gap = points_[t.a] - points_[s.a];
    const double at_s = cross(gap, v) / turn, at_t = cross(gap, u) / turn;
    if (at_s < -touch || at_s > 1 + touch || at_t < -touch || at_t > 1 + touch) return false;
    return change_sides(points_[s.a] + u * at_s, passage(s, at_s), passage(t, at_t));
  }

  const std::vector<Vec2>& points_;
  std::vector<Segment> segments_;
};

}  // namespace

std::vector<std::vector<Index>> boundary_nodes(const CadTopology& topology, const CadFace& face, Vec2 stretch,
                                               FaceNodes& nodes) {
  BoundaryBuilder builder(topology, stretch, nodes);
  for (const std::vector<CadUse>& loop : face.loops) builder.add_loop(loop);
  drop_unused(nodes);
  std::vector<std::vector<Index>> polygons;
  std::vector<double> areas;
  for (const std::vector<NodeRun>& loop : nodes.loops) {
    polygons.push_back(polygon_of(loop));
    areas.push_back(signed_area_of(polygons.back(), nodes, stretch));
  }
  // Files get the direction of loops wrong now and then. In the plane of the parameters it follows from the
  // areas.
  std::size_t outer = 0;
  for (std::size_t i = 1; i < areas.size(); ++i)
    if (std::abs(areas[i]) > std::abs(areas[outer])) outer = i;
  for (std::size_t i = 0; i < areas.size(); ++i)
    if ((areas[i] < 0) == (i == outer)) {
      turn_loop(nodes.loops[i]);
      polygons[i] = polygon_of(nodes.loops[i]);
    }
  return polygons;
}

std::optional<Vec3> find_crossing(const std::vector<std::vector<Index>>& polygons,
                                  const std::vector<Vec2>& stretched, const std::vector<Vec3>& points) {
  const Index node = CrossingSearch(polygons, stretched).find();
  if (node == no_index) return {};
  return points[node];
}

Diagnostic crossing_defect(Vec3 where, Index number) {
  return {"read.face.loop_crosses",
          Severity::error,
          number,
          {},
          fmt::format("its boundary crosses itself near ({:.3f}, {:.3f}, {:.3f})", where.x, where.y, where.z),
          "repair the face in the CAD system"};
}

InsideTest::InsideTest(const std::vector<std::vector<Index>>& polygons, const std::vector<Vec2>& points) {
  double low = points[polygons[0][0]].y, high = low;
  std::size_t count = 0;
  for (const std::vector<Index>& polygon : polygons)
    for (const Index p : polygon) {
      low = std::min(low, points[p].y);
      high = std::max(high, points[p].y);
      ++count;
    }
  rows_.resize(std::clamp<std::size_t>(count / 4, 1, 4096));
  low_ = low;
  step_ = std::max((high - low) / static_cast<double>(rows_.size()), 1e-12);
  const auto row = [&](double y) {
    return static_cast<std::size_t>(std::clamp((y - low_) / step_, 0.0, rows_.size() - 1.0));
  };
  for (const std::vector<Index>& polygon : polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 a = points[polygon[i]], b = points[polygon[(i + 1) % polygon.size()]];
      for (std::size_t r = row(std::min(a.y, b.y)); r <= row(std::max(a.y, b.y)); ++r)
        rows_[r].push_back({a, b});
    }
}

bool InsideTest::operator()(Vec2 p) const {
  const double at = (p.y - low_) / step_;
  if (!(at >= 0 && at <= static_cast<double>(rows_.size()))) return false;
  bool inside = false;
  for (const Segment& s : rows_[std::min(static_cast<std::size_t>(at), rows_.size() - 1)])
    if ((s.a.y > p.y) != (s.b.y > p.y) && p.x < s.a.x + (p.y - s.a.y) / (s.b.y - s.a.y) * (s.b.x - s.a.x))
      inside = !inside;
  return inside;
}

}  // namespace beadmesh
