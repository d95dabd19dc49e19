// All faces of a panel: beads first, then boundary chains, then the other faces, conforming everywhere
// (section 5).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "beadmesh/bead/bead_table.h"
#include "beadmesh/bead/face_study.h"
#include "beadmesh/core/context.h"
#include "beadmesh/core/result.h"
#include "beadmesh/mesh/bead_control.h"
#include "beadmesh/mesh/panel_mesh.h"
#include "beadmesh/mesh/quality_criteria.h"
#include "beadmesh/mesh/size_field.h"
#include "beadmesh/mesh/washers.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh {

struct PanelMesherOptions {
  double size = 5;        ///< default 5 mm: target element length
  double min_edge = 2.5;  ///< default 2.5 mm: minimum element length, hard
  double thickness = 1;   ///< default 1 mm: written into the properties
  BeadControls controls = {};
  std::vector<LocalSize> local_sizes = {};
  WasherControl washers = {};
  double chordal_deviation =
      0;  ///< default 0, no limit, mm: edges off beads get shorter where curves ask for it
  std::optional<QualityCriteria> criteria = {};  ///< limits to judge by; none: criteria_of_sizes
};

/// What the stages before know of each face of the panel; null where it could not be laid flat.
struct StudiedPanel {
  std::vector<std::unique_ptr<FaceStudy>> studies;     ///< per face
  std::vector<std::unique_ptr<MedialObject>> medials;  ///< per face; null where none was needed
  BeadTable table;                                     ///< one bead a face
};

/// A bead that defeats its methods is meshed as an ordinary face and named, a face that defeats every mesher
/// is left out and named. Fails only where no face could be meshed, when cancelled, or with control.*.
Result<PanelMesh> mesh_studied_panel(const Panel& panel, const StudiedPanel& studied,
                                     const PanelMesherOptions& options, const Context& context = {});

}  // namespace beadmesh
