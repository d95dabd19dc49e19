// Nastran bulk data.
#pragma once

#include <iosfwd>

#include "beadmesh/mesh/shell_mesh.h"
#include "beadmesh/write/deck_options.h"

namespace beadmesh {

/// Ids of the sets of a bead, for decks of fewer than 10,000 beads (else the bases grow by powers of ten):
/// elements 10000 + bead id, crest nodes 20000 +, boundary nodes 30000 +, elements of the caps 40000 +.
///
/// A deck that runs as it is: normal modes of the free panel (SOL 103), the sets of each bead in the case
/// control, GRID in large fields (1e-7 mm at coordinates of 1e5), CQUAD4 and CTRIA3, one PSHELL a part, steel
/// as MAT1 in N, mm, tonne. With DeckAnalysis::none bulk data only, the sets as SET1, without ENDDATA: to be
/// included. `mesh` must have passed check_deck_mesh.
void write_nastran(const ShellMesh& mesh, std::ostream& out, const DeckOptions& options = {});

}  // namespace beadmesh
