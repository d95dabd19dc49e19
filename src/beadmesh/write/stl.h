// Facets only, for viewers and for programs that read nothing else.
#pragma once

#include <iosfwd>

#include "beadmesh/mesh/shell_mesh.h"
#include "beadmesh/write/deck_options.h"

namespace beadmesh {

/// Binary STL: triangles as they are, a quad as two along the diagonal from its first corner, which is the
/// one nearer to the surface. Single precision. No ids, properties or sets: the format has none. The 80
/// bytes of its head hold the version and the title. `mesh` must have passed check_deck_mesh.
void write_stl(const ShellMesh& mesh, std::ostream& out, const DeckOptions& options = {});

}  // namespace beadmesh
