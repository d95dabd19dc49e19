// The finished mesh of the panel: what the writers take.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "beadmesh/core/vector.h"
#include "beadmesh/mesh/planar_mesh.h"

namespace beadmesh {

struct ShellElement {
  MeshElement nodes;
  Index part = 0;  ///< index in ShellMesh::parts
  Index face = 0;  ///< 1-based number of the panel's face
  Index bead = 0;  ///< id of the bead, 0: none
};

/// A property of the deck.
struct ShellPart {
  Index id = 1;            ///< property id
  std::string name;        ///< "sheet", "bead_I", "bead_generic", "bead_annular"
  double thickness = 1.0;  ///< mm
};

/// Nodes and elements of one bead, as indices in ShellMesh, ascending.
struct BeadSet {
  Index bead = 0;
  std::string kind, shape;
  std::vector<Index> elements, crest_nodes;
  std::vector<Index> boundary_nodes = {};            ///< on edges with one element of the bead
  std::vector<Index> cap_elements = {};              ///< of the clamps at its ends; none where it has none
  std::vector<std::vector<Index>> crest_lines = {};  ///< crest nodes along each line; closed: first == last
};

/// In files ids are index + 1, or count from the first ids of write/deck_options.h.
struct ShellMesh {
  std::string title;
  std::vector<Vec3> nodes;
  std::vector<ShellElement> elements;
  std::vector<ShellPart> parts;
  std::vector<BeadSet> beads;
};

/// Nodes on edges that only one of these elements (indices) has, ascending.
std::vector<Index> boundary_nodes(const ShellMesh& mesh, const std::vector<Index>& elements);

/// Conforming: no repeated or collapsed element, no edge with more than two elements but at the node pairs of
/// `allowed_non_manifold` (where three sheets meet), consistent orientation, no unused node. Violations in
/// words.
std::vector<std::string> verify_shell_mesh(
    const ShellMesh& mesh, const std::vector<std::array<Index, 2>>& allowed_non_manifold = {});

}  // namespace beadmesh
