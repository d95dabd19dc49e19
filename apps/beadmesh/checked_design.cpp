#include "checked_design.h"

namespace beadmesh::app {

DesignCheck checked_design(const Options& options, const Panel& panel, BeadTable& table,
                           const Context& context) {
  DesignCheck check{{}, options.settings.design};
  if (!options.design_check) return check;
  check.beads = design_of_beads(panel, table, context);
  const std::vector<Diagnostic> warnings = judge_design(check.beads, check.limits);
  table.diagnostics.insert(table.diagnostics.end(), warnings.begin(), warnings.end());
  check.past_limits = warnings.size();
  return check;
}

}  // namespace beadmesh::app
