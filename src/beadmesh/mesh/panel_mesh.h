// The meshed panel and how each of its beads was meshed.
#pragma once

#include <string>
#include <vector>

#include "beadmesh/bead/bead_table.h"
#include "beadmesh/blocking/block_layout.h"
#include "beadmesh/mesh/element_quality.h"
#include "beadmesh/mesh/quality_criteria.h"
#include "beadmesh/mesh/shell_mesh.h"

namespace beadmesh {

/// A side of blocks: split line, crest, boundary or a line inside a clamp or hub.
struct BlockSideLine {
  VirtualEdgeKind kind = VirtualEdgeKind::inner;
  std::vector<Vec3> points;  ///< the nodes along it
};

/// How a bead was meshed.
struct BeadMeshing {
  std::string method;  ///< "blocks", "ridge", "face" (as asked for) or "fallback"
  int elements = 0;
  std::vector<std::string> notes = {};
  int elements_across = 0;  ///< of blocks; else 0
  double size = 0;          ///< target element length, mm
  double min_edge = 0;      ///< minimum element length, mm
  int blocks = 0;           ///< four-sided blocks that it was cut into; 0 for other methods
  std::vector<BlockSideLine> block_lines = {};  ///< each side of the blocks once
};

struct PanelMesh {
  BeadTable table;
  std::vector<BeadMeshing> meshing;  ///< per bead
  ShellMesh mesh;
  QualitySummary quality;
  JudgedMesh judged;  ///< beads in the order of mesh.beads
};

}  // namespace beadmesh
