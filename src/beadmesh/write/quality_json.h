// The quality of a mesh file as JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadmesh/mesh/element_quality.h"
#include "beadmesh/mesh/quality_criteria.h"

namespace beadmesh {

/// What a repair pass did, and what it found before.
struct RepairFacts {
  int zones = 0;
  int moved_nodes = 0;
  CriteriaFindings before;  ///< of the whole mesh
};

/// Schema beadmesh.check/1: { schema, input, size, min_edge, mesh: { nodes, quads, trias, quality } }, the
/// mesh object as in beadmesh.beads/1. A size or min_edge of 0 was not given and becomes null.
/// A judged mesh adds criteria: [{ name, on, weight, ideal, good, warn, fail, worst }], parts and, in the
/// same layout, beads: [{ name, elements, failing, measures: [{ name, extreme, element, failed, warned }] }];
/// element: its number in the deck (`element_ids`), null where there is none. A repaired mesh adds repair:
/// { zones, moved_nodes, failing_before, failed_before: { name: number } }.
std::string quality_json(const std::string& input, const QualitySummary& quality, double size,
                         double min_edge, const JudgedMesh& judged = {},
                         const std::vector<Index>& element_ids = {},
                         const std::optional<RepairFacts>& repair = {});

}  // namespace beadmesh
