// Runs the panels of a batch, each in a process of its own, several at a time.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "batch/batch_folder.h"
#include "batch/worker.h"

namespace beadmesh::app {

struct BatchPlan {
  BatchFolder folder;
  std::vector<BatchPanel> panels;
  std::string deck = "bdf";     ///< default bdf: ending of the decks
  std::string report = "html";  ///< default html: html, svg or none
  int jobs = 0;                 ///< default 0: as many panels at a time as there are cores
  int threads = 1;              ///< default 1: threads of each
  WorkerLimits limits;
  bool force = false;  ///< default false: what is done and still valid is left as it is

  std::string kinds() const { return deck + " " + report; }
};

/// Called when a panel is done with; `skipped`: its results of an earlier run are still valid.
using PanelCallback = std::function<void(const PanelState&, bool skipped)>;

/// The state of every panel, in their order. Never fails for a single panel. A panel whose worker was killed
/// from outside gets a second try after all others. SIGINT and SIGTERM end the workers; what has not been
/// done then is `not_run`.
std::vector<PanelState> run_panels(const BatchPlan& plan, const PanelCallback& callback);

/// The states as they are on the disk; `not_run` where there is none that is valid.
std::vector<PanelState> collect_states(const BatchPlan& plan);

/// The words that mesh a panel, for people to repeat.
std::vector<std::string> mesh_words(const BatchPlan& plan, const BatchPanel& panel,
                                    const std::filesystem::path& into);

}  // namespace beadmesh::app
