// Poor shapes repaired zone by zone: everything the room can do, tried on a few dozen elements.
#pragma once

#include "beadmesh/flatten/flat_face.h"
#include "beadmesh/mesh/planar_mesh.h"

namespace beadmesh {

struct ShapeRepairOptions {
  double size = 5;        ///< default 5 mm: target element length
  double min_edge = 2.5;  ///< default 2.5 mm: minimum element length
  /// Default 0.65: elements with a smaller scaled Jacobian are worked on, and so are those that are as far
  /// from fitting by another criterion: evenness (Jacobian at the Gauss points) under 0.62, sides over twice
  /// the size.
  double wanted = 0.65;
};

/// Around each element that falls short of `wanted` a zone of two to five rings of elements is
/// taken out of the mesh. Its elements are smoothed and edited anew with the zone's outline fixed, or first
/// its inside is meshed again by loop splitting; quads that span flat boundary angles are pillowed. The best
/// zone takes the old one's place if its worst element is clearly better and no edge has become shorter than
/// the minimum. Nodes that are fixed keep their numbers and places; all others may be renumbered.
/// Deterministic. Returns how many zones were exchanged.
int repair_shapes(PlanarMesh& mesh, const SurfaceMap* map, const ShapeRepairOptions& options = {});

}  // namespace beadmesh
