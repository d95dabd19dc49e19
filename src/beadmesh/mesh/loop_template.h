// Quads for loops of 3 to 8 nodes, from tables. Internal to the room.
#pragma once

#include "beadmesh/mesh/mesh_draft.h"
#include "beadmesh/mesh/node_loop.h"

namespace beadmesh {

inline constexpr int largest_template = 8;

/// Fills a loop of 3, 4, 5, 6 or 8 nodes with the best of its templates: without and with inner nodes, in all
/// rotations, judged by the scaled Jacobian after the inner nodes were relaxed. False, and nothing added,
/// where every template would repeat a node in an element or an edge of the mesh, or where there is none.
bool fill_by_template(MeshDraft& draft, const NodeLoop& loop);

}  // namespace beadmesh
