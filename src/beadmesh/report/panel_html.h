// The report of a run as one HTML file that needs no network.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "beadmesh/mesh/panel_mesh.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh {

struct ReportFacts {
  std::string title;                                          ///< headline, for example the name of the panel
  std::vector<std::pair<std::string, std::string>> settings;  ///< name and value: size, minimum edge, ...
};

/// Picture (pan and zoom), quality, beads (sortable), faces that are no beads with reasons, diagnostics.
std::string panel_html(const Panel& panel, const PanelMesh& mesh, const ReportFacts& facts);

}  // namespace beadmesh
