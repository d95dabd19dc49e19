// How many elements along the loops of annular beads that share loops with each other.
#pragma once

#include <array>
#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh {

/// An annular bead between two lines.
struct RingBetween {
  std::array<Index, 2> lines{no_index, no_index};
  double width = 0;       ///< between its loops, mm
  double size = 5;        ///< target element length, mm
  double min_edge = 2.5;  ///< minimum element length, mm
  int asked = 0;          ///< elements around that the user asks for; impossible ones are passed over
};

/// Elements along every line (0 for lines of no ring): even, at least 8. The lines of a ring carry the same
/// number where edges stay between 0.65 and 1.7 of the size, so that it needs no irregular node, or where it
/// is too narrow for graded rows. Joined from the shortest lines outwards, where a change costs least when it
/// comes late; what is asked of one ring holds for all lines joined with it. `lengths`: of the lines, mm.
std::vector<int> counts_of_rings(const std::vector<RingBetween>& rings, const std::vector<double>& lengths);

}  // namespace beadmesh
