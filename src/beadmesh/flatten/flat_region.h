// The boundary of a flat face as a region of the plane.
#pragma once

#include <vector>

#include "beadmesh/delaunay/planar_region.h"
#include "beadmesh/flatten/flat_face.h"

namespace beadmesh {

/// loops[l].points[i] is the image of facets.loops[l][i], so that segment i belongs to facets.loops[l][i] ->
/// [i + 1]. corners[l][i]: is that point a tangent discontinuity; `corners` or a row of it may be empty:
/// decided from the angle.
PlanarRegion flat_region(const Facets& facets, const FlatFace& flat,
                         const std::vector<std::vector<bool>>& corners = {});

}  // namespace beadmesh
