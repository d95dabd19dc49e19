#include "beadmesh/mesh/face_mesher.h"

#include <algorithm>

#include "beadmesh/mesh/boundary_row.h"
#include "beadmesh/mesh/joint_motion.h"
#include "beadmesh/mesh/node_motion.h"
#include "beadmesh/mesh/shape_repair.h"
#include "beadmesh/mesh/smoothing.h"
#include "beadmesh/mesh/subdivision_mesher.h"
#include "beadmesh/mesh/surface_nodes.h"
#include "beadmesh/mesh/topological_cleanup.h"

namespace beadmesh {
namespace {

/// The face inside the row, with its own node numbers; the holes follow the row's inner nodes.
NodeLoops inside_of(const NodeLoops& loops, const std::vector<Vec2>& row) {
  NodeLoops inner;
  inner.nodes = row;
  inner.loops.emplace_back();
  for (size_t i = 0; i < row.size(); ++i) inner.loops[0].push_back(Index(i));
  for (size_t l = 1; l < loops.loops.size(); ++l) {
    inner.loops.emplace_back();
    for (Index n : loops.loops[l]) {
      inner.loops.back().push_back(Index(inner.nodes.size()));
      inner.nodes.push_back(loops.nodes[n]);
    }
  }
  return inner;
}

/// Puts the row around the mesh of the inside: nodes of `loops` first, as the contract says.
PlanarMesh with_row(const NodeLoops& loops, const NodeLoops& inner, const PlanarMesh& inside) {
  PlanarMesh out;
  out.nodes = loops.nodes;
  out.freedom.assign(loops.nodes.size(), NodeFreedom::fixed);
  const size_t row_size = inner.loops[0].size();
  std::vector<Index> global(inside.nodes.size(), no_index);
  for (size_t l = 1; l < loops.loops.size(); ++l)
    for (size_t i = 0; i < loops.loops[l].size(); ++i) global[inner.loops[l][i]] = loops.loops[l][i];
  for (size_t n = 0; n < inside.nodes.size(); ++n) {
    if (global[n] != no_index) continue;
    global[n] = Index(out.nodes.size());
    out.nodes.push_back(inside.nodes[n]);
    out.freedom.push_back(NodeFreedom::free);
  }
  const auto& outer = loops.loops[0];
  for (size_t i = 0; i < row_size; ++i) {
    const size_t j = (i + 1) % row_size;
    out.elements.push_back({outer[i], outer[j], global[j], global[i]});
  }
  for (MeshElement element : inside.elements) {
    for (Index& n : element)
      if (n != no_index) n = global[n];
    out.elements.push_back(element);
  }
  return out;
}

/// As in smoothing: nodes end on the exact surface, lengths are measured on the facets.
constexpr double min_edge_margin = 1.005;
/// Scaled Jacobian that is given up for elements that would fail other criteria.
constexpr double least_shape_of_joint_moves = 0.65;

Result<PlanarMesh> raw_mesh(const NodeLoops& loops, const SurfaceMap& map, const FaceMesherOptions& options) {
  const SubdivisionOptions subdivision{options.size, options.min_edge};
  if (const auto row = boundary_row(loops, {options.size, options.min_edge})) {
    const NodeLoops inner = inside_of(loops, *row);
    if (const auto inside = mesh_by_subdivision(inner, &map, subdivision))
      return with_row(loops, inner, *inside);
  }
  return mesh_by_subdivision(loops, &map, subdivision);
}

Result<PlanarMesh> mesh_between(const NodeLoops& loops, const SurfaceMap& map,
                                const FaceMesherOptions& options) {
  auto mesh = raw_mesh(loops, map, options);
  if (!mesh) return mesh;
  const SmoothingOptions smoothing{options.size, options.min_edge};
  smooth(*mesh, &map, smoothing);
  clean_up(*mesh, &map, {}, {options.size, options.min_edge});
  smooth(*mesh, &map, smoothing);
  repair_shapes(*mesh, &map, {options.size, options.min_edge});
  move_jointly(*mesh, &map, {options.size, options.min_edge * min_edge_margin, least_shape_of_joint_moves});
  return mesh;
}

/// Worst scaled Jacobian that a face with washers may show; else it is meshed without.
constexpr double least_shape_of_washers = 0.3;

double worst_shape(const PlanarMesh& mesh, const SurfaceMap& map) {
  const SurfaceNodes nodes(mesh.nodes, &map);
  double worst = 1;
  for (const MeshElement& element : mesh.elements) worst = std::min(worst, signed_quality(nodes, element));
  return worst;
}

}  // namespace

Result<PlanarMesh> mesh_face(const NodeLoops& loops, const SurfaceMap& map,
                             const FaceMesherOptions& options) {
  const auto washers = washer_rings(loops, options.washers, options.size, options.min_edge);
  if (!washers.empty())
    if (const auto outside = mesh_between(outside_of_washers(loops, washers), map, options)) {
      PlanarMesh whole = with_washers(loops, washers, *outside);
      if (worst_shape(whole, map) >= least_shape_of_washers) return whole;
    }
  return mesh_between(loops, map, options);
}

}  // namespace beadmesh
