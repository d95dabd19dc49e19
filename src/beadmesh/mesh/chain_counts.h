// How many elements every boundary chain gets, so that each face can be all quads.
#pragma once

#include <vector>

#include "beadmesh/mesh/size_field.h"
#include "beadmesh/panel/chain.h"

namespace beadmesh {

struct ChainCountOptions {
  double size = 5;                       ///< default 5 mm: target element length
  double min_edge = 2.5;                 ///< default 2.5 mm: minimum element length
  std::vector<ChainSizing> sizing = {};  ///< per chain, where the size is not the same everywhere
  /// Per chain, mm: a chain is counted as if it were so much longer, since the rows beside it are (holes with
  /// washers). Empty: none is.
  std::vector<double> longer = {};
};

/// counts[c] > 0 is already set by a bead and stays. The others become length / size, the same on opposite
/// sides of faces with four sides (strips.h), then chains along the
/// cheapest paths between faces with an odd total (or from one to the outside) change by one, until every
/// face of `free_faces` is even. (A minimum T-join, taken greedily.) Faces that cannot be made even are left
/// odd.
void assign_chain_counts(const ChainSet& chains, const std::vector<bool>& free_faces,
                         std::vector<int>& counts, const ChainCountOptions& options = {});

}  // namespace beadmesh
