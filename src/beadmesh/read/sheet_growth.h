// Inside the read room: the slowly curving parts of a facetted skin.
#pragma once

#include <vector>

#include "beadmesh/read/facet_mesh.h"

namespace beadmesh {

struct SheetGrowthOptions {
  double turn = radians(3);        ///< default 3 degrees: from the direction of the sheet nearby
  double rim_turn = radians(1.2);  ///< default 1.2 degrees: the same where a patch ends
  double most_turn = radians(8);   ///< default 8 degrees: between two coarse facets of a curved sheet
  double least_radius = 150;       ///< default 150 mm: what bends more is no sheet
  double memory = 5;               ///< default 5 mm: width of a facet that tells the direction by itself
  double least_width = 3;  ///< default 3 mm: narrower patches are none; twice the area per circumference
};

/// Per triangle the number of its patch, from 0, or no_index. A patch grows from its flattest facets over
/// those that agree with the direction of the sheet nearby, which follows slowly: a fillet turns away from it
/// within a fraction of its radius however fine its facets are, while a bent sheet takes it along.
std::vector<Index> grow_sheets(const FacetMesh& mesh, const SheetGrowthOptions& options = {});

}  // namespace beadmesh
