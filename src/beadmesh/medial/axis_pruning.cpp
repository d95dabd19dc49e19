#include "beadmesh/medial/axis_pruning.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

#include "beadmesh/medial/axis_polish.h"
#include "beadmesh/medial/osculating_circle.h"

namespace beadmesh {
namespace {

/// A leaf by its only open half-edge.
struct Leaf {
  double protrusion;
  Index half_edge;
  friend bool operator>(const Leaf& a, const Leaf& b) {
    return std::tie(a.protrusion, a.half_edge) > std::tie(b.protrusion, b.half_edge);
  }
};

class Pruner {
 public:
  Pruner(AxisTriangles& axis, const PruneTolerance& tolerance) : axis_(axis), tolerance_(tolerance) {}

  void run() {
    for (const Index leaf : axis_.leaves()) push(leaf);
    while (!leaves_.empty()) {
      const Leaf leaf = leaves_.top();
      leaves_.pop();
      if (!is_leaf(leaf.half_edge)) continue;
      // A junction further in may have dissolved since, and the leaf reaches further now.
      if (measured(leaf.half_edge, axis_.chain_end(leaf.half_edge)) > leaf.protrusion)
        push(leaf.half_edge);
      else
        cut(leaf.half_edge);
    }
  }

 private:
  bool is_leaf(Index h) const {
    return axis_.cluster_of(h) != axis_.cluster_of(axis_.twin(h)) && axis_.next_open(h) == h &&
           axis_.cluster(axis_.cluster_of(h)).corner == no_index;
  }
  double measured(Index h, Index inner) const {
    return protrusion(axis_.tip(axis_.cluster_of(h)), axis_.cluster(inner).circle);
  }

  void push(Index h) {
    if (!is_leaf(h)) return;
    const Index end = axis_.chain_end(h);
    const Cluster& inner = axis_.cluster(end);
    if (inner.corner != no_index) return;
    const double local = std::max(tolerance_.at(axis_.left(h)), tolerance_.at(axis_.right(h)));
    const double reach = measured(h, end);
    if (reach < 0.25 * inner.circle.radius &&
        tolerance_.is_vertex(axis_.cluster(axis_.cluster_of(h)).circle, axis_.sector_after(h)))
      return;
    if (reach < std::min(local, 0.25 * inner.circle.radius)) leaves_.push({reach, h});
  }

  void cut(Index h) {
    const std::vector<Index> chain = axis_.chain(h);
    const Index inner = axis_.cluster_of(axis_.twin(chain.back()));
    const Circle lost = axis_.tip(axis_.cluster_of(h));
    for (auto passed = chain.rbegin(); passed != chain.rend(); ++passed) axis_.close(*passed, inner);
    const Circle& kept = axis_.cluster(inner).circle;
    if (protrusion(lost, kept) > protrusion(axis_.tip(inner), kept)) axis_.set_tip(inner, lost);
  }

  AxisTriangles& axis_;
  const PruneTolerance& tolerance_;
  std::priority_queue<Leaf, std::vector<Leaf>, std::greater<>> leaves_;
};

/// Midpoint of a polyline of centres, with the radius there.
Circle middle_of(const std::vector<Circle>& path, double length) {
  double left = length / 2;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const double step = distance(path[i].centre, path[i + 1].centre);
    if (step >= left && step > 0) {
      const double t = left / step;
      return {lerp(path[i].centre, path[i + 1].centre, t), path[i].radius * (1 - t) + path[i + 1].radius * t};
    }
    left -= step;
  }
  return path.back();
}

/// The centres along an edge between two junctions.
struct JunctionBridge {
  double length = 0;
  double least_radius = 0;
  Circle middle;
  const AxisEdge* edge = nullptr;
};

JunctionBridge bridge_of(const AxisTriangles& axis, const AxisEdge& edge) {
  std::vector<Circle> path{axis.cluster(axis.cluster_of(edge.half_edges[0])).circle};
  for (const Index h : edge.half_edges) path.push_back(axis.cluster(axis.cluster_of(axis.twin(h))).circle);
  JunctionBridge bridge{0, path[0].radius, {}, &edge};
  for (std::size_t i = 1; i < path.size(); ++i) {
    bridge.length += distance(path[i - 1].centre, path[i].centre);
    bridge.least_radius = std::min(bridge.least_radius, path[i].radius);
  }
  bridge.middle = middle_of(path, bridge.length);
  return bridge;
}

bool faces_concave_boundary(const AxisTriangles& axis, const BoundaryCurve& curve,
                            const BoundarySamples& samples, const JunctionBridge& bridge) {
  constexpr double least_turn =
      0.3;  // radians within a radius: a fillet of up to 3 radii, or a reflex corner
  for (const Index h : bridge.edge->half_edges) {
    const BoundarySample& left = samples.samples[axis.left(h)];
    const BoundarySample& right = samples.samples[axis.right(h)];
    if (left.loop != right.loop) return false;
    for (const BoundarySample* sample : {&left, &right})
      if (curve.turning({sample->loop, sample->segment, sample->t}, bridge.least_radius) > -least_turn)
        return false;
  }
  return true;
}

}  // namespace

