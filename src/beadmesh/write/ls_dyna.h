// LS-DYNA keyword files.
#pragma once

#include <iosfwd>

#include "beadmesh/mesh/shell_mesh.h"
#include "beadmesh/write/deck_options.h"

namespace beadmesh {

/// *NODE, *ELEMENT_SHELL (a triangle repeats its third node), *PART, *SECTION_SHELL (fully integrated,
/// element 16) and one *MAT_ELASTIC, in the standard format: ids in 8 columns, coordinates in 16. Sets of a
/// bead as *SET_SHELL_LIST_TITLE and *SET_NODE_LIST_TITLE with the ids of write/nastran.h. With
/// DeckAnalysis::modes an implicit eigenvalue analysis; with none no control keyword, to be included. `mesh`
/// must have passed check_deck_mesh.
void write_ls_dyna(const ShellMesh& mesh, std::ostream& out, const DeckOptions& options = {});

}  // namespace beadmesh
