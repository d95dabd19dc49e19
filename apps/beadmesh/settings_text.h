// The settings of a run in the words of the configuration file.
#pragma once

#include <string>
#include <vector>

#include "settings.h"

namespace beadmesh::app {

/// What decides the mesh, a table of the TOML file on each line: "size = 5, min_edge = 2.5, ...", then
/// "[bead] ...", "[read] ...", and what is asked of beads and in balls where anything is. For the head of
/// decks.
std::vector<std::string> settings_lines(const Settings& settings);

}  // namespace beadmesh::app
