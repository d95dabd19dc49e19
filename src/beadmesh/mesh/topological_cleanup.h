// Fewer irregular nodes by local edits of a quad mesh.
#pragma once

#include "beadmesh/flatten/flat_face.h"
#include "beadmesh/mesh/planar_mesh.h"

namespace beadmesh {

struct CleanupOptions {
  double size = 5;        ///< default 5 mm: target edge length on the surface
  double min_edge = 2.5;  ///< default 2.5 mm: minimum element length
  int passes = 10;        ///< default 10: rounds over the mesh at most
};

struct CleanupReport {
  int irregular_before = 0, irregular_after = 0;
  int trias_before = 0, trias_after = 0;
  int edits = 0;
  std::vector<Index>
      renumbered;  ///< per old node its new number, no_index where it is gone; loop nodes keep theirs
};

/// Doublets removed, triangles married pairwise along paths of quads, 3-3 and 3-5 edits, and patches around
/// irregular nodes replaced by ones with fewer (Bunin 2008, Verma and Tautges 2012). Fixed and crest nodes
/// stay, as do the boundary edges and the edges between two crest / fixed scar nodes listed in `kept_edges`.
/// An edit is kept only where the patch, after a local smoothing, has no inverted element, no edge below
/// min_edge that was not there before, and a better score.
CleanupReport clean_up(PlanarMesh& mesh, const SurfaceMap* map,
                       const std::vector<std::array<Index, 2>>& kept_edges,
                       const CleanupOptions& options = {});

}  // namespace beadmesh
