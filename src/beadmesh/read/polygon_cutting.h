// Inside the read room: polygons of a facetted file become triangles.
#pragma once

#include <vector>

#include "beadmesh/read/facet_mesh.h"

namespace beadmesh {

/// Adds the triangles of a polygon with three or more corners (indices in `points`). A quad is cut along its
/// shorter diagonal; a polygon with more corners becomes a fan, which covers it where it is convex.
void cut_polygon(const std::vector<Vec3>& points, const std::vector<Index>& polygon, LooseFacets& facets);

}  // namespace beadmesh
