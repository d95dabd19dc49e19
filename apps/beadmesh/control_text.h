// Controls of single beads and local sizes as they are given on the command line.
#pragma once

#include <string>
#include <utility>

#include "beadmesh/core/result.h"
#include "beadmesh/mesh/bead_control.h"
#include "beadmesh/mesh/size_field.h"

namespace beadmesh::app {

inline constexpr const char* known_methods = "known: automatic, blocks, ridge, face";

/// "id=3,across=6,size=4" or "at=10:20:5,method=ridge"; keys: id or at, size, min-edge, across, along, rows,
/// method. Fails with usage.bead.
Result<std::pair<BeadSelection, BeadMeshControl>> single_bead_of(const std::string& text);

/// "at=10:20:5,radius=30,size=2.5". Fails with usage.local_size.
Result<LocalSize> local_size_of(const std::string& text);

/// "10:20:5". Fails with usage.keep_edge.
Result<Vec3> kept_edge_of(const std::string& text);

}  // namespace beadmesh::app
