// One closed loop of nodes, the face on its left, as the loop splitter sees it. Internal to the room.
#pragma once

#include <array>
#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh {

using NodeLoop = std::vector<Index>;

/// Counter-clockwise angle from u to v, in (0, 2 pi].
double turn_from(Vec2 u, Vec2 v);
double signed_area(const std::vector<Vec2>& nodes, const NodeLoop& loop);
/// Even-odd rule.
bool is_inside(const std::vector<Vec2>& nodes, const NodeLoop& loop, Vec2 point);

/// Number of quads that fit an interior angle: 90 degrees each, at least one.
int quads_in_angle(double angle);

/// Interior angle at each position of the loop; 2 pi at the tip of a scar.
std::vector<double> interior_angles(const std::vector<Vec2>& nodes, const NodeLoop& loop);

/// The loop walked on the integer lattice: ahead by one for each edge, left by a right angle for each missing
/// quad at a node. Where the walk from one position to another, closed by a split line, returns to its start
/// after four turns, the part can be meshed without an irregular node.
class LatticeWalk {
 public:
  explicit LatticeWalk(const std::vector<double>& angles);

  /// Deviation of the part that runs from position `from` to `to` (cyclic, to != from) and back over `edges`
  /// edges with `quads_from` and `quads_to` at its two ends: {net singularity, lattice steps by which the
  /// walk fails to close}.
  std::array<int, 2> defect(int from, int to, int edges, int quads_from, int quads_to) const;
  int net_singularity() const { return 4 - turns_[size_]; }

 private:
  int size_;
  std::vector<int> turns_;                  // left turns at positions 0 .. i-1, twice around
  std::vector<std::array<int, 2>> places_;  // lattice point of position i
};

}  // namespace beadmesh
