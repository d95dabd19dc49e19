// A panel whose beads are made of many faces, as CAD systems make them: walls and fillets of the kernel.
#pragma once

#include <filesystem>

namespace beadmesh::examples {

/// Flat, 320 x 200 mm: a straight bead, an arc, a T and a ring with vertical walls, root fillets of 3 and top
/// fillets of 2 mm, and a round emboss of the same kind that is no bead. STEP, mm; false where it cannot be
/// made or written.
bool write_filleted_panel(const std::filesystem::path& path);

}  // namespace beadmesh::examples
