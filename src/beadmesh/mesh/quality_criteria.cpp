#include "beadmesh/mesh/quality_criteria.h"

#include <algorithm>
#include <cmath>

#include "beadmesh/mesh/element_quality.h"

namespace beadmesh {
namespace {

constexpr std::string_view names[measure_count] = {
    "min length",     "max length",     "aspect ratio", "warpage",  "max angle quad", "min angle quad",
    "max angle tria", "min angle tria", "skew",         "jacobian", "chordal dev",    "% of trias"};

/// Angle between two lines, at most a right angle, degrees.
double line_angle(Vec3 u, Vec3 v) {
  const double angle = degrees(angle_between(u, v));
  return std::min(angle, 180 - angle);
}

double skew_of(const std::vector<Vec3>& nodes, const MeshElement& element) {
  const int count = corner_count(element);
  std::array<Vec3, 4> middle;
  for (int i = 0; i < count; ++i) middle[i] = (nodes[element[i]] + nodes[element[(i + 1) % count]]) / 2;
  if (count == 4) return 90 - line_angle(middle[2] - middle[0], middle[3] - middle[1]);
  double least = 90;
  for (int i = 0; i < 3; ++i)
    least =
        std::min(least, line_angle(middle[(i + 1) % 3] - nodes[element[i]], middle[i] - middle[(i + 2) % 3]));
  return 90 - least;
}

/// Of the bilinear map, seen along the mean normal.
double jacobian_of(const std::vector<Vec3>& nodes, const MeshElement& element) {
  if (!is_quad(element)) return 1;
  const Vec3 a = nodes[element[0]], b = nodes[element[1]], c = nodes[element[2]], d = nodes[element[3]];
  const Vec3 normal = normalized(cross(c - a, d - b));
  const double gauss = 1 / std::sqrt(3.0);
  double least = 1e300, largest = -1e300;
  for (const double u : {-gauss, gauss})
    for (const double v : {-gauss, gauss}) {
      const Vec3 along_u = (b - a) * (1 - v) + (c - d) * (1 + v);
      const Vec3 along_v = (d - a) * (1 - u) + (c - b) * (1 + u);
      const double determinant = dot(cross(along_u, along_v), normal);
      least = std::min(least, determinant), largest = std::max(largest, determinant);
    }
  return largest > 0 ? least / largest : 0;
}

/// Rows as in criteria files, but for weights and switches.
struct PresetLimits {
  std::string_view name;
  double size, min_length, max_length, aspect, triangles;
};
constexpr PresetLimits presets[] = {
    {"crash", 5, 2.5, 10, 5, 5}, {"nvh", 10, 4, 20, 8, 10}, {"durability", 5, 1.5, 10, 5, 5}};

Criterion between(double ideal, double fail, double worst) {
  const auto part = [&](double t) { return ideal + t * (fail - ideal); };
  return {true, 1, ideal, part(0.4), part(0.8), fail, worst};
}

QualityCriteria criteria_of(const PresetLimits& limits) {
  using enum QualityMeasure;
  QualityCriteria criteria;
  criteria[min_length] = between(limits.size, limits.min_length, 0);
  criteria[max_length] = between(limits.size, limits.max_length, 2 * limits.max_length);
  criteria[aspect_ratio] = between(1, limits.aspect, 2 * limits.aspect);
  criteria[warpage] = between(0, 15, 90);
  criteria[max_angle_quad] = between(90, 140, 180);
  criteria[min_angle_quad] = between(90, 40, 0);
  criteria[max_angle_tria] = between(60, 120, 180);
  criteria[min_angle_tria] = between(60, 20, 0);
  criteria[skew] = between(0, 60, 90);
  criteria[jacobian] = between(1, 0.6, 0);
  criteria[chordal_deviation] = between(0, 0.2 * limits.size, limits.size);
  criteria[chordal_deviation].on = false;
  criteria[triangle_share] = between(0, limits.triangles, 3 * limits.triangles);
  return criteria;
}

void take(MeasureFindings& findings, const Criterion& criterion, double value, Index element) {
  const bool is_worse =
      !findings.extreme || (criterion.large_is_bad() ? value > *findings.extreme : value < *findings.extreme);
  if (is_worse) findings.extreme = value, findings.extreme_element = element;
  if (!criterion.on) return;
  findings.failed += criterion.fails(value);
  findings.warned += criterion.warns(value);
}

}  // namespace

std::string_view name_of(QualityMeasure measure) {
  return names[static_cast<size_t>(measure)];
}

QualityCriteria criteria_of_sizes(double size, double min_edge) {
  const bool coarse = size >= presets[1].size;
  const PresetLimits& like = coarse ? presets[1] : presets[0];
  return criteria_of({"", size, min_edge, 2 * size, like.aspect, like.triangles});
}

std::optional<QualityCriteria> criteria_of_preset(std::string_view preset) {
  for (const PresetLimits& limits : presets)
    if (limits.name == preset) return criteria_of(limits);
  return std::nullopt;
}

std::optional<double> measured(const std::vector<Vec3>& nodes, const MeshElement& element,
                               QualityMeasure measure) {
  const bool quad = is_quad(element);
  switch (measure) {
    case QualityMeasure::min_length:
      return side_lengths(nodes, element)[0];
    case QualityMeasure::max_length:
      return side_lengths(nodes, element)[1];
    case QualityMeasure::aspect_ratio: {
      const auto [shortest, longest] = side_lengths(nodes, element);
      return shortest > 0 ? longest / shortest : 1e300;
    }
    case QualityMeasure::warpage:
      if (!quad) return std::nullopt;
      return degrees(warpage(nodes, element));
    case QualityMeasure::max_angle_quad:
    case QualityMeasure::max_angle_tria:
      if (quad != (measure == QualityMeasure::max_angle_quad)) return std::nullopt;
      return degrees(corner_angles(nodes, element)[1]);
    case QualityMeasure::min_angle_quad:
    case QualityMeasure::min_angle_tria:
      if (quad != (measure == QualityMeasure::min_angle_quad)) return std::nullopt;
      return degrees(corner_angles(nodes, element)[0]);
    case QualityMeasure::skew:
      return skew_of(nodes, element);
    case QualityMeasure::jacobian:
      return jacobian_of(nodes, element);
    case QualityMeasure::chordal_deviation:
    case QualityMeasure::triangle_share:
      break;
  }
  return std::nullopt;
}

bool CriteriaFindings::holds() const {
  return failing == 0 && (*this)[QualityMeasure::triangle_share].failed == 0;
}

CriteriaFindings judge(const std::vector<Vec3>& nodes, const std::vector<MeshElement>& elements,
                       const QualityCriteria& criteria, const std::vector<Index>& group) {
  CriteriaFindings findings;
  int triangles = 0;
  const auto look = [&](Index at) {
    const MeshElement& element = elements[at];
    ++findings.elements;
    triangles += !is_quad(element);
    bool fails = false;
    for (int m = 0; m < measure_count; ++m) {
      const auto value = measured(nodes, element, static_cast<QualityMeasure>(m));
      if (!value) continue;
      take(findings.of[m], criteria.of[m], *value, at);
      fails |= criteria.of[m].on && criteria.of[m].fails(*value);
    }
    findings.failing += fails;
  };
  if (group.empty())
    for (Index e = 0; e < static_cast<Index>(elements.size()); ++e) look(e);
  else
    for (const Index e : group) look(e);
  if (findings.elements > 0)
    take(findings.of[static_cast<size_t>(QualityMeasure::triangle_share)],
         criteria[QualityMeasure::triangle_share], 100.0 * triangles / findings.elements, no_index);
  return findings;
}

}  // namespace beadmesh
