// Inside the read room: outlines of features that run along facet edges, without teeth.
#pragma once

#include "beadmesh/read/facet_grouping.h"
#include "beadmesh/read/facet_mesh.h"

namespace beadmesh {

struct OutlineOptions {
  double flat =
      0.06;  ///< default 0.06 mm: a facet that rises less over the sheet beside it may belong to either
  double tooth = 1.5;  ///< default 1.5: rim over base of what is a tooth; the ears of a round outline have 1
  double sliver =
      0.25;  ///< default 0.25: height over longest side under which a facet of the sheet may go over
};

/// First gives facets that could belong to either side to the one that makes the outline shorter, then cuts
/// the facets along smooth outlines (outline_cutting.h).
void straighten_outlines(FacetMesh& mesh, FacetGroups& groups, const OutlineOptions& options = {});

}  // namespace beadmesh
