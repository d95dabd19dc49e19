// The elements around one node, gathered in one place for as long as only that node moves.
#pragma once

#include <array>
#include <vector>

#include "beadmesh/mesh/element_corners.h"
#include "beadmesh/mesh/quad_connectivity.h"
#include "beadmesh/mesh/sliding_lines.h"

namespace beadmesh {

/// An element as the node at one of its corners sees it.
struct StarElement {
  Index element = no_index;
  int at = 0;  ///< the corner that is the node
  CornerPlaces places;
  /// Sides that are counted here, so that each edge at the node counts once: inner ones where they leave it,
  /// on the boundary also the one that arrives.
  std::array<bool, 4> is_own{};
  struct Edge {
    Index number = 0;       ///< among the edges at the node, in the order in which they are met
    bool is_first = false;  ///< no element before has it
    bool is_crest = false;
  };
  std::array<Edge, 2> edges{};  ///< the one that leaves the node, the one that arrives
};

class NodeStar {
 public:
  /// Gathers what does not change while `node` moves.
  void gather(Index node, const SurfaceNodes& nodes, const QuadConnectivity& mesh);
  /// Also which edges end at the node, and which of them are crests.
  void gather_edges(Index node, const QuadConnectivity& mesh, const SlidingLines& lines);
  void move_to(const SurfacePlace& place) {
    for (StarElement& one : elements_) one.places.set(one.at, place.flat, place.space);
  }
  const std::vector<StarElement>& elements() const { return elements_; }
  size_t edge_count() const { return ends_.size(); }

 private:
  std::vector<StarElement> elements_;
  std::vector<Index> ends_;
};

}  // namespace beadmesh
