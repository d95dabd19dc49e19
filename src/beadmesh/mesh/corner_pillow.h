// Relief for quads that have three boundary nodes almost in a line.
#pragma once

#include "beadmesh/flatten/flat_face.h"
#include "beadmesh/mesh/planar_mesh.h"

namespace beadmesh {

struct CornerPillowOptions {
  double size = 5;        ///< default 5 mm: target element length
  double min_edge = 2.5;  ///< default 2.5 mm: minimum element length
  double flat_corner =
      radians(150);  ///< default 150 degrees: a single quad at a boundary node may span this much
};

/// Where one quad alone spans a boundary angle over `flat_corner`, its shape is bad whatever the smoothing
/// does. The block of quads around it is shrunk and a ring of quads laid around it (pillowing, Mitchell and
/// Tautges 1995): the boundary node gets two quads, the ends of the block three each. Smooths; each relief is
/// kept only where the worst element around becomes better and no edge falls under min_edge. Returns how many
/// were kept.
int relieve_flat_corners(PlanarMesh& mesh, const SurfaceMap* map, const CornerPillowOptions& options = {});

}  // namespace beadmesh
