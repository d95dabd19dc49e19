// Inside the read room: the grammar of Triangle's .poly files.
#pragma once

#include <string_view>

#include "beadmesh/core/result.h"
#include "beadmesh/delaunay/planar_region.h"

namespace beadmesh::read {

/// What parse_poly says in polygon_reader.h.
Result<PlanarRegion> poly_region(std::string_view text);

}  // namespace beadmesh::read
