// Visibility between nodes among the edges of loops, with a search grid. Internal to the room.
#pragma once

#include <array>
#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh {

/// True where the closed segments have a point in common.
bool segments_meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d);
double distance_to_segment(Vec2 point, Vec2 a, Vec2 b);

class SegmentGrid {
 public:
  /// Edges as pairs of node indices; keeps a reference to the nodes. `reach`: largest clearance that is
  /// measured.
  SegmentGrid(const std::vector<Vec2>& nodes, std::vector<std::array<Index, 2>> edges, double reach);

  /// Distance from the line between two nodes to the nearest other node, at most `reach`; negative where an
  /// edge that does not end in a or b meets the line.
  double clearance(Index a, Index b) const;
  /// A pair of edges without a common node that meet, as indices of the edges; {no_index, no_index} where
  /// there is none.
  std::array<Index, 2> first_crossing() const;

 private:
  std::array<int, 2> cell_of(Vec2 point) const;
  std::size_t slot(int i, int j) const { return static_cast<std::size_t>(j) * columns_ + i; }
  template <class Visit>
  void for_cells_of_box(Vec2 low, Vec2 high, Visit visit) const;

  const std::vector<Vec2>& nodes_;
  std::vector<std::array<Index, 2>> edges_;
  double reach_, cell_ = 1;
  Vec2 low_;
  int columns_ = 1, rows_ = 1;
  std::vector<Index> start_, entries_;
};

}  // namespace beadmesh
