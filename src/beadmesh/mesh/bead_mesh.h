// The mesh of one bead, before it is put into the panel's mesh.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "beadmesh/bead/ridge.h"
#include "beadmesh/blocking/block_layout.h"
#include "beadmesh/mesh/sliding_lines.h"

namespace beadmesh {

/// A node on the boundary of the face: neighbours take it over.
struct BoundaryNode {
  Index node = no_index;
  BoundaryPosition at;
};

/// A side of blocks as it was meshed.
struct BlockLine {
  VirtualEdgeKind kind = VirtualEdgeKind::inner;
  std::vector<Index> nodes;  ///< from end to end
};

struct BeadMesh {
  PlanarMesh mesh;
  std::vector<BoundaryNode> boundary;           ///< every boundary node once
  std::vector<std::vector<Index>> crest_lines;  ///< nodes along every ridge curve; closed: first == last
  std::vector<BlockLine> block_lines;           ///< of blocks; else empty
  int blocks = 0;                               ///< four-sided blocks; 0 for other methods
  std::vector<SlidingLine> lines;               ///< what sliding nodes slide along
  std::string method;                           ///< "blocks", "ridge" or "fallback"
  std::vector<std::string> notes;               ///< why an earlier method was left
  std::vector<std::string> refusals;            ///< counts asked for that could not be met, and why
  int elements_across = 0;                      ///< of blocks; else 0
  std::vector<Index> cap_elements;              ///< those of the clamps of blocks, ascending
};

}  // namespace beadmesh
