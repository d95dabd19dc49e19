// Which point of a chain makes the Delaunay triangle over a base. Internal to this room.
#pragma once

#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh::delaunay {

/// The points of a chain under a tree of boxes, so that a long chain is not looked through for each of its
/// triangles.
class ChainApex {
 public:
  /// `a` and `b`: the ends of the whole chain, between which the points lie more or less.
  void reset(Vec2 a, Vec2 b, std::vector<Vec2> points);
  /// Of the points [first, end) that are left of the line from a to b the one whose circle through a and b
  /// has none of the others inside; on a tie the middle one of the range if it is as good, otherwise any.
  /// no_index where none is on the left.
  Index find(Vec2 a, Vec2 b, Index first, Index end) const;

 private:
  struct Box {  // along and across the line between the ends of the chain
    Vec2 low, high;
  };
  struct Search;

  Vec2 in_frame(Vec2 p) const { return {dot(p - origin_, along_), cross(along_, p - origin_)}; }
  void visit(Search& search, Index first, Index end) const;

  std::vector<Vec2> points_;
  Vec2 origin_, along_;
  double extent_ = 0;
  Index leaves_ = 1;
  std::vector<Box> boxes_;  // a heap: the children of box i are 2 i and 2 i + 1
};

}  // namespace beadmesh::delaunay
