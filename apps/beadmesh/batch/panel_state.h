// What became of a panel of a batch, kept in a file beside its results, so that a second call can go on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "batch/manifest.h"
#include "beadmesh/core/result.h"

namespace beadmesh::app {

/// What the results of a panel depend on: they are good as long as it is the same.
struct Fingerprint {
  std::string input;    ///< SHA-256 of the panel file; empty where it cannot be read
  std::string options;  ///< SHA-256 of settings, options and the kinds of files
  std::string version;  ///< of the program

  bool operator==(const Fingerprint&) const = default;
};

enum class Outcome {
  done,
  fell_short,   ///< exit status 1
  refused,      ///< exit status 2: the input or its options
  not_written,  ///< the results could not be put in place
  crashed,      ///< ended by a signal of its own making, or by an internal error
  killed,       ///< ended by a signal from outside, twice
  timed_out,
  out_of_memory,
  not_run
};

std::string_view name_of(Outcome outcome);
/// Are there a deck and a table?
bool has_results(Outcome outcome);

/// Figures out of the bead table of a panel.
struct PanelFigures {
  int I = 0, generic = 0, annular = 0, fallbacks = 0;
  int nodes = 0, quads = 0, trias = 0;
  double scaled_jacobian_min = 0, scaled_jacobian_mean = 0, edge_min = 0;
  int inverted = 0, edges_below_min = 0;
  int warnings = 0, errors = 0;

  int beads() const { return I + generic + annular; }
};

/// Each figure of the beads, of the mesh, and of the messages with its name in the files, in their order:
/// visit(name, value).
template <class Figures, class Visit>
void visit_beads(Figures& f, const Visit& visit) {
  visit("I", f.I), visit("generic", f.generic), visit("annular", f.annular), visit("fallbacks", f.fallbacks);
}
template <class Figures, class Visit>
void visit_mesh(Figures& f, const Visit& visit) {
  visit("nodes", f.nodes), visit("quads", f.quads), visit("trias", f.trias);
  visit("scaled_jacobian_min", f.scaled_jacobian_min), visit("scaled_jacobian_mean", f.scaled_jacobian_mean);
  visit("edge_min", f.edge_min), visit("inverted", f.inverted), visit("edges_below_min", f.edges_below_min);
}
template <class Figures, class Visit>
void visit_messages(Figures& f, const Visit& visit) {
  visit("warnings", f.warnings), visit("errors", f.errors);
}
template <class Figures, class Visit>
void visit_all(Figures& f, const Visit& visit) {
  visit_beads(f, visit), visit_mesh(f, visit), visit_messages(f, visit);
}

/// What the run cost; differs from run to run, so it stays out of the summaries.
struct PanelCost {
  int attempts = 0;
  double seconds = 0, cpu_seconds = 0, peak_mb = 0;
};

struct PanelState {
  std::string name, input;
  Fingerprint fingerprint;
  Outcome outcome = Outcome::not_run;
  int exit_status = 0, signal = 0;
  std::string message;  ///< the first line that says why; empty where all is well
  PanelFigures figures;
  PanelCost cost;
  std::vector<std::string> files;  ///< names in the panel's folder
};

/// `kinds`: what else decides about the files, as "bdf html".
Fingerprint fingerprint_of(const BatchPanel& panel, const std::string& kinds);

/// Of `beadmesh.beads/1`; none where the file is none.
std::optional<PanelFigures> figures_of(const std::filesystem::path& bead_json);

/// Schema beadmesh.batch.panel/1.
std::string state_text(const PanelState& state);
/// None where there is no such file, or it is not one of ours.
std::optional<PanelState> read_state(const std::filesystem::path& path);

}  // namespace beadmesh::app
