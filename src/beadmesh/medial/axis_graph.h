// The medial axis as a graph on half-edges of the triangulation (section 3.3, algorithms 1 and 2, mended).
#pragma once

#include <map>
#include <vector>

#include "beadmesh/medial/triangle_type.h"

namespace beadmesh {

/// Triangles that stand for one point of the axis.
struct Cluster {
  Circle circle;            ///< a corner: the corner point, radius 0
  Index corner = no_index;  ///< the sample, where the cluster is a C triangle
  bool merged = false;  ///< several junctions made one (section 3.5): touches the boundary at two points only
};

/// A stretch of the boundary that faces a point of the axis: samples first to last, forward along their loop.
struct Sector {
  Index first = no_index, last = no_index;
};

/// Between two nodes, or closed (no nodes). half_edges[0] leaves the start node, the last one enters the end
/// node; between two successive ones lies a cluster with two open half-edges.
struct AxisEdge {
  Index start = no_index, end = no_index;
  Index start_slot = 0, end_slot = 0;  ///< which of the nodes' `out` the edge's ends are
  std::vector<Index> half_edges;
};

/// A cluster with other than two open half-edges; `out` are these, counter-clockwise.
struct AxisNode {
  Index triangle = no_index;
  bool is_corner = false;
  std::vector<Index> out;
};

struct AxisGraph {
  std::vector<AxisNode> nodes;
  std::vector<AxisEdge> edges;
};

/// Half-edge 3 t + k leaves triangle t through slot k. It is open where the axis passes, closed where both
/// sides were made one cluster. Closed half-edges form a forest, so that no operation here can swallow a
/// hole.
class AxisTriangles {
 public:
  AxisTriangles(const Triangulation& triangulation, const BoundarySamples& samples);

  Index twin(Index half_edge) const { return twin_[half_edge]; }
  Index find(Index triangle) const;
  Index cluster_of(Index half_edge) const { return find(half_edge / 3); }
  Cluster& cluster(Index root) { return clusters_[root]; }
  const Cluster& cluster(Index root) const { return clusters_[root]; }
  /// What pruning has cut off beyond the cluster's circle; the circle itself where nothing was.
  const Circle& tip(Index root) const;
  void set_tip(Index root, const Circle& tip) { tips_[root] = tip; }
  Index triangle_count() const { return static_cast<Index>(parent_.size()); }

  /// The samples left and right of the axis where it leaves through the half-edge.
  Index left(Index half_edge) const;
  Index right(Index half_edge) const;
  /// The next open half-edge counter-clockwise about the cluster; itself where it is the only one.
  Index next_open(Index half_edge) const;
  /// The boundary between a half-edge and the next open one.
  Sector sector_after(Index half_edge) const { return {left(half_edge), right(next_open(half_edge))}; }
  Index degree(Index half_edge) const;
  /// From a half-edge along clusters of degree 2 to the half-edge that enters a node, or back to the start.
  std::vector<Index> chain(Index half_edge) const;

  /// The cluster at the far end of that: of a node, or the one left through `half_edge` itself.
  Index chain_end(Index half_edge) const;
  /// The half-edge that leaves the next cluster of a chain; no_index where that is a node.
  Index next_in_chain(Index half_edge) const;

  /// Closes a half-edge; the cluster of `keep`'s side survives with its data. False where that would close a
  /// cycle.
  bool close(Index half_edge, Index keep);

  /// Contraction of coincident centres, nearest first: two neighbours become one where the centres of all
  /// their triangles lie within `tolerance` times the radius. Makes the result independent of cocircular
  /// ties.
  void contract(double tolerance);

  /// Open half-edges of a triangle that is a cluster of its own, -1 where it is part of a larger one.
  int open_sides(Index triangle) const;
  /// The open half-edges of the smooth ends and corners: of clusters that have only one.
  std::vector<Index> leaves() const;
  /// Nodes and edges, each half-edge once: loops from a node to itself and double edges come out right.
  AxisGraph march() const;

 private:
  const Triangulation& triangulation_;
  std::vector<Index> twin_;
  std::vector<char> open_;
  mutable std::vector<Index> parent_;
  std::vector<Cluster> clusters_;
  std::map<Index, Circle> tips_;
};

}  // namespace beadmesh
