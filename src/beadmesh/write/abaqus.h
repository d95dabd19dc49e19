// Input decks of Abaqus and CalculiX.
#pragma once

#include <iosfwd>

#include "beadmesh/mesh/shell_mesh.h"
#include "beadmesh/write/deck_options.h"

namespace beadmesh {

/// *NODE, *ELEMENT of type S4 and S3 in an element set for each part, *SHELL SECTION with its thickness, one
/// elastic *MATERIAL. Sets of a bead as *ELSET bead_1 and bead_1_caps, *NSET bead_1_crest and
/// bead_1_boundary. With DeckAnalysis::modes a *FREQUENCY step; with none no *HEADING and no step, to be
/// included. `first_property` is not used: sections have names only. `mesh` must have passed check_deck_mesh.
void write_abaqus(const ShellMesh& mesh, std::ostream& out, const DeckOptions& options = {});

}  // namespace beadmesh
