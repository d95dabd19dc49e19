// Quads inside fixed node loops by recursive loop splitting (section 5.2 of the paper, its reference 27).
#pragma once

#include "beadmesh/flatten/flat_face.h"
#include "beadmesh/mesh/planar_mesh.h"

namespace beadmesh {

struct SubdivisionOptions {
  double size = 5;  ///< default 5 mm: target edge length, measured on the surface
  double min_edge =
      2.5;  ///< default 2.5 mm: minimum element length; aimed at here, enforced by the smoothing
};

/// Fills the loops with quads. Where the face is wide, a regular lattice fitted to the loops takes its
/// inside; what is left over along the loops, or the whole narrow face, is split: holes and scars joined by
/// connections, walked there and back, then the single loop recursively down to templates of 4, 6 and 8 nodes
/// or mapped areas. Several weightings are tried per area, and the best piece is kept. All quads where the
/// total number of loop nodes is even; otherwise exactly one triangle. `map` null: the plane is the surface.
/// The result passes verify_planar_mesh; elements may still be poorly shaped. Nodes of the loops keep their
/// indices 0 .. nodes.size() - 1 and are fixed. Fails with mesh.subdivision.* on loops that cross or touch
/// where they should not.
Result<PlanarMesh> mesh_by_subdivision(const NodeLoops& loops, const SurfaceMap* map,
                                       const SubdivisionOptions& options = {});

}  // namespace beadmesh
