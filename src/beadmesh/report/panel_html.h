// The report of a run as one HTML file that needs no network.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "beadmesh/mesh/panel_mesh.h"
#include "beadmesh/mesh/quality_criteria.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh {

struct ReportFacts {
  std::string title;                                          ///< headline, for example the name of the panel
  std::vector<std::pair<std::string, std::string>> settings;  ///< name and value: size, minimum edge, ...
  double min_edge = 0;                                        ///< mm; 0: none
  std::optional<QualityCriteria> criteria = {};               ///< limits of the quality table
};

/// The panel in 3-D with its beads, crest lines, medial axes, blocks and mesh; tables of beads, quality,
/// diagnostics, and faces that are no beads with the reason. A mesh without elements: what was recognised.
/// Nothing in it changes from run to run. docs/report.md is its manual.
std::string panel_html(const Panel& panel, const PanelMesh& mesh, const ReportFacts& facts);

}  // namespace beadmesh
