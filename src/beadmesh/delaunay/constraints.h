// Edges that must be in a triangulation. Internal to this room.
#pragma once

#include <vector>

#include "beadmesh/delaunay/chain_apex.h"
#include "beadmesh/delaunay/edge_net.h"

namespace beadmesh::delaunay {

/// What keeps an edge from being inserted. Points of the net.
struct InsertionConflict {
  enum class Kind { none, point_on_edge, crossing } kind = Kind::none;
  Index point = no_index;  ///< the point on the edge, or one end of the crossed constraint
  Index other = no_index;  ///< the other end of the crossed constraint
  explicit operator bool() const { return kind != Kind::none; }
};

/// Inserts edges into a Delaunay triangulation so that it stays constrained Delaunay.
/// Based on: Anglada, "An improved incremental algorithm for constructing restricted Delaunay
/// triangulations", 1997.
class ConstraintInserter {
 public:
  /// `is_constraint`: per undirected edge (e / 2) of the net. It never gets too short here: an insertion adds
  /// as many edges as it removes, and the net uses their numbers again. `spokes`: per point of the net an
  /// edge from it; kept up to date.
  ConstraintInserter(EdgeNet& net, const std::vector<char>& is_constraint, std::vector<Index>& spokes)
      : net_(net), is_constraint_(is_constraint), spokes_(spokes) {}

  /// The edge from a to b, no_index where there is none.
  Index find(Index a, Index b) const;
  /// The edge (a, b) must not exist yet. Returns a conflict, the net unchanged, or sets `inserted` to the new
  /// edge.
  InsertionConflict insert(Index a, Index b, Index& inserted);

 private:
  struct Polygon {  // the base and its chain bound a face; the chain runs from the base's end to its start
    Index base;
    Index first, last;  // places in the chain, `last` included
  };

  InsertionConflict first_crossed(Index a, Index b, Index& crossed) const;
  InsertionConflict walk(Index a, Index b, Index crossed);
  void fill(Index base, const std::vector<Index>& chain);
  Index apex(const Polygon& polygon, const std::vector<Index>& chain) const;

  EdgeNet& net_;
  const std::vector<char>& is_constraint_;
  std::vector<Index>& spokes_;
  std::vector<Index> crossed_, left_, right_;
  std::vector<Polygon> pending_;
  ChainApex chain_apex_;  // of a long chain
};

}  // namespace beadmesh::delaunay
