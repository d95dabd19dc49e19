// Internal to the room: the tables of the HTML report. The viewer makes them sortable and clickable: rows say
// what they are about in data-bead, data-face and data-element.
#pragma once

#include <string>

#include "beadmesh/report/panel_html.h"

namespace beadmesh::report_tables {

/// Sections of HTML, each with a heading.
std::string overview(const PanelMesh& mesh);  ///< figures; empty without a mesh
std::string beads(const Panel& panel, const PanelMesh& mesh);
std::string design(const ReportFacts& facts);                          ///< empty where nothing was measured
std::string quality(const PanelMesh& mesh, const ReportFacts& facts);  ///< empty without a mesh or limits
std::string diagnostics(const BeadTable& table);
std::string faces_not_beads(const BeadTable& table);

}  // namespace beadmesh::report_tables
