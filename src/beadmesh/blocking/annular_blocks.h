// Blocks of annular beads (section 4.4 of the paper): four to six, cut at touching lines.
#pragma once

#include <vector>

#include "beadmesh/bead/skeleton.h"
#include "beadmesh/blocking/block_layout.h"
#include "beadmesh/core/result.h"

namespace beadmesh {

struct AnnularBlockOptions {
  int elements_across = 4;  ///< default 4: even; 1: from loop to loop, without a crest
  /// Per loop of the region: elements along it, even, at least 8; ignored where it is prescribed, 0: as the
  /// other.
  std::vector<int> elements_on_loop;
  /// Per loop of the region: arc lengths of the nodes that a neighbour has set, ascending; empty: free.
  std::vector<std::vector<double>> prescribed;
};

/// Cut at t = 0, 1/4, 1/2, 3/4 of the closed medial edge; up to six cuts where there are more than 48
/// elements around. Loops with different counts: the crest carries the mean, blocks are graded towards the
/// loops. Fails with blocking.annular.* where the counts are odd, differ by more than graded rows can make up
/// for (threefold from crest to loop), or the feet run back.
Result<BlockLayout> blocks_of_annular_bead(const Skeleton& skeleton, const PlanarRegion& region,
                                           const AnnularBlockOptions& options);

}  // namespace beadmesh
