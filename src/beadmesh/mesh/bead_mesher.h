// One bead, meshed by the best method that passes its own checks (section 5 of the paper).
#pragma once

#include "beadmesh/bead/bead.h"
#include "beadmesh/bead/face_study.h"
#include "beadmesh/core/result.h"
#include "beadmesh/medial/medial_object.h"
#include "beadmesh/mesh/bead_control.h"
#include "beadmesh/mesh/bead_mesh.h"

namespace beadmesh {

struct BeadMesherOptions {
  double size = 5;        ///< default 5 mm: target element length
  double min_edge = 2.5;  ///< default 2.5 mm: minimum element length
  /// Per loop: elements along it, even; empty or 0: from the size. Annular beads only.
  std::vector<int> elements_on_loop;
  /// Per loop: arc lengths of nodes that an already meshed neighbour has set, ascending; empty: free.
  std::vector<std::vector<double>> prescribed;
  /// Method and counts that the user asks for; its lengths are those above.
  BeadMeshControl control = {};
};

/// Blocks first, then ridge insertion; smoothed. Blocks have exactly the counts of the control. Fails where
/// neither gives a mesh without inverted elements and without edges below min_edge: the caller then meshes
/// the face as an ordinary one. The failure's message holds all reasons.
Result<BeadMesh> mesh_bead(const FaceStudy& study, const MedialObject& medial, BeadKind kind,
                           const BeadMesherOptions& options = {});

}  // namespace beadmesh
