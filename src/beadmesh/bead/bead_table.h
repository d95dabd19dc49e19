// What the recognition says about a panel: its beads, and why the other faces are none.
#pragma once

#include <string>
#include <vector>

#include "beadmesh/bead/bead.h"
#include "beadmesh/core/diagnostic.h"
#include "beadmesh/medial/face_medial.h"

namespace beadmesh {

struct RejectedFace {
  Index face = 0;  ///< 1-based number
  std::string reason;
};

struct BeadTable {
  std::vector<Bead> beads;
  std::vector<RejectedFace> faces_not_beads;
  std::vector<FaceMedial> medials;      ///< of the faces that are beads
  std::vector<Diagnostic> diagnostics;  ///< those of the reader first
};

}  // namespace beadmesh
