// Judging a freshly meshed piece, so that the better of several can be kept. Internal to the room.
#pragma once

#include "beadmesh/mesh/mesh_draft.h"

namespace beadmesh {

struct Judgement {
  double cost = 1e300;
  double worst = -1;  ///< least scaled Jacobian
};

/// Moves the nodes added since the mark to better places (length-weighted Laplace, never to a worse worst
/// corner) and returns the cost of the elements added since: squared lack of scaled Jacobian, more where it
/// is poor, edges far below the size, irregular nodes.
Judgement relax_and_judge(MeshDraft& draft, const MeshDraft::Mark& mark);

}  // namespace beadmesh
