// VTK unstructured grids, for ParaView and for programs that read arrays.
#pragma once

#include <iosfwd>

#include "beadmesh/mesh/shell_mesh.h"
#include "beadmesh/write/deck_options.h"

namespace beadmesh {

/// XML with binary arrays (base64, not compressed). Points in double precision, quads and triangles.
/// Point data: `id`; `crest` and `boundary`, the number of the bead on whose crest or boundary a node lies
/// (the first that has it), 0 on none.
/// Cell data: `id`; `part`, the property id; `bead`, 0 for none; `kind`, 0 sheet, 1 I, 2 generic, 3 annular;
/// `face`, 1-based number of the panel's face; `cap`, 1 in the caps of beads; `thickness` (mm);
/// `scaled_jacobian`; `warpage` (degrees); `shortest_edge` (mm).
/// `mesh` must have passed check_deck_mesh.
void write_vtu(const ShellMesh& mesh, std::ostream& out, const DeckOptions& options = {});

}  // namespace beadmesh
