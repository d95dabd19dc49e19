// Pairs of triangles become quads.
#pragma once

#include "beadmesh/mesh/mesh_editor.h"

namespace beadmesh {

/// Moves each triangle through the quads on the shortest way to another one (triangle and quad make a
/// pentagon, which is cut anew) until the two meet and merge. Ways do not cross kept edges. Returns the
/// number of pairs married.
int marry_triangles(MeshEditor& editor);

}  // namespace beadmesh
