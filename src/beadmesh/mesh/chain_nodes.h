// Mesh nodes on the boundary chains: placed once, seen by every face around.
#pragma once

#include <vector>

#include "beadmesh/bead/ridge.h"
#include "beadmesh/delaunay/planar_region.h"
#include "beadmesh/panel/chain.h"

namespace beadmesh {

/// A node on a chain. `id` is its index among all boundary nodes of the panel.
struct ChainNode {
  double arc_length = 0;
  Index id = no_index;
};

/// Where a segment of a face's loop lies on the chains.
struct LoopSegment {
  Index chain = no_index;
  Index segment = 0;
  bool reversed = false;
};

/// A boundary node as a face sees it.
struct LoopNode {
  Index id = no_index;
  Vec2 flat;
  double position = 0;  ///< arc length along the region's loop
};

class ChainNodes {
 public:
  ChainNodes(const Panel& panel, const ChainSet& chains);

  /// Evenly spaced nodes; ends of open chains are shared with the chains that meet there.
  void place_evenly(Index chain, int count);
  /// Nodes at these arc lengths, from 0 to the length of the chain, ascending.
  void place_at(Index chain, const std::vector<double>& arc_lengths);
  /// Nodes where a bead has put them on its boundary, which must be made of closed chains; returns their ids
  /// in the order given.
  std::vector<Index> place_from_face(Index face, const PlanarRegion& region,
                                     const std::vector<BoundaryPosition>& positions);

  bool is_set(Index chain) const { return !nodes_[chain].empty(); }
  int count(Index chain) const;
  const std::vector<Vec3>& points() const { return points_; }

  /// All nodes of a loop of a face in order; empty where a chain of it is not set.
  std::vector<LoopNode> nodes_of_loop(Index face, Index loop, const PlanarRegion& region) const;

  /// Segment i of the face's loop polyline on the chains; empty where the loop does not match its chains.
  const std::vector<LoopSegment>& segments_of(Index face, Index loop) const { return segments_[face][loop]; }

 private:
  Index vertex_node(Index panel_point);
  Index add_node(Index chain, double arc_length);
  void match_loop(Index face, Index loop);

  const Panel& panel_;
  const ChainSet& chains_;
  std::vector<std::vector<ChainNode>> nodes_;  ///< per chain, ascending; open: both ends; closed: none twice
  std::vector<Vec3> points_;
  std::vector<Index> vertex_nodes_;  ///< per panel point
  std::vector<std::vector<std::vector<LoopSegment>>> segments_;
};

}  // namespace beadmesh
