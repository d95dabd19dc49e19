// Which triangle lies across which edge, and whether a triangulation is a disc with holes.
#pragma once

#include <array>
#include <vector>

#include "beadmesh/core/result.h"
#include "beadmesh/panel/facets.h"

namespace beadmesh {

/// [t][k] = triangle across the edge from corner k to corner k + 1 of triangle t; no_index: none, or not
/// exactly one that runs the other way.
using TriangleNeighbours = std::vector<std::array<Index, 3>>;

TriangleNeighbours triangle_neighbours(const std::vector<Triangle>& triangles);

/// Checks that the facets are finite, consistently oriented, connected over edges and a disc with holes
/// (genus 0, at least one boundary loop), and that facets.loops are the boundary. A vertex where the boundary
/// touches itself is allowed. Fails with flatten.input, .not_manifold, .disconnected, .closed, .not_a_disc,
/// .loops.
Result<TriangleNeighbours> check_disc(const Facets& facets);

}  // namespace beadmesh
