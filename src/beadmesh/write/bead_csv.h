// The bead table for spreadsheets.
#pragma once

#include <string>
#include <vector>

#include "beadmesh/bead/bead_table.h"
#include "beadmesh/bead/design_check.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh {

/// A head line and a line per bead (RFC 4180, line feeds only): id, kind, shape, faces (1-based, joined by
/// blanks), x, y, z of a crest point, loops, length, width, height, aspect_ratio, junctions, ends,
/// medial_edges. Lengths in mm.
std::string bead_csv(const Panel& panel, const BeadTable& table);

/// With the columns depth, depth_to_width, wall_angle (degrees), crown_radius, root_radius, bead_distance,
/// nearest_bead, rim_distance, hole_distance, exceeded (names, joined by blanks); a field is empty where
/// there is no such thing. A design for each bead of the table.
std::string bead_csv(const Panel& panel, const BeadTable& table, const std::vector<BeadDesign>& designs);

}  // namespace beadmesh
