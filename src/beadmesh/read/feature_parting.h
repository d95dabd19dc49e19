// Inside the read room: features that only meet at their feet, parted.
#pragma once

#include <vector>

#include "beadmesh/read/facet_mesh.h"

namespace beadmesh {

/// Parts a connected piece (triangles, ascending) by its heights over the sheet (mm, one a triangle, of
/// either sign): two peaks stay together where the way between them keeps at least `saddle` of the lower one.
/// Peaks under `min_height` or a fifth of the highest are none.
std::vector<std::vector<Index>> parted_features(const FacetMesh& mesh, const std::vector<Index>& piece,
                                                const std::vector<double>& heights, double saddle,
                                                double min_height);

}  // namespace beadmesh
