// Four-sided blocks that fill a bead (sections 4.2 to 4.4 of the paper): virtual vertices, virtual edges,
// blocks.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "beadmesh/bead/ridge.h"
#include "beadmesh/core/result.h"
#include "beadmesh/core/vector.h"
#include "beadmesh/delaunay/planar_region.h"

namespace beadmesh {

enum class VirtualEdgeKind { boundary, split, ridge, inner };

struct VirtualVertex {
  Vec2 point;
  bool on_boundary = false;
  BoundaryPosition boundary;  ///< where on_boundary
};

struct VirtualEdge {
  Index start = no_index, end = no_index;  ///< vertices
  VirtualEdgeKind kind = VirtualEdgeKind::inner;
  std::vector<Vec2> points;  ///< from start to end, both included
  Index loop = no_index;     ///< boundary: the loop it runs along ...
  double from = 0,
         to = 0;  ///< ... from and to this arc length; to may exceed the loop's length or be negative
  double loop_length = 0;  ///< boundary: arc length of the whole loop
  std::vector<double>
      prescribed;  ///< boundary: arc lengths of nodes that a neighbour has set, from start to end
  int count = 0;   ///< elements along it; 0 until assigned
};

/// Virtual edges in a row; edge k is walked against its direction where reversed[k].
struct BlockSide {
  std::vector<Index> edges;
  std::vector<bool> reversed;
};

/// Sides counter-clockwise, head to tail.
struct Block {
  std::array<BlockSide, 4> sides;
  /// Sides 0 and 2 may carry counts that differ by an even number; the count changes in the row along side 2.
  bool graded = false;
  bool cap = false;  ///< part of the clamp at an end
};

struct BlockLayout {
  std::vector<VirtualVertex> vertices;
  std::vector<VirtualEdge> edges;
  std::vector<Block> blocks;
};

/// Puts a layout together: edges between the same two vertices are shared, blocks oriented counter-clockwise.
class BlockLayoutBuilder {
 public:
  explicit BlockLayoutBuilder(const PlanarRegion& region);

  Index add_vertex(Vec2 point);
  Index add_boundary_vertex(BoundaryPosition position);
  /// Straight or along `points` (inner points only). An existing edge between the vertices is returned as it
  /// is.
  Index add_edge(Index start, Index end, VirtualEdgeKind kind, const std::vector<Vec2>& inner_points = {},
                 int count = 0);
  /// Along the loop from one boundary vertex to another, against the loop's direction where `backward`.
  Index add_boundary_edge(Index start, Index end, bool backward, int count = 0);
  /// Each side as the vertices it passes, first and last a corner, head to tail; the edges must exist.
  void add_block(const std::array<std::vector<Index>, 4>& sides, bool graded = false);

  /// Blocks added since `first` (a count of blocks) are the clamp at an end.
  void mark_cap(size_t first);

  Vec2 point_of(Index vertex) const { return layout_.vertices[vertex].point; }
  Vec2 point_at(BoundaryPosition position) const;
  double loop_length(Index loop) const { return offsets_[loop].back(); }
  Index find_edge(Index a, Index b) const;
  const BlockLayout& layout() const { return layout_; }
  VirtualEdge& edge(Index e) { return layout_.edges[e]; }

  /// The layout, or what is wrong with it: blocking.missing_edge, blocking.loops.
  Result<BlockLayout> take();

 private:
  const PlanarRegion& region_;
  std::vector<std::vector<double>> offsets_;  ///< per loop: arc length at every point, then the whole length
  BlockLayout layout_;
  std::string fault_;
};

}  // namespace beadmesh
