// Inside the read room: STL, ASCII and binary.
#pragma once

#include <string>

#include "beadmesh/core/result.h"
#include "beadmesh/read/facet_mesh.h"

namespace beadmesh {

/// Facets of a file's bytes, in its unit. Fails with read.truncated, read.unreadable; `name` is the entity.
Result<LooseFacets> parse_stl(const std::string& bytes, const std::string& name);

}  // namespace beadmesh