double PruneTolerance::at(Index sample) const {
  if (fixed_ > 0) return fixed_;
  const BoundarySample& at = samples_.samples[sample];
  return std::max(curve_.tolerance(at.loop, at.segment), noise());
}

bool PruneTolerance::is_vertex(const Circle& disc, Sector sector) const {
  const BoundarySample& before = samples_.samples[previous_sample(samples_, sector.first)];
  const BoundarySample& after = samples_.samples[next_sample(samples_, sector.last)];
  if (fixed_ > 0 || !curve_.is_exact(before.loop)) return false;
  const double from = curve_.position({before.loop, before.segment, before.t});
  double to = curve_.position({after.loop, after.segment, after.t});
  if (to <= from) to += curve_.length(before.loop);
  BoundaryPlace vertex;
  const auto circle = osculating_circle(curve_, {before.loop, from, to}, disc, vertex);
  return circle && curve_.nearest(circle->centre, run_of(curve_, samples_, sector)).distance >
                       circle->radius - curve_.tolerances().contact;
}

double PruneTolerance::noise() const {
  return std::max(4 * curve_.noise(), curve_.tolerances().contact);
}

double protrusion(const Circle& tip, const Circle& inner) {
  return distance(tip.centre, inner.centre) + tip.radius - inner.radius;
}

void prune(AxisTriangles& axis, const PruneTolerance& tolerance) {
  Pruner(axis, tolerance).run();
}

void merge_junctions(AxisTriangles& axis, const BoundaryCurve& curve, const BoundarySamples& samples,
                     bool crossings, double noise) {
  if (!crossings && curve.noise() == 0) return;  // contraction has left nothing that is shorter
  const AxisGraph graph = axis.march();
  std::vector<JunctionBridge> bridges;
  for (const AxisEdge& edge : graph.edges) {
    if (edge.start == no_index || edge.start == edge.end) continue;
    if (graph.nodes[edge.start].out.size() < 3 || graph.nodes[edge.end].out.size() < 3) continue;
    const JunctionBridge bridge = bridge_of(axis, edge);
    const bool crossing = crossings && bridge.length < 2 * bridge.least_radius &&
                          faces_concave_boundary(axis, curve, samples, bridge);
    if (crossing || bridge.length < noise) bridges.push_back(bridge);
  }
  std::stable_sort(bridges.begin(), bridges.end(),
                   [](const JunctionBridge& a, const JunctionBridge& b) { return a.length < b.length; });
  for (const JunctionBridge& bridge : bridges) {
    const std::vector<Index>& passed = bridge.edge->half_edges;
    const Index start = axis.cluster_of(passed.front()), end = axis.cluster_of(axis.twin(passed.back()));
    const Cluster a = axis.cluster(start), b = axis.cluster(end);
    if (start == end || distance(a.circle.centre, b.circle.centre) > 2 * bridge.least_radius) continue;
    for (const Index h : passed) axis.close(h, start);
    Cluster& joined = axis.cluster(start);
    joined = b.merged && !a.merged ? b : a;
    if (!a.merged && !b.merged) joined.circle = bridge.middle;
    joined.merged = true;
  }
}

}  // namespace beadmesh
