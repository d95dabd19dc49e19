// The Delaunay triangulation of points. Internal to this room.
#pragma once

#include <utility>
#include <vector>

#include "beadmesh/delaunay/edge_net.h"

namespace beadmesh::delaunay {

struct PointOrder {
  std::vector<Index> input;  ///< per point of the net: its index in the caller's array
  std::vector<std::pair<Index, Index>>
      duplicates;  ///< equal points, by the caller's indices; empty where all differ
};

/// Fills the empty `net` with the points in an order that keeps neighbours together (Morton order).
PointOrder put_points(const std::vector<Vec2>& points, EdgeNet& net);

/// Connects the points of the net, as put_points has ordered them and all different, to their Delaunay
/// triangulation. Returns an edge of the hull with the outside on its left. O(n log n) at most. Based on:
/// Guibas, Stolfi 1985 (merge step); Dwyer 1987 (cuts in both directions), here along the Morton curve.
Index connect_delaunay(EdgeNet& net);

}  // namespace beadmesh::delaunay
