// The first triangle that a ray meets.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh {

struct RayHit {
  double distance = 0;  ///< in units of the direction's length
  Index triangle = no_index;
};

/// A tree of boxes around triangles, halved at the middle triangle of the longer axis. Const calls are safe
/// from several threads.
class RaySearch {
 public:
  explicit RaySearch(std::vector<std::array<Vec3, 3>> triangles);

  /// The nearest hit further than `from` and nearer than `to`; of several at one distance the lowest
  /// triangle.
  std::optional<RayHit> first_hit(Vec3 origin, Vec3 direction, double from, double to) const;

 private:
  struct Node {
    Vec3 low, high;
    Index begin = 0, end = 0;    ///< in order_
    Index left = 0, right = -1;  ///< children; none in a leaf
  };

  Index add_node(Index begin, Index end);

  std::vector<std::array<Vec3, 3>> triangles_;
  std::vector<Index> order_;
  std::vector<Node> nodes_;
};

}  // namespace beadmesh
