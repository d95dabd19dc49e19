// THE flow, in the order of the paper: read, flatten, medial object, recognise, block, mesh.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "beadmesh/bead/bead_table.h"
#include "beadmesh/bead/recognition.h"
#include "beadmesh/core/context.h"
#include "beadmesh/core/result.h"
#include "beadmesh/medial/face_medial.h"
#include "beadmesh/mesh/panel_mesh.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh {

struct MeshSizes {
  double size = 5;        ///< default 5 mm: target element length
  double min_edge = 2.5;  ///< default 2.5 mm: minimum element length, hard
  double thickness = 1;   ///< default 1 mm: shell thickness written into the properties
};

/// Sections 3 and 4.1: every face that is a bead, with its medial object. Never fails for a single face.
BeadTable recognise_beads(const Panel& panel, const BeadOptions& options = {}, const Context& context = {});

/// Sections 4.2 to 5.3. Fails only where nothing could be meshed at all.
Result<PanelMesh> mesh_panel(const Panel& panel, const MeshSizes& sizes, const BeadOptions& options = {},
                             const Context& context = {});

/// The medial object of any face (index in Panel::faces).
Result<FaceMedial> medial_of_face(const Panel& panel, Index face);

}  // namespace beadmesh
