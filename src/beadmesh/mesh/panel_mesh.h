// The meshed panel and how each of its beads was meshed.
#pragma once

#include <string>
#include <vector>

#include "beadmesh/bead/bead_table.h"
#include "beadmesh/mesh/element_quality.h"
#include "beadmesh/mesh/shell_mesh.h"

namespace beadmesh {

/// How a bead was meshed.
struct BeadMeshing {
  std::string method;  ///< "blocks", "ridge", "face" (as asked for) or "fallback"
  int elements = 0;
  std::vector<std::string> notes = {};
  int elements_across = 0;  ///< of blocks; else 0
  double size = 0;          ///< target element length, mm
  double min_edge = 0;      ///< minimum element length, mm
};

struct PanelMesh {
  BeadTable table;
  std::vector<BeadMeshing> meshing;  ///< per bead
  ShellMesh mesh;
  QualitySummary quality;
};

}  // namespace beadmesh
