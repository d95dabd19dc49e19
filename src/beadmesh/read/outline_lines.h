// Inside the read room: where a feature of a facetted skin ends, as lines of facet edges and as smooth
// curves.
#pragma once

#include <optional>
#include <vector>

#include "beadmesh/read/facet_grouping.h"
#include "beadmesh/read/facet_mesh.h"
#include "beadmesh/read/outline_curve.h"

namespace beadmesh {

/// A closed line of facet edges between a feature (on its left) and one other face, that no other line meets.
struct OutlineLine {
  std::vector<Index> half_edges;
  Index inside = no_index, outside = no_index;  ///< faces
};
std::vector<OutlineLine> outline_lines(const FacetMesh& mesh, const FacetGroups& groups);

/// The smooth curve that such a line follows, with teeth and spikes left out. Corners (65 degrees within 3
/// mm) stay. `even`: facets are of one size, and may not know the outline (sheet_band.h). Nothing for a line
/// that is smooth already, or too short to tell.
struct FairedOutline {
  OutlineCurve curve;
  double facet = 0;  ///< mm, how far facets reach across the line, in the median
};
std::optional<FairedOutline> faired_outline(const FacetMesh& mesh, const FacetGroups& groups,
                                            const OutlineLine& line, bool even);

}  // namespace beadmesh
