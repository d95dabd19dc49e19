// J, N, C and S triangles of a constrained Delaunay triangulation of boundary samples (section 3.2, table 1).
#pragma once

#include <vector>

#include "beadmesh/delaunay/boundary_samples.h"
#include "beadmesh/delaunay/triangulation.h"

namespace beadmesh {

/// By the number of neighbours: J 3, N 2, C or S 1, isolated 0 (a domain of one triangle, which table 1
/// leaves out).
enum class TriangleType { J, N, C, S, isolated };

struct Circle {
  Vec2 centre;
  double radius = 0;
};

/// Circumscribed circle; of a degenerate triangle the one about its longest side.
Circle circumcircle(Vec2 a, Vec2 b, Vec2 c);

/// The corner of a triangle with one neighbour that lies opposite its only inner edge: the tip of the ear.
Index ear_tip(const Triangulation& triangulation, Index triangle);

/// C or S is decided by the tag of the sample at the tip of the ear.
std::vector<TriangleType> triangle_types(const Triangulation& triangulation, const BoundarySamples& samples);

}  // namespace beadmesh
