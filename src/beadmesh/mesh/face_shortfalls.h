// Which faces break the hard rules, and why.
#pragma once

#include <vector>

#include "beadmesh/core/diagnostic.h"
#include "beadmesh/mesh/shell_mesh.h"

namespace beadmesh {

/// A warning (mesh.face.inverted, mesh.face.min_edge) for every face with elements turned over, or with edges
/// under `min_edge`: how many, the shortest, and whether its own boundary, its width or the mesh inside is
/// the reason. In the order of the faces' numbers; an edge of two faces is told for both.
std::vector<Diagnostic> face_shortfalls(const ShellMesh& mesh, double min_edge);

}  // namespace beadmesh
