// The quality of a mesh file as JSON.
#pragma once

#include <string>

#include "beadmesh/mesh/element_quality.h"

namespace beadmesh {

/// Schema beadmesh.check/1: { schema, input, size, min_edge, mesh: { nodes, quads, trias, quality } }, the
/// mesh object as in beadmesh.beads/1. A size or min_edge of 0 was not given and becomes null.
std::string quality_json(const std::string& input, const QualitySummary& quality, double size,
                         double min_edge);

}  // namespace beadmesh
