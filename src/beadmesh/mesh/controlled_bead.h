// One bead, meshed as the user asks where that can be done.
#pragma once

#include "beadmesh/mesh/bead_mesher.h"

namespace beadmesh {

/// mesh_bead with the counts of the control. Where they cannot be met together (an edge under the minimum, an
/// inverted element, no room), as few of them as possible are given up, elements across last;
/// BeadMesh::refusals says which and why. Rings pass over clamp rows, ridge insertion over all counts. Fails
/// like mesh_bead.
Result<BeadMesh> mesh_bead_as_asked(const FaceStudy& study, const MedialObject& medial, BeadKind kind,
                                    const BeadMesherOptions& options);

}  // namespace beadmesh
