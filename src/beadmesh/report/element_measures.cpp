#include "beadmesh/report/element_measures.h"

#include <algorithm>
#include <cmath>

#include "beadmesh/mesh/element_quality.h"

namespace beadmesh {
namespace {

constexpr double largest_shown = 1e6;

/// A measure of the report and the criteria of quads and triangles it stands for.
struct MeasureRow {
  QualityMeasure of_quad, of_tria;
  const char *name, *unit;
  bool large_is_bad;
  const char* meaning;
};

using enum QualityMeasure;
constexpr MeasureRow rows[] = {
    {jacobian, jacobian, "jacobian", "", false, "least over largest determinant at the 2 x 2 Gauss points"},
    {min_length, min_length, "min length", "mm", false, "shortest side"},
    {max_length, max_length, "max length", "mm", true, "longest side"},
    {aspect_ratio, aspect_ratio, "aspect ratio", "", true, "longest over shortest side"},
    {warpage, warpage, "warpage", "°", true,
     "angle between the two triangles of a quad, the larger of both diagonals"},
    {skew, skew, "skew", "°", true,
     "90° less the smallest angle between the lines through opposite side middles"},
    {min_angle_quad, min_angle_tria, "min angle", "°", false, "smallest corner angle"},
    {max_angle_quad, max_angle_tria, "max angle", "°", true, "largest corner angle"},
};

constexpr MeasureRow scaled = {
    jacobian, jacobian, "scaled Jacobian",
    "",       false,    "sine of the worst corner; 1 is a square, 0 and below is inverted"};

double shown(double value) {
  return std::isfinite(value) ? std::clamp(value, -largest_shown, largest_shown) : largest_shown;
}

void close(ElementMeasure& measure, std::vector<ElementMeasure>& out) {
  bool any = false;
  for (const auto& value : measure.values) {
    if (!value) continue;
    measure.low = any ? std::min(measure.low, *value) : *value;
    measure.high = any ? std::max(measure.high, *value) : *value;
    any = true;
  }
  if (any) out.push_back(std::move(measure));
}

ElementMeasure empty(const MeasureRow& row, size_t elements) {
  ElementMeasure measure{row.name, row.unit, row.meaning, row.large_is_bad, std::nullopt, {}, {}, 0, 0};
  measure.values.reserve(elements);
  measure.failing.reserve(elements);
  return measure;
}

ElementMeasure measure_of(const ShellMesh& mesh, const MeasureRow& row,
                          const std::optional<QualityCriteria>& criteria) {
  ElementMeasure measure = empty(row, mesh.elements.size());
  if (criteria && (*criteria)[row.of_quad].on) measure.limit = (*criteria)[row.of_quad].fail;
  for (const ShellElement& element : mesh.elements) {
    const QualityMeasure which = is_quad(element.nodes) ? row.of_quad : row.of_tria;
    const auto value = measured(mesh.nodes, element.nodes, which);
    measure.values.push_back(value ? std::optional(shown(*value)) : std::nullopt);
    measure.failing.push_back(value && criteria && (*criteria)[which].on && (*criteria)[which].fails(*value));
  }
  return measure;
}

}  // namespace

std::vector<ElementMeasure> element_measures(const ShellMesh& mesh,
                                             const std::optional<QualityCriteria>& criteria) {
  std::vector<ElementMeasure> all;
  ElementMeasure jacobians = empty(scaled, mesh.elements.size());
  jacobians.limit = 0;
  for (const ShellElement& element : mesh.elements) {
    jacobians.values.push_back(shown(scaled_jacobian(mesh.nodes, element.nodes)));
    jacobians.failing.push_back(!(*jacobians.values.back() > 0));
  }
  close(jacobians, all);
  for (const MeasureRow& row : rows) {
    ElementMeasure measure = measure_of(mesh, row, criteria);
    close(measure, all);
  }
  return all;
}

}  // namespace beadmesh
