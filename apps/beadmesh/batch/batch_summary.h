// The summary of a batch. The same states give the same bytes: no times, no order but that of the panels.
#pragma once

#include <string>
#include <vector>

#include "batch/panel_state.h"

namespace beadmesh::app {

struct BatchTotals {
  int panels = 0, done = 0, fell_short = 0, not_run = 0;
  int failed = 0;  ///< all others
  PanelFigures figures;

  bool all_well() const { return done == panels; }
};

BatchTotals totals_of(const std::vector<PanelState>& states);

/// Schema beadmesh.batch/1: the totals, then a line for each panel.
std::string batch_json(const std::vector<PanelState>& states);
/// A line for each panel, and one of names.
std::string batch_csv(const std::vector<PanelState>& states);
/// What each panel cost: outcome, attempts, seconds, processor seconds, peak memory.
std::string times_csv(const std::vector<PanelState>& states);
/// One page that needs nothing but itself; links to the files of each panel.
std::string batch_html(const std::vector<PanelState>& states, const std::string& title);
/// For the terminal: totals, and a line for each panel that is not done.
std::string batch_text(const std::vector<PanelState>& states);

}  // namespace beadmesh::app
