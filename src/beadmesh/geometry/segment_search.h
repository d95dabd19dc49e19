// The nearest one of many segments in the plane.
#pragma once

#include <array>
#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh {

struct NearestOnSegments {
  Index segment =
      no_index;  ///< the one with the lowest number of several equally near; no_index: there are no segments
  double t = 0;  ///< where on it, 0 at its start, 1 at its end
  Vec2 point;
  double distance = 0;
};

/// A tree of bounding boxes over the segments in their given order: built in O(n), a query is O(log n) where
/// segments that follow each other are neighbours, as along loops; the result is that of a look at every
/// segment in any case.
class SegmentSearch {
 public:
  explicit SegmentSearch(std::vector<std::array<Vec2, 2>> segments);
  /// Segments of closed loops, one after the other: point i of loop 0 starts segment i, and so on.
  static SegmentSearch of_loops(const std::vector<std::vector<Vec2>>& loops);

  Index size() const { return static_cast<Index>(segments_.size()); }
  const std::array<Vec2, 2>& segment(Index i) const { return segments_[i]; }
  NearestOnSegments nearest(Vec2 p) const;
  /// Only segments nearer than `limit` count.
  NearestOnSegments nearest_within(Vec2 p, double limit) const;

 private:
  struct Box {
    Vec2 low, high;
  };

  static double squared_distance(const Box& box, Vec2 p);

  std::vector<std::array<Vec2, 2>> segments_;
  Index leaves_ = 1;        // a power of 2; leaf k holds the segments from k * leaf_size on
  std::vector<Box> boxes_;  // a heap: the children of box i are 2 i and 2 i + 1, box 1 is the root
};

}  // namespace beadmesh
