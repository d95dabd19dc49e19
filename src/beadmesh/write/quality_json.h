// The quality of a mesh file as JSON.
#pragma once

#include <string>
#include <vector>

#include "beadmesh/mesh/element_quality.h"
#include "beadmesh/mesh/quality_criteria.h"

namespace beadmesh {

/// Findings of the whole mesh or of one of its parts.
struct PartFindings {
  std::string name;  ///< "all", or the property
  CriteriaFindings findings;
};

/// A judged mesh: the limits and what they find, the whole mesh first. No parts: not judged.
struct JudgedMesh {
  QualityCriteria criteria;
  std::vector<PartFindings> parts;
};

/// Schema beadmesh.check/1: { schema, input, size, min_edge, mesh: { nodes, quads, trias, quality } }, the
/// mesh object as in beadmesh.beads/1. A size or min_edge of 0 was not given and becomes null.
/// A judged mesh adds criteria: [{ name, on, weight, ideal, good, warn, fail, worst }] and parts: [{ name,
/// elements, failing, measures: [{ name, extreme, element, failed, warned }] }]; element: position in the
/// deck from 1, null where there is none.
std::string quality_json(const std::string& input, const QualitySummary& quality, double size,
                         double min_edge, const JudgedMesh& judged = {});

}  // namespace beadmesh
