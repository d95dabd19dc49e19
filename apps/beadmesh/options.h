// The command line.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "batch/batch_options.h"
#include "settings.h"

namespace beadmesh::app {

enum class Verb { mesh, beads, medial, check, batch, options };

/// Files to write; empty: not asked for; "-": standard output (json and csv only).
struct OutputNames {
  std::string deck, json, csv, report, svg, debug_svg, criteria, repaired;
};

struct Options {
  Verb verb = Verb::mesh;
  std::filesystem::path input;
  OutputNames outputs;
  Settings settings;
  Index face = 0;             ///< of `medial`: 1-based number, 0: all
  bool timings = false;       ///< of `mesh` and `beads`: time of each stage on standard error
  bool design_check = false;  ///< of `mesh` and `beads`
  bool feet = false;          ///< of `medial`: lines to the touching points in the picture
  bool has_size = false;      ///< of `check`: was given
  bool has_min_edge = false;
  std::string criteria;  ///< file with limits; empty: those of the preset
  std::string preset;    ///< of the command line; `check`: without it no limits but the file's
  BatchOptions batch;    ///< of `batch`, which has no others
};

/// The reference of all options and settings, as a page of the documentation.
std::string options_page();

/// The options; none where help or version was asked for and has been printed. Fails with usage.* and
/// config.*.
Result<std::optional<Options>> parse_command_line(int argc, const char* const* argv);

}  // namespace beadmesh::app
