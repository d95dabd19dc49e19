// Blocks of beads that are too narrow for two elements across: no crest, one element from side to side.
#pragma once

#include "beadmesh/bead/ridge.h"
#include "beadmesh/bead/skeleton.h"
#include "beadmesh/blocking/block_layout.h"
#include "beadmesh/core/result.h"

namespace beadmesh {

struct NarrowBlockOptions {
  double size = 5;        ///< default 5 mm: target element length
  double min_edge = 2.5;  ///< default 2.5 mm: minimum element length
};

/// A bead of one arm as a strip one element wide; each end is one quad whose last side lies across the tip.
/// Fails with blocking.narrow where the bead has junctions or is too short for its two ends.
Result<BlockLayout> blocks_of_narrow_bead(const Skeleton& skeleton, const RidgeGraph& ridge,
                                          const PlanarRegion& region, const NarrowBlockOptions& options);

}  // namespace beadmesh
