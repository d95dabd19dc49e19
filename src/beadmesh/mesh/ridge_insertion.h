// Generic beads by ridge insertion (section 5.2 of the paper): the crest lines become lines of the mesh.
#pragma once

#include "beadmesh/bead/ridge.h"
#include "beadmesh/core/result.h"
#include "beadmesh/delaunay/planar_region.h"
#include "beadmesh/flatten/flat_face.h"
#include "beadmesh/mesh/bead_mesh.h"

namespace beadmesh {

struct RidgeInsertionOptions {
  double size = 5;        ///< default 5 mm: target element length
  double min_edge = 2.5;  ///< default 2.5 mm: minimum element length
};

/// The ridge curves are divided into edges and inserted; since they run to the tips on the boundary, the scar
/// loop of the paper falls apart into one node loop a side, each made even on its stretch of the boundary and
/// filled by the subdivision mesher. Not smoothed. Fails with mesh.ridge.* or mesh.subdivision.*.
Result<BeadMesh> mesh_by_ridge_insertion(const RidgeGraph& ridge, const PlanarRegion& region,
                                         const SurfaceMap& map, const RidgeInsertionOptions& options = {});

}  // namespace beadmesh
