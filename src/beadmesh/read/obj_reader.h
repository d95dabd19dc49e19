// Inside the read room: Wavefront OBJ.
#pragma once

#include <string>

#include "beadmesh/core/result.h"
#include "beadmesh/read/facet_mesh.h"

namespace beadmesh {

/// Vertices and faces; polygons are cut into triangles. Groups, materials, normals, textures, lines and
/// curves are passed over. Fails with read.unreadable (the line); `name` is the entity.
Result<LooseFacets> parse_obj(const std::string& bytes, const std::string& name);

}  // namespace beadmesh
