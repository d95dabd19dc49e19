// How many elements along every virtual edge.
#pragma once

#include <vector>

#include "beadmesh/blocking/block_layout.h"
#include "beadmesh/core/result.h"

namespace beadmesh {

struct ElementCountOptions {
  double size = 5;        ///< default 5 mm: target element length
  double min_edge = 2.5;  ///< default 2.5 mm: no edge is given elements shorter than this
};

/// Counts of opposite sides are equal (but for the graded sides of a block), so edges fall into groups; each
/// free group takes the count that is nearest to length / size over all its edges and leaves no element under
/// min_edge where that is possible. `lengths`: of every edge, on the surface. Fails with blocking.counts.*
/// where counts that are set contradict each other.
Result<void> assign_counts(BlockLayout& layout, const std::vector<double>& lengths,
                           const ElementCountOptions& options);

/// Even number of elements across a width: nearest to width / size (in ratio), at least 2, no element under
/// min_edge where 2 of them fit.
int elements_across(double width, double narrowest, const ElementCountOptions& options);

}  // namespace beadmesh
