#include <algorithm>
#include <cmath>
#include <optional>

#include "beadmesh/medial/axis_geometry.h"
#include "beadmesh/medial/circle_fit.h"
#include "beadmesh/medial/osculating_circle.h"

namespace beadmesh {
namespace {

class NodePlacer {
 public:
  NodePlacer(const AxisOnBoundary& axis, bool polished)
      : axis_(axis.triangles), curve_(axis.curve), samples_(axis.samples), polished_(polished) {}

  PlacedNode place(const AxisNode& node) const {
    const Cluster& cluster = axis_.cluster(axis_.find(node.triangle));
    if (cluster.corner != no_index)
      return {cluster.circle, {contact_of(cluster.corner, cluster.circle.centre)}, {}, true};
    if (node.out.empty()) return place_isolated(cluster.circle);
    if (node.out.size() == 1) return place_end(cluster.circle, node.out[0]);
    return place_junction(cluster, node.out);
  }

 private:
  SegmentRun run_after(Index half_edge) const {
    return run_of(curve_, samples_, axis_.sector_after(half_edge));
  }

  Contact contact_of(Index sample, Vec2 from) const {
    const BoundarySample& at = samples_.samples[sample];
    return {{at.loop, at.segment, at.t}, at.point, distance(at.point, from)};
  }
  Contact contact_at(const BoundaryPlace& place, Vec2 from) const {
    const Vec2 point = curve_.point(place);
    return {place, point, distance(point, from)};
  }

  PlacedNode place_junction(const Cluster& cluster, const std::vector<Index>& out) const {
    std::vector<SegmentRun> runs;
    for (const Index h : out) runs.push_back(run_after(h));
    PlacedNode placed{cluster.circle, {}, {}};
    placed.merged = placed.crossing = cluster.merged;
    if (polished_ && cluster.merged)
      placed.feet = polish_merged(curve_, runs, placed.circle);
    else if (polished_)
      placed.feet = polish(curve_, runs, placed.circle);
    if (placed.feet.empty()) {
      placed = unmoved(cluster.circle, runs);
      placed.crossing = cluster.merged;
      placed.settled = !polished_;
    }
    // Contraction may have joined junctions a little apart: no disc touches all their sectors then.
    for (const Contact& foot : placed.feet)
      if (foot.distance > placed.circle.radius + curve_.tolerances().rounding && out.size() > 3)
        placed.merged = true;
    if (!placed.merged)
      for (const Index h : out) add_interval(placed, axis_.sector_after(h));
    return placed;
  }

  PlacedNode unmoved(Circle circle, const std::vector<SegmentRun>& runs) const {
    PlacedNode placed{circle, feet_of(curve_, runs, circle.centre), {}};
    placed.circle.radius = placed.feet[0].distance;
    for (const Contact& foot : placed.feet)
      placed.circle.radius = std::min(placed.circle.radius, foot.distance);
    return placed;
  }

  /// The samples of a sector that the disc's line passes, first and last; no_index where there is none.
  Sector reached(const Circle& circle, Sector sector, double band) const {
    Sector found;
    for (Index i = sector.first;; i = next_sample(samples_, i)) {
      if (std::abs(distance(samples_.samples[i].point, circle.centre) - circle.radius) <= band) {
        if (found.first == no_index) found.first = i;
        found.last = i;
      }
      if (i == sector.last) return found;
    }
  }

  double position(Index sample) const {
    const BoundarySample& at = samples_.samples[sample];
    return curve_.position({at.loop, at.segment, at.t});
  }

  /// A finite contact zone: longer than what any tangent circle keeps within the band.
  void add_interval(PlacedNode& placed, Sector sector) const {
    const double radius = placed.circle.radius;
    const bool exact = curve_.is_exact(samples_.samples[sector.first].loop);
    const double band = exact ? curve_.tolerances().contact : std::max(1e-3 * radius, 2 * curve_.noise());
    const Sector on = reached(placed.circle, sector, band);
    if (on.first == no_index || on.first == on.last) return;
    const Index loop = samples_.samples[on.first].loop;
    const double start = position(on.first), end = position(on.last);
    if (std::fmod(end - start + curve_.length(loop), curve_.length(loop)) < 0.3 * radius) return;
    placed.intervals.push_back({loop, start, end});
  }

  /// On an exact curve the end is the centre of curvature at its vertex; an arc has one contact all along.
  std::optional<PlacedNode> place_at_vertex(const Circle& start, Sector sector, const SegmentRun& run) const {
    const Index loop = samples_.samples[sector.first].loop;
    double from = position(previous_sample(samples_, sector.first)),
           to = position(next_sample(samples_, sector.last));
    if (to <= from) to += curve_.length(loop);
    BoundaryPlace vertex;
    const auto circle = osculating_circle(curve_, {loop, from, to}, start, vertex);
    if (!circle ||
        curve_.nearest(circle->centre, run).distance < circle->radius - curve_.tolerances().contact)
      return std::nullopt;
    const Contact tip = contact_at(vertex, circle->centre);
    PlacedNode placed{*circle, {tip, tip, tip}, {}, true};
    add_interval(placed, sector);
    if (placed.intervals.empty()) return placed;
    const ContactInterval& arc = placed.intervals[0];
    const double length = curve_.length(arc.loop);
    const double middle = arc.start + std::fmod(arc.end - arc.start + length, length) / 2;
    placed.feet = {contact_at(curve_.place_at(arc.loop, arc.start), circle->centre),
                   contact_at(curve_.place_at(arc.loop, arc.end), circle->centre),
                   contact_at(curve_.place_at(arc.loop, middle), circle->centre)};
    return placed;
  }

