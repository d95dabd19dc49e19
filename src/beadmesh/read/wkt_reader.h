// Inside the read room: the grammar of WKT polygons.
#pragma once

#include <string_view>

#include "beadmesh/core/result.h"
#include "beadmesh/delaunay/planar_region.h"

namespace beadmesh::read {

/// What parse_wkt says in polygon_reader.h.
Result<PlanarRegion> wkt_region(std::string_view text);

}  // namespace beadmesh::read
