#include "beadmesh/mesh/topological_cleanup.h"

#include <numeric>

#include "beadmesh/mesh/local_edits.h"
#include "beadmesh/mesh/mesh_editor.h"
#include "beadmesh/mesh/patch_replacement.h"
#include "beadmesh/mesh/smoothing.h"
#include "beadmesh/mesh/triangle_marriage.h"

namespace beadmesh {
namespace {

/// Scaled Jacobian below which an element is worth an irregular node.
constexpr double poor_shape = 0.6;

/// Passes over all nodes; after the first only the surroundings of kept edits are visited again.
template <class Improve>
int sweep(MeshEditor& editor, int passes, Improve improve) {
  int edits = 0;
  std::vector<Index> active(editor.mesh().node_count());
  std::iota(active.begin(), active.end(), 0);
  std::vector<Index> touched;
  for (int pass = 0; pass < passes && !active.empty(); ++pass) {
    std::vector<bool> next(editor.mesh().node_count(), false);
    for (const Index node : active) {
      if (!improve(node, touched)) continue;
      ++edits;
      next.resize(editor.mesh().node_count(), false);
      for (const Index other : touched) next[other] = true;
    }
    active.clear();
    for (Index node = 0; node < static_cast<Index>(next.size()); ++node)
      if (next[node]) active.push_back(node);
  }
  return edits;
}

/// Elements that small edits could not help.
int replace_around_poor_shapes(MeshEditor& editor, PatchReplacement& patches) {
  constexpr int max_quads = 60;
  int edits = 0;
  std::vector<Index> touched;
  for (const Index e : poor_elements(editor, poor_shape)) {
    if (!editor.mesh().is_alive(e)) continue;
    const MeshElement corners = editor.mesh().element(e);
    for (int i = 0; i < corner_count(corners); ++i) {
      if (!patches.improve_shape(corners[i], max_quads, touched)) continue;
      ++edits;
      break;
    }
  }
  return edits;
}

/// Edits are judged by shape, so a mesh with elements turned over is smoothed before.
void untangle_first(PlanarMesh& mesh, const SurfaceMap* map, const CleanupOptions& options) {
  const SurfaceNodes nodes(mesh.nodes, map);
  for (const MeshElement& element : mesh.elements) {
    if (signed_quality(nodes, element) > 0) continue;
    SmoothingOptions smoothing;
    smoothing.size = options.size;
    smoothing.min_edge = options.min_edge;
    smooth(mesh, map, smoothing);
    return;
  }
}

}  // namespace

CleanupReport clean_up(PlanarMesh& mesh, const SurfaceMap* map,
                       const std::vector<std::array<Index, 2>>& kept_edges, const CleanupOptions& options) {
  untangle_first(mesh, map, options);
  MeshEditor editor(mesh, map, kept_edges, {options.size, options.min_edge, 0.6});
  CleanupReport report;
  report.irregular_before = editor.count_irregular();
  report.trias_before = editor.count_triangles();
  report.edits += remove_doublets(editor);
  report.edits += marry_triangles(editor);
  const auto locally = [&](Index node, std::vector<Index>& touched) {
    return improve_locally(editor, node, touched);
  };
  report.edits += sweep(editor, options.passes, locally);
  PatchReplacement patches(editor);
  for (const int quads : {20, 60, 150}) {
    report.edits += sweep(editor, options.passes, [&](Index node, std::vector<Index>& touched) {
      return patches.improve(node, quads, touched);
    });
    report.edits += sweep(editor, options.passes, locally) + marry_triangles(editor);
  }
  report.edits += improve_shapes(editor, poor_shape) + replace_around_poor_shapes(editor, patches);
  report.edits += remove_short_edges(editor);
  report.irregular_after = editor.count_irregular();
  report.trias_after = editor.count_triangles();
  report.renumbered = editor.write_back(mesh);
  return report;
}

}  // namespace beadmesh
