// Inside the read room: loops of lines and circular arcs become a region with exact curves.
#pragma once

#include <vector>

#include "beadmesh/core/result.h"
#include "beadmesh/delaunay/planar_region.h"

namespace beadmesh::read {

/// A line, or the arc through three points; an arc that ends where it starts is a full circle, and `middle`
/// is opposite (SQL/MM).
struct RingPiece {
  Vec2 start, middle, end;
  bool is_arc = false;
  int number = 1;  ///< of the start, as the user counts the points of the loop
};

/// Closed: every piece starts where the one before ends.
using Ring = std::vector<RingPiece>;

/// A checked_region. Arcs become facets of at most 7.5 degrees, finer where another part of the boundary is
/// near the bulge of a facet, so that the polygon has the topology of the curves. Every point is tagged: a
/// corner is where the tangent turns by more than 0.01 degrees. Arcs with a height of less than 1e-8 of their
/// chord are lines. Fails as checked_region does, and with read.wkt.arc: no circle through the points, or an
/// arc that touches or crosses the boundary, or nearly so.
Result<PlanarRegion> region_of_rings(const std::vector<Ring>& rings);

}  // namespace beadmesh::read
