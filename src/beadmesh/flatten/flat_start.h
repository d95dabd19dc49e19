// First layouts of a facetted piece in the plane, for the rigid layout to start from.
#pragma once

#include <optional>
#include <vector>

#include "beadmesh/flatten/triangle_geometry.h"
#include "beadmesh/flatten/triangle_topology.h"

namespace beadmesh {

/// Rotations of the rest triangles (unit complex numbers) such that neighbours lie as if unrolled over their
/// common edge. Starts from `guess` (its turns from triangle to triangle must be right to within half a
/// turn), or, where that is empty, from unrolling breadth first; the misfits are spread by least squares over
/// all edges. Exact for developable pieces, cut cylinders included. Takes the place of LSCM, whose scale runs
/// away on long strips.
std::vector<Vec2> unrolled_rotations(const std::vector<Triangle>& triangles,
                                     const TriangleNeighbours& neighbours,
                                     const std::vector<RestTriangle>& rest,
                                     const std::vector<Vec2>& guess = {});

/// Barycentric embedding (Tutte 1963) with loop `outer` on a circle and the other loops spanned by virtual
/// fans. No triangle is turned over. Nothing where the system cannot be solved.
std::optional<std::vector<Vec2>> tutte_layout(const Facets& facets);

}  // namespace beadmesh
