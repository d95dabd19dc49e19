// The mesh of one bead, before it is put into the panel's mesh.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "beadmesh/bead/ridge.h"
#include "beadmesh/mesh/sliding_lines.h"

namespace beadmesh {

/// A node on the boundary of the face: neighbours take it over.
struct BoundaryNode {
  Index node = no_index;
  BoundaryPosition at;
};

struct BeadMesh {
  PlanarMesh mesh;
  std::vector<BoundaryNode> boundary;           ///< every boundary node once
  std::vector<std::vector<Index>> crest_lines;  ///< nodes along every ridge curve; closed: first == last
  std::vector<SlidingLine> lines;               ///< what sliding nodes slide along
  std::string method;                           ///< "blocks", "ridge" or "fallback"
  std::vector<std::string> notes;               ///< why an earlier method was left
  std::vector<std::string> refusals;            ///< counts asked for that could not be met, and why
  int elements_across = 0;                      ///< of blocks; else 0
  std::vector<Index> cap_elements;              ///< those of the clamps of blocks, ascending
};

}  // namespace beadmesh
