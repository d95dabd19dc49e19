#include "beadmesh/mesh/topological_cleanup.h"

#include <numeric>

#include "beadmesh/mesh/local_edits.h"
#include "beadmesh/mesh/mesh_editor.h"
#include "beadmesh/mesh/patch_replacement.h"
#include "beadmesh/mesh/triangle_marriage.h"

namespace beadmesh {
namespace {

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

}  // namespace

CleanupReport clean_up(PlanarMesh& mesh, const SurfaceMap* map,
                       const std::vector<std::array<Index, 2>>& kept_edges, const CleanupOptions& options) {
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
  report.edits += improve_shapes(editor, 0.6);
  report.edits += remove_short_edges(editor);
  report.irregular_after = editor.count_irregular();
  report.trias_after = editor.count_triangles();
  report.renumbered = editor.write_back(mesh);
  return report;
}

}  // namespace beadmesh
