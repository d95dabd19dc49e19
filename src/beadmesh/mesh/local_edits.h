// Small edits at one node of a quad mesh: collapses, rotated edges, split nodes.
#pragma once

#include <vector>

#include "beadmesh/mesh/mesh_editor.h"

namespace beadmesh {

/// Finds and makes the best small edit at `node` (after Canann, Muthukrishnan, Phillips 1996/98): a quad
/// collapsed to a diagonal, an edge rotated in the hexagon of its two quads, two adjacent nodes of valence
/// three taken out, a node of high valence split. False where none helps. `touched`: nodes around the edit.
bool improve_locally(MeshEditor& editor, Index node, std::vector<Index>& touched);

/// Takes out inner nodes between two quads only. Returns the number of edits.
int remove_doublets(MeshEditor& editor);

/// Edges below the minimum length that movement cannot repair: a quad at the edge is collapsed or an edge
/// near it rotated, even where that makes nodes irregular. Returns the number of edits.
int remove_short_edges(MeshEditor& editor);

/// The elements whose scaled Jacobian is below `wanted`, worst first; not more than a small share of the
/// mesh.
std::vector<Index> poor_elements(const MeshEditor& editor, double wanted);

/// Elements whose scaled Jacobian is below `wanted`: edits at their corners that raise the worst one around,
/// even where they make nodes irregular. Returns the number of edits.
int improve_shapes(MeshEditor& editor, double wanted);

}  // namespace beadmesh
