// Blocks of annular beads (section 4.4 of the paper): four to six, cut at touching lines.
#pragma once

#include <vector>

#include "beadmesh/bead/skeleton.h"
#include "beadmesh/blocking/block_layout.h"
#include "beadmesh/core/result.h"

namespace beadmesh {

struct AnnularBlockOptions {
  int elements_across = 4;  ///< default 4: even; 1: from loop to loop, without a crest
  int elements_around = 0;  ///< even, at least 8; ignored where a loop is prescribed
  /// Per loop of the region: arc lengths of the nodes that a neighbour has set, ascending; empty: free.
  std::vector<std::vector<double>> prescribed;
};

/// Cut at t = 0, 1/4, 1/2, 3/4 of the closed medial edge; up to six cuts where there are more than 48
/// elements around. Fails with blocking.annular.* where both loops are prescribed with different counts or
/// the feet run back.
Result<BlockLayout> blocks_of_annular_bead(const Skeleton& skeleton, const PlanarRegion& region,
                                           const AnnularBlockOptions& options);

}  // namespace beadmesh
