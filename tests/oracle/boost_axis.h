// The medial axis of a polygon as Boost.Polygon's segment Voronoi diagram has it.
#pragma once

#include <vector>

#include "beadmesh/delaunay/planar_region.h"

namespace beadmesh::oracle {

/// A piece of the axis: a straight line, or (height > 0) an arc of a parabola in its own frame, where it is
/// y = (x^2 + height^2) / (2 height) over the directrix y = 0 with the focus at (0, height).
struct AxisArc {
  Vec2 from, to;
  Vec2 origin, along;  ///< the foot of the focus on the directrix, and its direction
  double height = 0, first = 0, last = 0;

  bool is_curved() const { return height > 0; }
  /// At 0: from; at 1: to, but for rounding.
  Vec2 at(double t) const;
  double distance_to(Vec2 p) const;
};

/// What of the diagram lies inside the region and is equidistant from two different pieces of the boundary.
/// The coordinates must be whole numbers of at most 2^30; `region` a checked_region.
std::vector<AxisArc> boost_axis(const PlanarRegion& region);

}  // namespace beadmesh::oracle
