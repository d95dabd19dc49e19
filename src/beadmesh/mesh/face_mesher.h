// An ordinary face, from its boundary nodes to a smooth quad mesh.
#pragma once

#include "beadmesh/core/result.h"
#include "beadmesh/flatten/flat_face.h"
#include "beadmesh/mesh/planar_mesh.h"
#include "beadmesh/mesh/washers.h"

namespace beadmesh {

struct FaceMesherOptions {
  double size = 5;        ///< default 5 mm: target element length
  double min_edge = 2.5;  ///< default 2.5 mm: minimum element length
  std::vector<Washer> washers = {};
};

/// Washers first, then subdivision, topological clean-up, smoothing. Nodes of the loops keep their indices.
/// Fails with mesh.*.
Result<PlanarMesh> mesh_face(const NodeLoops& loops, const SurfaceMap& map,
                             const FaceMesherOptions& options = {});

}  // namespace beadmesh
