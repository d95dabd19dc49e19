// Inside the read room: facets cut along the smooth outlines of features.
#pragma once

#include "beadmesh/read/facet_grouping.h"
#include "beadmesh/read/facet_mesh.h"

namespace beadmesh {

struct OutlineCutOptions {
  double keep = 0.1;   ///< default 0.1 facets: points as near to the curve as that stay where they are
  double move = 0.35;  ///< default 0.35 facets: points as near as that are moved onto it
  double band = 3;     ///< default 3 facets: how far from the curve facets change sides
};

/// Outlines follow facet edges and have teeth where those run across the foot of a feature. Each closed one
/// is replaced by the smooth curve beside it (outline_lines.h): points nearby move onto it, along the sheet
/// and as far as no facet turns over, other facets are cut, and each facet belongs to the side on which it
/// lies. Outlines that meet others stay.
void cut_along_outlines(FacetMesh& mesh, FacetGroups& groups, const OutlineCutOptions& options = {});

}  // namespace beadmesh
