// The design check of the verbs that offer it.
#pragma once

#include <vector>

#include "beadmesh/pipeline.h"
#include "options.h"

namespace beadmesh::app {

struct DesignCheck {
  std::vector<BeadDesign> beads;  ///< in the order of the table; empty where it was not asked for
  DesignLimits limits;
  size_t past_limits = 0;  ///< values past their limits
};

/// Measures and judges where --design-check asks for it; a warning of the table for each value past its
/// limit.
DesignCheck checked_design(const Options& options, const Panel& panel, BeadTable& table,
                           const Context& context);

}  // namespace beadmesh::app
