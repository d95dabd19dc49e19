// Gmsh's own format, MSH 4.1.
#pragma once

#include <iosfwd>

#include "beadmesh/mesh/shell_mesh.h"
#include "beadmesh/write/deck_options.h"

namespace beadmesh {

/// Text. A surface entity for the sheet, one for the body of each bead and one for its caps; physical
/// surfaces with the names and ids of the parts, and bead_1, bead_1_caps with the set ids of
/// write/nastran.h. The crest and the boundary of a bead are curves of two-node lines, physical curves
/// bead_1_crest and bead_1_boundary; the ids of the lines follow those of the shells. Every node lies on the
/// curve or surface that has it first. Thickness and material have no place in the format. `mesh` must have
/// passed check_deck_mesh.
void write_gmsh(const ShellMesh& mesh, std::ostream& out, const DeckOptions& options = {});

}  // namespace beadmesh
