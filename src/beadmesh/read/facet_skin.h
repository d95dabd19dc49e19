// Inside the read room: loose triangles become a panel.
#pragma once

#include "beadmesh/panel/panel.h"
#include "beadmesh/read/facet_mesh.h"

namespace beadmesh {

/// Welds corners closer than 1e-6 of the size, orients the triangles alike, and makes one face of each region
/// in which neighbours turn by at most `feature_angle` (radians). Edges run between regions and along free or
/// branching borders, from one point where more than two such lines meet, or where they turn sharply, to the
/// next.
Panel panel_of_facets(const LooseFacets& facets, double feature_angle);

}  // namespace beadmesh
