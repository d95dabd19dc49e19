// The constrained Delaunay triangulation of points and loops up to their convex hull. Internal to this room.
#pragma once

#include <tl/expected.hpp>
#include <vector>

#include "beadmesh/delaunay/edge_net.h"

namespace beadmesh::delaunay {

/// Why points and loops have no constrained triangulation; points by the caller's indices.
struct NetConflict {
  enum class Kind {
    duplicate,      ///< points a and b are equal
    point_on_edge,  ///< point c lies on the edge (a, b)
    crossing,       ///< the edges (a, b) and (c, d) cross
    repeated_edge,  ///< the edge (a, b) occurs twice, in any direction
  } kind;
  Index a = no_index, b = no_index, c = no_index, d = no_index;
};

struct ConstrainedNet {
  EdgeNet net;
  std::vector<Index> input;         ///< per point of the net: the caller's index
  std::vector<char> is_constraint;  ///< per undirected edge (e / 2): 0, along_even or along_odd
  std::vector<Index> loop_edges;    ///< the directed edges of all loops, loop by loop
  Index outside = no_index;         ///< an edge of the hull with the outside on its left

  static constexpr char along_even = 1, along_odd = 2;
  /// Whether a loop runs along the directed edge e (not against it).
  bool is_along_loop(Index e) const { return is_constraint[e / 2] == (e & 1 ? along_odd : along_even); }
  bool is_constrained(Index e) const { return is_constraint[e / 2] != 0; }
};

/// The points must be at least 2 and in the exact range, the loops' indices valid.
tl::expected<ConstrainedNet, NetConflict> constrained_net(const std::vector<Vec2>& points,
                                                          const std::vector<std::vector<Index>>& loops);

}  // namespace beadmesh::delaunay
