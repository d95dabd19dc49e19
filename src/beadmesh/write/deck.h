// Solver decks by the ending of the file name; each is written whole or not at all.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "beadmesh/core/result.h"
#include "beadmesh/mesh/shell_mesh.h"
#include "beadmesh/write/deck_options.h"
#include "beadmesh/write/whole_files.h"

namespace beadmesh {

/// Known endings with their formats, ".bdf .nas .dat (Nastran), .k .key (LS-DYNA), ...".
std::string deck_endings();

/// Ok where the ending of `path` (any case) is one of a known format: .bdf .nas .dat Nastran, .k .key
/// LS-DYNA, .inp Abaqus and CalculiX, .vtu VTK, .msh Gmsh 4.1, .stl. Fails with write.ending.
Result<void> check_deck_ending(const std::filesystem::path& path);

/// Ok where the mesh can be put into a deck: finite coordinates, nodes and parts that exist. Fails with
/// write.mesh; with write.ids where the ids are not from 1 to 99999999, eight columns.
Result<void> check_deck_mesh(const ShellMesh& mesh, const DeckOptions& options = {});

/// The deck in the format of the ending of `path`, into `out`. Ending and mesh must have passed the checks
/// above.
void write_deck(const ShellMesh& mesh, const std::filesystem::path& path, std::ostream& out,
                const DeckOptions& options = {});

/// Checks, then writes the file `path`. Fails with write.*.
Result<void> write_deck(const ShellMesh& mesh, const std::filesystem::path& path,
                        const DeckOptions& options = {});

}  // namespace beadmesh
