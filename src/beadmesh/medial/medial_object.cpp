#include "beadmesh/medial/medial_object.h"

#include <algorithm>
#include <cmath>

#include "beadmesh/medial/axis_geometry.h"
#include "beadmesh/medial/axis_pruning.h"
#include "beadmesh/medial/radius_along.h"

namespace beadmesh {
namespace {

constexpr int contact_rounds = 6;
constexpr double finer = 1e-2, least_contraction = 1e-9;  // of a torn junction

Foot foot_of(const BoundaryCurve& curve, const BoundaryPlace& place) {
  return {curve.point(place), place.loop, curve.position(place)};
}

MedialPoint point_of(const BoundaryCurve& curve, const Circle& circle, const BoundaryPlace& left,
                     const BoundaryPlace& right) {
  MedialPoint point{circle.centre, circle.radius, {foot_of(curve, left), foot_of(curve, right)}, 0};
  if (circle.radius > 0)
    point.subtended_angle =
        angle_between(point.feet[0].point - circle.centre, point.feet[1].point - circle.centre);
  return point;
}

MedialVertexType vertex_type(const AxisNode& node) {
  if (node.out.empty()) return MedialVertexType::isolated;
  if (node.out.size() > 1) return MedialVertexType::J;
  return node.is_corner ? MedialVertexType::C : MedialVertexType::S;
}

MedialEdgeType edge_type(MedialVertexType a, MedialVertexType b) {
  using V = MedialVertexType;
  const auto is = [&](V x, V y) { return (a == x && b == y) || (a == y && b == x); };
  if (is(V::S, V::S)) return MedialEdgeType::SS;
  if (is(V::S, V::C)) return MedialEdgeType::SC;
  if (is(V::S, V::J)) return MedialEdgeType::SJ;
  if (is(V::C, V::C)) return MedialEdgeType::CC;
  if (is(V::C, V::J)) return MedialEdgeType::CJ;
  return MedialEdgeType::JJ;
}

void measure(MedialEdge& edge) {
  const std::size_t n = edge.points.size(), steps = edge.type == MedialEdgeType::N ? n : n - 1;
  double integral = 0, least = edge.points[0].radius, greatest = least;
  edge.length = 0;
  for (std::size_t i = 0; i < steps; ++i) {
    const MedialPoint &from = edge.points[i], &to = edge.points[i + 1 < n ? i + 1 : 0];
    const double step = distance(from.point, to.point);
    const RadiusAlong radius(from, to);
    edge.length += step;
    integral += step * radius.mean();
    least = std::min(least, radius.least());
    greatest = std::max(greatest, radius.greatest());
  }
  const double mean = edge.length > 0 ? integral / edge.length : greatest;
  edge.thickness = {2 * least, 2 * std::clamp(mean, least, greatest), 2 * greatest};
}

/// A closed edge runs counter-clockwise and starts at its leftmost, then lowest point.
void start_closed_edge(std::vector<MedialPoint>& points) {
  double area = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    area += cross(points[i].point, points[(i + 1) % points.size()].point);
  if (area < 0) {
    std::reverse(points.begin(), points.end());
    for (MedialPoint& point : points) std::swap(point.feet[0], point.feet[1]);
  }
  const auto first =
      std::min_element(points.begin(), points.end(), [](const MedialPoint& a, const MedialPoint& b) {
        return a.point.x != b.point.x ? a.point.x < b.point.x : a.point.y < b.point.y;
      });
  std::rotate(points.begin(), first, points.end());
}

/// Puts nodes and edges of the placed axis into the data model of section 3.7.
class Assembler {
 public:
  Assembler(const AxisGraph& graph, const BoundaryCurve& curve) : graph_(graph), curve_(curve) {}

  /// The placed edges are emptied as they are taken over: there may be millions of points.
  MedialObject run(const std::vector<PlacedNode>& nodes, std::vector<PlacedEdge>& edges) const {
    MedialObject object;
    object.loops = curve_.loops();
    object.size = curve_.size();
    object.vertices.reserve(graph_.nodes.size());
    object.edges.reserve(graph_.edges.size());
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) add_vertex(object, graph_.nodes[i], nodes[i]);
    for (std::size_t i = 0; i < graph_.edges.size(); ++i) {
      add_edge(object, static_cast<Index>(i), nodes, edges[i]);
      edges[i] = {};
    }
    return object;
  }

 private:
  void add_vertex(MedialObject& object, const AxisNode& node, const PlacedNode& placed) const {
    MedialVertex vertex;
    vertex.type = vertex_type(node);
    vertex.point = placed.circle.centre;
    vertex.radius = placed.circle.radius;
    vertex.merged = placed.merged;
    for (const Contact& foot : placed.feet)
      vertex.touching_points.push_back({foot.point, foot.place.loop, curve_.position(foot.place)});
    vertex.contact_intervals = placed.intervals;
    vertex.edges.assign(node.out.size(), no_index);
    object.vertices.push_back(std::move(vertex));
  }

  /// The node seen from an edge that leaves it; enters the edge at the node's place for it.
  MedialPoint leaving(MedialObject& object, const std::vector<PlacedNode>& nodes, Index node, Index slot,
                      Index edge) const {
    object.vertices[node].edges[slot] = edge;
    const std::array<Contact, 2> feet = feet_leaving(nodes[node], slot);
    return point_of(curve_, nodes[node].circle, feet[0].place, feet[1].place);
  }

