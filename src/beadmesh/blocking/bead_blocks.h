// Blocks of I and generic beads: arms are strips, ends are clamps, junctions are hubs.
#pragma once

#include "beadmesh/bead/ridge.h"
#include "beadmesh/bead/skeleton.h"
#include "beadmesh/blocking/block_layout.h"
#include "beadmesh/core/result.h"

namespace beadmesh {

/// What arms of a generic bead meet in. square: each ends at a cut through the feet beside it, and blocks
/// fill the middle; mitre: each runs on to the lines from the junction to the feet, as mouldings meet in a
/// corner; fan: the same, with as many rows behind the lines as the feet have room for, where the crest is
/// longer than they are.
enum class HubForm { square, mitre, fan };

struct BeadBlockOptions {
  double size = 5;          ///< default 5 mm: target element length
  double min_edge = 2.5;    ///< default 2.5 mm: minimum element length
  int elements_across = 4;  ///< default 4: even
  int extra_rows = 0;       ///< default 0: rows along the clamps beyond the best number for the size
  int elements_along = 0;   ///< default 0: from the size; on the strip of every arm
  int clamp_rows = 0;       ///< default 0: from the size; p of figure 15a
  int bands = 1;  ///< default 1: rows around the cores of the clamps; fewer where no core would be left
  HubForm hub = HubForm::square;  ///< default square
};

/// I-beads by the split lines of section 4.2 and the clamp of figure 15a; every arm of a generic bead
/// likewise, its junctions as hubs: a sector between two arms that stand against each other becomes one
/// block, the far side of a through bar two. Fails with blocking.* where arms are too short for their hubs.
Result<BlockLayout> blocks_of_bead(const Skeleton& skeleton, const RidgeGraph& ridge,
                                   const PlanarRegion& region, const BeadBlockOptions& options);

}  // namespace beadmesh
