// Constrained Delaunay triangulation of a region with holes.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "beadmesh/core/result.h"
#include "beadmesh/core/vector.h"

namespace beadmesh {

/// Triangles inside the region only. Slot k of a triangle is the edge opposite its corner k.
struct Triangulation {
  std::vector<Vec2> points;
  std::vector<Triangle> triangles;               ///< counter-clockwise
  std::vector<std::array<Index, 3>> neighbours;  ///< per slot; no_index: a constrained edge (or the outside)
};

/// Every edge (a, b) of `loops` (closed, region on the left, outer and holes in any order) becomes an edge of
/// the result. Points of no loop are free inner points. Exact predicates; O(n log n) in practice; result
/// independent of rounding and, up to cocircular ties, of the order of points. Based on: divide and conquer
/// along a Morton curve (Guibas and Stolfi 1985), constraint insertion (Anglada 1997), outside removed by
/// flood from the loops. Fails (delaunay.*) on fewer than 3 points, duplicates, crossing constraints, naming
/// the points.
Result<Triangulation> triangulate(const std::vector<Vec2>& points,
                                  const std::vector<std::vector<Index>>& loops);

/// Checks: counter-clockwise, neighbours mutual, every constraint an edge, every unconstrained edge locally
/// Delaunay, Euler's formula, the area equals the loops' area. Returns the violations in words; empty where
/// all hold.
std::vector<std::string> verify_triangulation(const Triangulation& triangulation,
                                              const std::vector<std::vector<Index>>& loops);

}  // namespace beadmesh
