// The bead table as JSON, schema beadmesh.beads/1 (docs: the product contract).
#pragma once

#include <string>
#include <vector>

#include "beadmesh/bead/bead_table.h"
#include "beadmesh/bead/design_check.h"
#include "beadmesh/mesh/panel_mesh.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh {

/// Lengths in mm, faces by their 1-based numbers in the file, angles in degrees.
std::string bead_json(const Panel& panel, const BeadTable& table);
/// The same with an object `design` for each bead; of each bead of the table, or none.
std::string bead_json(const Panel& panel, const BeadTable& table, const std::vector<BeadDesign>& designs);
/// The same with how each bead was meshed and the quality of the mesh; designs of all beads, or none.
std::string bead_json(const Panel& panel, const PanelMesh& mesh, const std::vector<BeadDesign>& designs = {});

}  // namespace beadmesh
