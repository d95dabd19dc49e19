// Shells of a deck file, by the ending of its name.
#pragma once

#include <filesystem>

#include "beadmesh/core/result.h"
#include "beadmesh/read/shell_deck.h"

namespace beadmesh {

/// Nastran (.bdf .nas .dat), LS-DYNA (.k .key .dyn) or Abaqus (.inp), any case. Fails with read.not_found,
/// read.directory, read.ending, and as the parsers do (nastran_reader.h, lsdyna_reader.h, abaqus_reader.h).
Result<ShellDeck> read_shell_deck(const std::filesystem::path& path);

}  // namespace beadmesh
