// Inside the read room: how sure a feature of facets is.
#pragma once

#include <vector>

#include "beadmesh/read/facet_grouping.h"
#include "beadmesh/read/facet_mesh.h"

namespace beadmesh {

/// Per face, in (0, 1]; 0 for faces that are no features. The product of two: how clearly facets turn at the
/// outline (6 degrees more than those of the sheet beside it count as clear), and how many facets lie across
/// (2.5 are enough).
std::vector<double> confidences(const FacetMesh& mesh, const FacetGroups& groups);

}  // namespace beadmesh
