// Inside the read room: the shells of a deck become a panel.
#pragma once

#include <filesystem>

#include "beadmesh/core/result.h"
#include "beadmesh/read/panel_reader.h"
#include "beadmesh/read/shell_deck.h"

namespace beadmesh {

/// Quads are cut along their shorter diagonals. Each property is a part of its own (Panel::parts), whose
/// number and thickness its faces keep. Fails with read.too_large, read.no_faces, read.unit.
Result<Panel> panel_of_shells(const ShellDeck& deck, const std::string& name, const ReadOptions& options);

/// Reads Nastran (.bdf .nas .dat), LS-DYNA (.k .key .dyn) or Abaqus (.inp) by ending.
Result<Panel> read_shell_panel(const std::filesystem::path& path, const ReadOptions& options);

}  // namespace beadmesh