  void add_edge(MedialObject& object, Index id, const std::vector<PlacedNode>& nodes,
                const PlacedEdge& points) const {
    const AxisEdge& from = graph_.edges[id];
    const bool closed = from.start == no_index;
    MedialEdge edge;
    edge.start = from.start;
    edge.end = from.end;
    edge.type = closed ? MedialEdgeType::N
                       : edge_type(object.vertices[from.start].type, object.vertices[from.end].type);
    edge.points.reserve(points.size() + (closed ? 0 : 2));
    if (!closed) edge.points.push_back(leaving(object, nodes, from.start, from.start_slot, id));
    for (const AxisPoint& point : points)
      edge.points.push_back(point_of(curve_, point.circle, point.feet[0], point.feet[1]));
    if (!closed) {
      edge.points.push_back(leaving(object, nodes, from.end, from.end_slot, id));
      std::swap(edge.points.back().feet[0], edge.points.back().feet[1]);
    } else if (!edge.points.empty()) {
      start_closed_edge(edge.points);
    }
    if (!edge.points.empty()) measure(edge);
    object.edges.push_back(std::move(edge));
  }

  const AxisGraph& graph_;
  const BoundaryCurve& curve_;
};

/// Holes minus what the graph says they are; 0 where the march and all contractions were right.
Index missing_holes(const AxisGraph& graph, Index loops) {
  Index closed = 0;
  for (const AxisEdge& edge : graph.edges) closed += edge.start == no_index;
  const auto edges = static_cast<Index>(graph.edges.size()) - closed,
             nodes = static_cast<Index>(graph.nodes.size());
  return loops - 1 - (edges - nodes + 1);
}

/// The axis in place: what is left of the triangulation when it has done its work.
struct PlacedAxis {
  AxisGraph graph;
  std::vector<PlacedNode> nodes;
  std::vector<PlacedEdge> edges;
};

/// Sections 3.2 to 3.6. Where junctions are in doubt, samples are added at their contacts and all is done
/// again.
Result<PlacedAxis> placed_axis(SampledBoundary sampled, const BoundaryCurve& curve,
                               const MedialOptions& options) {
  double contraction = options.contraction;
  for (int round = 0;; ++round) {
    AxisTriangles triangles(sampled.triangulation, sampled.samples);
    const PruneTolerance tolerance(curve, sampled.samples, options.prune_protrusion);
    triangles.contract(contraction);
    prune(triangles, tolerance);
    merge_junctions(triangles, curve, sampled.samples, options.merge_crossings, tolerance.noise());
    settle_ends(triangles, curve, sampled.samples, tolerance);
    PlacedAxis placed{triangles.march(), {}, {}};
    if (const Index missing = missing_holes(placed.graph, curve.loops()); missing != 0)
      return fail("medial.topology",
                  "the axis and the boundary disagree by " + std::to_string(missing) + " holes",
                  "this is an error of the program; please report the face");
    const AxisOnBoundary axis{triangles, placed.graph, curve, sampled.samples};
    placed.nodes = placed_nodes(axis, options.polish);
    const double doubt = curve.tolerances().contact + 4 * curve.noise();
    std::vector<BoundaryPlace> doubtful = doubtful_contacts(placed.graph, placed.nodes, doubt);
    const std::vector<BoundaryPlace> torn = torn_contacts(placed.nodes, curve);
    doubtful.insert(doubtful.end(), torn.begin(), torn.end());
    if (!torn.empty()) contraction = std::max(least_contraction, finer * contraction);
    if (round < contact_rounds && !doubtful.empty()) {
      const bool added = add_samples(sampled, doubtful, curve);
      if (added || (!torn.empty() && contraction > least_contraction)) continue;
    }
    placed.edges = placed_edges(axis, placed.nodes, options);
    return placed;
  }
}

}  // namespace

Result<MedialObject> medial_object(const PlanarRegion& region, const MedialOptions& options) {
  if (region.loops.empty()) return fail("medial.region.empty", "the region has no loops");
  const BoundaryCurve curve(region, options.corner_angle);
  Result<SampledBoundary> sampled = sampled_boundary(curve, options.sampling);
  if (!sampled) return Failure(sampled.error());
  Result<PlacedAxis> placed = placed_axis(std::move(*sampled), curve, options);
  if (!placed) return Failure(placed.error());
  return Assembler(placed->graph, curve).run(placed->nodes, placed->edges);
}

std::string name_of(MedialVertexType type) {
  switch (type) {
    case MedialVertexType::J:
      return "J";
    case MedialVertexType::C:
      return "C";
    case MedialVertexType::S:
      return "S";
    case MedialVertexType::isolated:
      return "isolated";
  }
  return "isolated";
}

std::string name_of(MedialEdgeType type) {
  switch (type) {
    case MedialEdgeType::SS:
      return "S-S";
    case MedialEdgeType::SC:
      return "S-C";
    case MedialEdgeType::SJ:
      return "S-J";
    case MedialEdgeType::CC:
      return "C-C";
    case MedialEdgeType::CJ:
      return "C-J";
    case MedialEdgeType::JJ:
      return "J-J";
    case MedialEdgeType::N:
      return "N";
  }
  return "N";
}

}  // namespace beadmesh