  /// The contact of a smooth end: all samples of its sector that the disc reaches, but at least the nearest
  /// point.
  PlacedNode place_end(Circle circle, Index out) const {
    const Sector sector = axis_.sector_after(out);
    const SegmentRun run = run_of(curve_, samples_, sector);
    const Contact nearest = curve_.nearest(circle.centre, run);
    if (polished_)
      if (auto placed = place_at_vertex(circle, sector, run)) return *placed;
    const Sector on = reached(circle, sector, std::max(2e-3 * circle.radius, 2 * curve_.noise()));
    circle.radius = nearest.distance;
    const bool is_point = on.first == no_index || curve_.is_exact(nearest.place.loop);
    if (is_point) return {circle, {nearest, nearest, nearest}, {}, true};
    const Index loop = nearest.place.loop;
    const double length = curve_.length(loop), start = position(on.first), end = position(on.last);
    const double middle = start + std::fmod(end - start + length, length) / 2;
    PlacedNode placed{circle,
                      {contact_of(on.first, circle.centre), contact_of(on.last, circle.centre),
                       contact_at(curve_.place_at(loop, middle), circle.centre)},
                      {},
                      true};
    add_interval(placed, sector);
    return placed;
  }

  /// A full disc touches everywhere; a domain of one triangle is treated alike.
  PlacedNode place_isolated(Circle circle) const {
    std::vector<Vec2> points;
    for (const BoundarySample& sample : samples_.samples) points.push_back(sample.point);
    if (const auto fit = fitted_circle(points, circle); fit && points.size() > 3) circle = *fit;
    const Contact nearest = curve_.nearest(circle.centre, SegmentRun{0, 0, curve_.segments(0)});
    PlacedNode placed{{circle.centre, nearest.distance}, {nearest}, {}};
    const double start = curve_.position(nearest.place), length = curve_.length(0);
    for (const double part : {1.0 / 3, 2.0 / 3})
      placed.feet.push_back(contact_at(curve_.place_at(0, start + part * length), circle.centre));
    return placed;
  }

  const AxisTriangles& axis_;
  const BoundaryCurve& curve_;
  const BoundarySamples& samples_;
  bool polished_;
};

}  // namespace

std::vector<PlacedNode> placed_nodes(const AxisOnBoundary& axis, bool polished) {
  const NodePlacer placer(axis, polished);
  std::vector<PlacedNode> placed;
  placed.reserve(axis.graph.nodes.size());
  for (const AxisNode& node : axis.graph.nodes) placed.push_back(placer.place(node));
  return placed;
}

std::array<Contact, 2> feet_leaving(const PlacedNode& placed, Index slot) {
  const auto count = static_cast<Index>(placed.feet.size());
  if (placed.is_end) return {placed.feet[0], placed.feet[count > 1 ? 1 : 0]};
  return {placed.feet[slot], placed.feet[(slot + count - 1) % count]};
}

std::vector<BoundaryPlace> torn_contacts(const std::vector<PlacedNode>& nodes, const BoundaryCurve& curve) {
  std::vector<BoundaryPlace> torn;
  for (const PlacedNode& node : nodes) {
    if (node.is_end || node.crossing || node.feet.size() < 4) continue;
    double spread = 0;
    bool facetted = false;
    for (const Contact& foot : node.feet) {
      spread = std::max(spread, foot.distance - node.circle.radius);
      facetted |= curve.is_facet(foot.place.loop, foot.place.segment);
    }
    if (facetted || spread <= curve.tolerances().contact) continue;
    for (const Contact& foot : node.feet) torn.push_back(foot.place);
  }
  return torn;
}

std::vector<BoundaryPlace> doubtful_contacts(const AxisGraph& graph, const std::vector<PlacedNode>& nodes,
                                             double tolerance) {
  std::vector<BoundaryPlace> doubtful;
  const auto add = [&](const PlacedNode& node) {
    for (const Contact& foot : node.feet)
      if (foot.place.t > 0 && foot.place.t < 1) doubtful.push_back(foot.place);
  };
  const auto holds_foot = [&](const PlacedNode& a, const PlacedNode& b) {
    return !a.merged && !b.merged && std::any_of(b.feet.begin(), b.feet.end(), [&](const Contact& foot) {
      return distance(foot.point, a.circle.centre) < a.circle.radius - tolerance;
    });
  };
  for (const PlacedNode& node : nodes)
    if (!node.settled) add(node);
  for (const AxisEdge& edge : graph.edges) {
    if (edge.start == no_index || edge.start == edge.end) continue;
    const PlacedNode &start = nodes[edge.start], &end = nodes[edge.end];
    if (!holds_foot(start, end) && !holds_foot(end, start)) continue;
    add(start);
    add(end);
  }
  return doubtful;
}

}  // namespace beadmesh
