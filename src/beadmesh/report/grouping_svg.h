// A picture of how faces were grouped: every face of the input, what it became, and why.
#pragma once

#include <string>
#include <vector>

#include "beadmesh/bead/bead_table.h"
#include "beadmesh/bead/composite_faces.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh {

/// A whole SVG file: the faces of `input` (the panel before compose_faces) by their outlines, painted by what
/// they became in `composed`, and a line of text for every decision under the picture. Each face says its
/// number and its reason where the pointer rests.
std::string grouping_svg(const Panel& input, const Panel& composed, const BeadTable& table,
                         const std::vector<GroupDecision>& decisions);

}  // namespace beadmesh
