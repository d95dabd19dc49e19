// The report of a run as one HTML file that needs no network.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "beadmesh/bead/design_check.h"
#include "beadmesh/mesh/panel_mesh.h"
#include "beadmesh/mesh/quality_criteria.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh {

struct ReportFacts {
  std::string title;                                          ///< headline, for example the name of the panel
  std::vector<std::pair<std::string, std::string>> settings;  ///< name and value: size, minimum edge, ...
  double min_edge = 0;                                        ///< mm; 0: none
  std::optional<QualityCriteria> criteria = {};               ///< limits of the quality table
  std::vector<BeadDesign> designs = {};                       ///< judged; none: no design table
  DesignLimits design_limits = {};                            ///< shown in the heads of the design table
};

/// Of a panel meshed with these lengths (mm), judged by criteria_of_sizes.
ReportFacts facts_of_run(const Panel& panel, double size, double min_edge, double thickness);
/// Of a panel whose beads were recognised, without a mesh.
ReportFacts facts_of_recognition(const Panel& panel, const BeadTable& table);

/// The panel in 3-D with its beads, crest lines, medial axes, blocks and mesh; tables of beads, their
/// design, quality, diagnostics, and faces that are no beads with the reason. A mesh without elements: what
/// was recognised. Nothing in it changes from run to run. docs/report.md is its manual.
std::string panel_html(const Panel& panel, const PanelMesh& mesh, const ReportFacts& facts);

}  // namespace beadmesh
