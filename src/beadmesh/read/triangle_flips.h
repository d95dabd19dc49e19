// Inside the read room: better triangles on the same points.
#pragma once

#include <array>
#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh {

/// Flips inner edges until the two angles opposite each sum to at most 180 degrees in space, as long as the
/// triangles stay valid in the plane. Slot k of `neighbours` is the edge opposite corner k; edges without a
/// neighbour stay. Based on: Lawson, "Software for C1 surface interpolation", 1977.
void flip_towards_delaunay(const std::vector<Vec2>& plane, const std::vector<Vec3>& space,
                           std::vector<Triangle>& triangles, std::vector<std::array<Index, 3>>& neighbours);

}  // namespace beadmesh
