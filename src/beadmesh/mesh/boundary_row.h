// A row of quads along a smooth outer boundary.
#pragma once

#include <optional>
#include <vector>

#include "beadmesh/mesh/planar_mesh.h"

namespace beadmesh {

struct BoundaryRowOptions {
  double size = 5;        ///< default 5 mm: target element length
  double min_edge = 2.5;  ///< default 2.5 mm: minimum element length
};

/// Inner ends of a row of quads along the outer loop, one a node of it. Where a boundary is round, a mesh
/// that ends on it with grid corners has quads with three nodes almost in a line (scaled Jacobian 0.2);
/// behind a row those corners become inner nodes of valence 3. None where the loop has a corner over 40
/// degrees, where the row would make edges under min_edge, fold, or come near a hole.
std::optional<std::vector<Vec2>> boundary_row(const NodeLoops& loops, const BoundaryRowOptions& options = {});

}  // namespace beadmesh
