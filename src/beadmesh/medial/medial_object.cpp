#include "beadmesh/medial/medial_object.h"

#include <algorithm>
#include <cmath>

#include "beadmesh/delaunay/triangulation.h"
#include "beadmesh/medial/axis_geometry.h"
#include "beadmesh/medial/axis_pruning.h"
#include "beadmesh/medial/sample_refinement.h"

namespace beadmesh {
namespace {

constexpr int refinement_rounds = 24;
constexpr std::size_t most_samples_per_point = 64;
constexpr int contact_rounds = 6;

struct SampledRegion {
  BoundarySamples samples;
  Triangulation triangulation;
};

Result<Triangulation> triangulated(const BoundarySamples& samples) {
  std::vector<Vec2> points;
  std::vector<std::vector<Index>> loops(samples.first.size() - 1);
  for (const BoundarySample& sample : samples.samples) {
    loops[sample.loop].push_back(static_cast<Index>(points.size()));
    points.push_back(sample.point);
  }
  return triangulate(points, loops);
}

/// Section 3.1: samples as dense as the local thickness asks for.
Result<SampledRegion> sampled_region(const BoundaryCurve& curve, const SamplingOptions& options) {
  BoundarySamples samples = sample_boundary(curve.tagged_region(), options);
  const std::size_t most = most_samples_per_point * samples.samples.size() + 1000;
  Result<Triangulation> triangulation = triangulated(samples);
  for (int round = 0; triangulation && round < refinement_rounds; ++round) {
    std::optional<BoundarySamples> refined = refined_samples(samples, *triangulation, curve);
    if (!refined || refined->samples.size() > most) break;
    Result<Triangulation> next = triangulated(*refined);
    if (!next)
      break;  // points on a bulging curve may cross a boundary that nearly touches; the coarser ones do not
    samples = std::move(*refined);
    triangulation = std::move(next);
  }
  if (!triangulation) return Failure(triangulation.error());
  return SampledRegion{std::move(samples), std::move(*triangulation)};
}

Foot foot_of(const BoundaryCurve& curve, const Contact& contact) {
  return {curve.polyline_point(contact.loop, contact.segment, contact.t), contact.loop,
          curve.position(contact.loop, contact.segment, contact.t)};
}

MedialPoint point_of(const BoundaryCurve& curve, const Circle& circle, const Contact& left,
                     const Contact& right) {
  MedialPoint point{circle.centre, circle.radius, {foot_of(curve, left), foot_of(curve, right)}, 0};
  if (circle.radius > 0)
    point.subtended_angle = angle_between(left.point - circle.centre, right.point - circle.centre);
  return point;
}

MedialVertexType vertex_type(const AxisTriangles& axis, const AxisNode& node) {
  if (node.out.empty()) return MedialVertexType::isolated;
  if (node.out.size() > 1) return MedialVertexType::J;
  return axis.cluster(axis.find(node.triangle)).corner != no_index ? MedialVertexType::C
                                                                   : MedialVertexType::S;
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
  double integral = 0;
  edge.length = 0;
  edge.thickness = {2 * edge.points[0].radius, 0, 2 * edge.points[0].radius};
  for (std::size_t i = 0; i < n; ++i) {
    edge.thickness.min = std::min(edge.thickness.min, 2 * edge.points[i].radius);
    edge.thickness.max = std::max(edge.thickness.max, 2 * edge.points[i].radius);
    if (i >= steps) continue;
    const MedialPoint& next = edge.points[(i + 1) % n];
    const double step = distance(edge.points[i].point, next.point);
    edge.length += step;
    integral += step * (edge.points[i].radius + next.radius);
  }
  edge.thickness.mean = edge.length > 0 ? integral / edge.length : edge.thickness.max;
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
  Assembler(const AxisTriangles& axis, const AxisGraph& graph, const PlacedAxis& placed,
            const BoundaryCurve& curve)
      : axis_(axis), graph_(graph), placed_(placed), curve_(curve) {}

  MedialObject run() {
    MedialObject object;
    object.loops = curve_.loops();
    object.size = curve_.size();
    for (std::size_t i = 0; i < graph_.nodes.size(); ++i) add_vertex(object, i);
    for (std::size_t i = 0; i < graph_.edges.size(); ++i) add_edge(object, i);
    return object;
  }

 private:
  void add_vertex(MedialObject& object, std::size_t i) const {
    const AxisNode& node = graph_.nodes[i];
    const PlacedNode& placed = placed_.nodes[i];
    MedialVertex vertex;
    vertex.type = vertex_type(axis_, node);
    vertex.point = placed.circle.centre;
    vertex.radius = placed.circle.radius;
    vertex.merged = placed.merged;
    for (const Contact& foot : placed.feet) vertex.touching_points.push_back(foot_of(curve_, foot));
    vertex.edges.assign(node.out.size(), no_index);
    object.vertices.push_back(std::move(vertex));
  }

  static std::size_t slot_of(const AxisNode& node, Index half_edge) {
    return static_cast<std::size_t>(std::find(node.out.begin(), node.out.end(), half_edge) -
                                    node.out.begin());
  }

  /// The node seen from an edge that leaves it through a half-edge: left is the sector after it, right the
  /// one before.
  MedialPoint leaving(Index node, Index half_edge) const {
    const PlacedNode& placed = placed_.nodes[node];
    const std::size_t degree = graph_.nodes[node].out.size(), slot = slot_of(graph_.nodes[node], half_edge);
    if (placed.feet.size() == 1) return point_of(curve_, placed.circle, placed.feet[0], placed.feet[0]);
    if (degree == 1) return point_of(curve_, placed.circle, placed.feet[0], placed.feet[1]);
    return point_of(curve_, placed.circle, placed.feet[slot], placed.feet[(slot + degree - 1) % degree]);
  }

  void add_edge(MedialObject& object, std::size_t i) const {
    const AxisEdge& from = graph_.edges[i];
    const auto id = static_cast<Index>(i);
    MedialEdge edge;
    edge.start = from.start;
    edge.end = from.end;
    if (from.start == no_index)
      edge.type = MedialEdgeType::N;
    else
      edge.type = edge_type(object.vertices[from.start].type, object.vertices[from.end].type);
    if (from.start != no_index) edge.points.push_back(leaving(from.start, from.half_edges.front()));
    for (const AxisPoint& point : placed_.edges[i])
      edge.points.push_back(point_of(curve_, point.circle, point.feet[0], point.feet[1]));
    if (from.start != no_index) {
      const Index last = axis_.twin(from.half_edges.back());
      edge.points.push_back(leaving(from.end, last));
      std::swap(edge.points.back().feet[0], edge.points.back().feet[1]);
      object.vertices[from.start].edges[slot_of(graph_.nodes[from.start], from.half_edges.front())] = id;
      object.vertices[from.end].edges[slot_of(graph_.nodes[from.end], last)] = id;
    } else if (!edge.points.empty()) {
      start_closed_edge(edge.points);
    }
    if (!edge.points.empty()) measure(edge);
    object.edges.push_back(std::move(edge));
  }

  const AxisTriangles& axis_;
  const AxisGraph& graph_;
  const PlacedAxis& placed_;
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

/// Sections 3.2 to 3.6 on given samples.
struct Axis {
  AxisTriangles triangles;
  AxisGraph graph;
  PlacedAxis placed;
};

Axis axis_of(const SampledRegion& sampled, const BoundaryCurve& curve, const MedialOptions& options) {
  AxisTriangles triangles(sampled.triangulation, sampled.samples);
  const PruneTolerance tolerance(curve, sampled.samples, options.prune_protrusion);
  triangles.contract(options.contraction);
  prune(triangles, tolerance);
  merge_junctions(triangles, curve, sampled.samples, tolerance.noise());
  settle_ends(triangles, curve, sampled.samples, tolerance);
  AxisGraph graph = triangles.march();
  PlacedAxis placed = placed_axis(triangles, graph, curve, sampled.samples, options);
  return {std::move(triangles), std::move(graph), std::move(placed)};
}

}  // namespace

Result<MedialObject> medial_object(const PlanarRegion& region, const MedialOptions& options) {
  if (region.loops.empty()) return fail("medial.region.empty", "the region has no loops");
  const BoundaryCurve curve(region, options.corner_angle);
  Result<SampledRegion> sampled = sampled_region(curve, options.sampling);
  if (!sampled) return Failure(sampled.error());
  for (int round = 0;; ++round) {
    const Axis axis = axis_of(*sampled, curve, options);
    if (const Index missing = missing_holes(axis.graph, curve.loops()); missing != 0)
      return fail("medial.topology",
                  "the axis and the boundary disagree by " + std::to_string(missing) + " holes",
                  "this is an error of the program; please report the face");
    const double tolerance = 1e-9 * curve.size() + 4 * curve.noise();
    const std::vector<Contact> doubtful = doubtful_contacts(axis.graph, axis.placed, tolerance);
    std::optional<BoundarySamples> more;
    if (round < contact_rounds && !doubtful.empty()) more = with_contacts(sampled->samples, doubtful, curve);
    if (!more) return Assembler(axis.triangles, axis.graph, axis.placed, curve).run();
    Result<Triangulation> triangulation = triangulated(*more);
    if (!triangulation) return Assembler(axis.triangles, axis.graph, axis.placed, curve).run();
    sampled->samples = std::move(*more);
    sampled->triangulation = std::move(*triangulation);
  }
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
