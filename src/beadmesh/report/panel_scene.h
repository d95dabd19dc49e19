// Internal to the room: what the viewer in the report draws, as one JSON text.
#pragma once

#include <string>

#include "beadmesh/mesh/panel_mesh.h"
#include "beadmesh/panel/panel.h"
#include "beadmesh/report/panel_html.h"

namespace beadmesh {

/// Faces, beads, surface, mesh with its measures and the limits they miss, crest lines, medial axes, sides of
/// blocks. Coordinates are whole steps of a millionth of the panel's size from its lowest corner; measures
/// have 65,535 steps from their least to their largest value. docs/report.md has the fields. Without '<', so
/// that it may stand in a script element.
std::string panel_scene(const Panel& panel, const PanelMesh& mesh, const ReportFacts& facts);

}  // namespace beadmesh
