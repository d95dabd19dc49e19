// Several loops joined to one by lines that are walked there and back. Internal to the room.
#pragma once

#include "beadmesh/mesh/mesh_draft.h"
#include "beadmesh/mesh/node_loop.h"

namespace beadmesh {

/// Loops of one area, the outer one first. The nearest hole or scar is joined first; its line has the lowest
/// cost of angles and misfit among the visible ones, in that of the two parities of its edges which more of
/// the good lines share. A loop that has a node in common with what is joined already needs no line. Empty
/// where some loop sees nothing.
NodeLoop connect_loops(MeshDraft& draft, const std::vector<NodeLoop>& loops, bool against_vote = false);

}  // namespace beadmesh
