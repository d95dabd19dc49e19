// Mapped meshes of all blocks of a layout (transfinite interpolation, Gordon and Hall 1973).
#pragma once

#include <vector>

#include "beadmesh/blocking/block_layout.h"
#include "beadmesh/flatten/flat_face.h"
#include "beadmesh/mesh/bead_mesh.h"

namespace beadmesh {

/// Length of every virtual edge on the surface.
std::vector<double> edge_lengths(const BlockLayout& layout, const SurfaceMap& map);

/// All quads, not smoothed. Every edge must have its count. Nodes of one edge are evenly spaced on the
/// surface, prescribed ones excepted. Crest nodes are free to slide, boundary nodes and ends of crest lines
/// are fixed.
BeadMesh map_blocks(const BlockLayout& layout, const SurfaceMap& map);

}  // namespace beadmesh
