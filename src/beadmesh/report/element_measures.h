// Internal to the room: the measures by which the report can colour the mesh.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadmesh/mesh/quality_criteria.h"
#include "beadmesh/mesh/shell_mesh.h"

namespace beadmesh {

struct ElementMeasure {
  std::string name, unit;  ///< "min length", "mm"
  std::string meaning;     ///< one line
  bool large_is_bad = false;
  std::optional<double> limit;                ///< beyond it an element fails; none: not judged
  std::vector<std::optional<double>> values;  ///< per element; none where it does not apply
  std::vector<bool> failing;                  ///< per element
  double low = 0, high = 0;                   ///< range of the values
};

/// Scaled Jacobian and the element measures of the criteria, angles of quads and triangles in one; a value
/// that is no number or beyond 1e6 counts as 1e6. Measures that apply to no element are left out.
std::vector<ElementMeasure> element_measures(const ShellMesh& mesh,
                                             const std::optional<QualityCriteria>& criteria);

}  // namespace beadmesh
