// Structured quads inside a loop with three, four or five corners.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "beadmesh/mesh/planar_mesh.h"

namespace beadmesh {

/// Quads and new nodes that fill a loop. New nodes are numbered from `first_new` on.
struct PatchFill {
  std::vector<Vec2> new_nodes;
  std::vector<MeshElement> quads;
};

/// Numbers of edges r[i] at the end of side i that belong to the block at corner i + 1, for a patch whose
/// `sides` run from corner to corner: four sides need equal opposite ones (then the result is empty); three
/// and five meet in one inner node and need r[i] + r[i - 2] = sides[i] with all r positive. No value: not
/// fillable so.
std::optional<std::vector<int>> patch_divisions(std::span<const int> sides);

/// Fills a counter-clockwise loop, `loop` and `positions` in step, `corners` ascending places in it (3, 4 or
/// 5). Positions by Coons patches. The divisions must exist.
PatchFill fill_patch(const std::vector<Index>& loop, const std::vector<Vec2>& positions,
                     const std::vector<int>& corners, Index first_new);

}  // namespace beadmesh
