#include "beadmesh/read/cad_facets.h"

#include <Standard_Failure.hxx>
#include <algorithm>
#include <cmath>
#include <utility>

#include "beadmesh/delaunay/triangulation.h"
#include "beadmesh/read/face_boundary.h"
#include "beadmesh/read/face_points.h"
#include "beadmesh/read/parallel.h"
#include "beadmesh/read/triangle_flips.h"

namespace beadmesh {
namespace {

class FaceFacetter {
 public:
  FaceFacetter(const CadTopology& topology, const CadFace& face, FaceSpace space, double chord)
      : topology_(topology), face_(face), space_(std::move(space)), chord_(chord) {}

  FaceNodes facet() {
    polygons_ = boundary_nodes(topology_, face_, space_.stretch, nodes_);
    for (const std::vector<Index>& polygon : polygons_)
      if (polygon.size() < 3) return defective("a loop has fewer than three points");
    stretch_new_nodes();
    nodes_.crossing = find_crossing(polygons_, stretched_, nodes_.points);
    if (nodes_.crossing) return defective("its boundary crosses itself");
    limit_sizes();
    const std::size_t boundary = nodes_.points.size();
    if (!spawn_inner_points(*face_.surface, space_, polygons_, nodes_))
      return defective("its surface is far larger than its edges are fine");
    triangulate_nodes();
    if (!nodes_.defect.empty()) retry_without_inner_points(boundary);
    constexpr int most_rounds = 3;
    for (int round = 0; round < most_rounds && nodes_.defect.empty() && refine(); ++round)
      triangulate_nodes();
    return std::move(nodes_);
  }

 private:
  FaceNodes defective(std::string why) {
    nodes_.triangles.clear();
    nodes_.defect = std::move(why);
    return std::move(nodes_);
  }

  void stretch_new_nodes() {
    while (stretched_.size() < nodes_.uv.size())
      stretched_.push_back(space_.stretched(nodes_.uv[stretched_.size()]));
  }

  void limit_sizes() {
    for (const std::vector<Index>& polygon : polygons_)
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Index a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double length = distance(nodes_.points[a], nodes_.points[b]);
        if (length == 0) continue;  // along a pole
        space_.sizes.limit(stretched_[a], 1.25 * length);
        space_.sizes.limit(stretched_[b], 1.25 * length);
      }
    space_.sizes.smooth();
  }

  void triangulate_nodes() {
    stretch_new_nodes();
    Result<Triangulation> plane = triangulate(stretched_, polygons_);
    if (!plane) {
      nodes_.triangles.clear();
      nodes_.defect = "its boundary bounds no area (" + plane.error().message + ")";
      return;
    }
    nodes_.triangles = std::move(plane->triangles);
    flip_towards_delaunay(stretched_, nodes_.points, nodes_.triangles, plane->neighbours);
  }

  /// Where loops nearly touch themselves, an inner point may have come to lie on them.
  void retry_without_inner_points(std::size_t boundary) {
    nodes_.defect.clear();
    nodes_.points.resize(boundary);
    nodes_.uv.resize(boundary);
    stretched_.resize(boundary);
    triangulate_nodes();
  }

  /// Adds the middle of each facet that is much too far from the surface; returns whether there was one.
  bool refine() {
    const std::size_t before = nodes_.points.size();
    for (const Triangle& t : nodes_.triangles) {
      const Vec3 a = nodes_.points[t[0]], b = nodes_.points[t[1]], c = nodes_.points[t[2]];
      const Vec3 normal = cross(b - a, c - a);
      const Vec2 uv = (nodes_.uv[t[0]] + nodes_.uv[t[1]] + nodes_.uv[t[2]]) / 3;
      const Vec3 point = frame_at(*face_.surface, uv).point;
      if (std::abs(dot(point - a, normal)) <= 2 * chord_ * norm(normal)) continue;
      nodes_.uv.push_back(uv);
      nodes_.points.push_back(point);
    }
    return nodes_.points.size() > before;
  }

  const CadTopology& topology_;
  const CadFace& face_;
  FaceSpace space_;
  double chord_;
  FaceNodes nodes_;
  std::vector<Vec2> stretched_;  // per node
  std::vector<std::vector<Index>> polygons_;
};

double diagonal_of(const CadTopology& topology) {
  std::vector<Vec3> points = topology.vertices;
  for (const CadEdge& edge : topology.edges)
    for (int i = 0; i <= 8 && !edge.is_pole(); ++i) {
      const gp_Pnt p = edge.curve->Value(std::lerp(edge.first, edge.last, i / 8.0));
      points.push_back({p.X(), p.Y(), p.Z()});
    }
  if (points.empty()) return 1;
  Vec3 low = points.front(), high = low;
  for (const Vec3 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return std::max(distance(low, high), 1e-3);
}

/// Damaged files hold transformations of immense scale.
bool is_number(Vec3 p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace

FaceNodes facet_face(const CadTopology& topology, Index face, FaceSpace space, double chord) {
  try {
    FaceNodes nodes = FaceFacetter(topology, topology.faces[face], std::move(space), chord).facet();
    if (std::all_of(nodes.points.begin(), nodes.points.end(), is_number)) return nodes;
    nodes = {};
    nodes.defect = "a coordinate is no number";
    return nodes;
  } catch (const Standard_Failure& failure) {
    FaceNodes nodes;
    nodes.defect = std::string("OpenCASCADE fails on it: ") + failure.GetMessageString();
    return nodes;
  }
}

std::vector<FaceNodes> facet_faces(CadTopology& topology, const ReadOptions& options,
                                   const Context& context) {
  const FacetSize size(options, diagonal_of(topology));
  FaceSpaces spaces = face_spaces(topology, size, context);
  sample_edges(topology, spaces, size);
  std::vector<FaceNodes> result(topology.faces.size());
  for_each_index(result.size(), context, [&](std::size_t f) {
    if (topology.faces[f].broken)
      result[f].defect = "a loop is open, or an edge has no curve on the surface";
    else
      result[f] = facet_face(topology, static_cast<Index>(f), std::move(*spaces[f]), options.chord);
  });
  return result;
}

}  // namespace beadmesh
