// Limits of a criteria file.
#pragma once

#include <string>

#include "beadmesh/core/result.h"
#include "beadmesh/mesh/quality_criteria.h"

namespace beadmesh::app {

/// Reads the file; rows that are not known are named on standard error. Fails with criteria.*.
Result<QualityCriteria> read_criteria(const std::string& name);

}  // namespace beadmesh::app
