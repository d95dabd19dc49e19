// What a perfect reader of an example panel would report.
#pragma once

#include <string>
#include <vector>

#include "examples/panel_design.h"

namespace beadmesh::examples {

/// One entry a feature, in the design's order; `kind` is empty where the paper's rule sees no bead.
struct FeatureTruth {
  std::string name;   ///< of the feature, where several have one letter
  std::string shape;  ///< letter of the bead table, or what the feature is instead of a bead
  std::string kind;   ///< "I", "generic", "annular" or empty
  int loops = 1;
  double length = 0;                  ///< mm, of the centre lines in plan
  double width = 0;                   ///< mm, mean along them
  double height = 0;                  ///< mm, without sign
  std::vector<PlanLoop> footprint;    ///< on the panel, outer loop first
  std::vector<PlanLoop> centrelines;  ///< on the panel; the crest lies over them

  /// Does the footprint hold the plan point?
  bool contains(Vec2 p) const;
};

std::vector<FeatureTruth> truth_of(const PanelDesign& design);

/// The same as JSON: a list `features` with shape, paper_rule, height, mean_width, centreline_length, the
/// footprint's loops of lines {t: "L", p, q} and arcs {t: "A", c, r, a0, ang}, and the centre lines as lists
/// of points.
std::string truth_json(const PanelDesign& design);

}  // namespace beadmesh::examples
