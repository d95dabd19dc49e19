// Inside the read room: Stanford PLY.
#pragma once

#include <string>

#include "beadmesh/core/result.h"
#include "beadmesh/read/facet_mesh.h"

namespace beadmesh {

/// ASCII, binary little and big endian: x, y, z of `vertex`, the list vertex_indices (or vertex_index) of
/// `face`; other properties and elements are passed over, polygons are cut into triangles. Fails with
/// read.truncated, read.unreadable; `name` is the entity.
Result<LooseFacets> parse_ply(const std::string& bytes, const std::string& name);

}  // namespace beadmesh
