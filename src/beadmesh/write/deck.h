// Solver decks by the ending of the file name; each is written whole or not at all.
#pragma once

#include <filesystem>
#include <iosfwd>

#include "beadmesh/core/result.h"
#include "beadmesh/mesh/shell_mesh.h"
#include "beadmesh/write/whole_files.h"

namespace beadmesh {

/// Ok where the ending of `path` (any case) is one of a known format: .bdf .nas .dat. Fails with
/// write.ending.
Result<void> check_deck_ending(const std::filesystem::path& path);

/// Ok where the mesh can be put into a deck: finite coordinates, nodes and parts that exist, ids that fit the
/// fields. Fails with write.mesh.
Result<void> check_deck_mesh(const ShellMesh& mesh);

/// The deck in the format of the ending of `path`, into `out`. Ending and mesh must have passed the checks
/// above.
void write_deck(const ShellMesh& mesh, const std::filesystem::path& path, std::ostream& out);

/// Checks, then writes the file `path`. Fails with write.*.
Result<void> write_deck(const ShellMesh& mesh, const std::filesystem::path& path);

}  // namespace beadmesh
