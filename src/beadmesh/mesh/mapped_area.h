// Loops with four corners and equal opposite counts, mapped. Internal to the room.
#pragma once

#include "beadmesh/mesh/mesh_draft.h"
#include "beadmesh/mesh/node_loop.h"

namespace beadmesh {

/// Fills the loop with a regular grid (transfinite, Gordon and Hall 1973) where its angles show four corners
/// with equal counts on opposite sides and every quad comes out well. False, and nothing added, elsewhere.
bool fill_by_mapping(MeshDraft& draft, const NodeLoop& loop, const std::vector<double>& angles);

}  // namespace beadmesh
