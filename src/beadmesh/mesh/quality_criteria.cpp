#include "beadmesh/mesh/quality_criteria.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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

/// Elements around each node, one list behind the other.
struct Stars {
  std::vector<Index> first, elements;

  Stars(size_t nodes, const std::vector<MeshElement>& all) : first(nodes + 1, 0) {
    for (const MeshElement& e : all)
      for (int i = 0; i < corner_count(e); ++i) ++first[e[i] + 1];
    for (size_t n = 0; n < nodes; ++n) first[n + 1] += first[n];
    elements.resize(first.back());
    std::vector<Index> at(first.begin(), first.end() - 1);
    for (Index k = 0; k < Index(all.size()); ++k)
      for (int i = 0; i < corner_count(all[k]); ++i) elements[at[all[k][i]]++] = k;
  }
};

/// What is measured of one element.
using Values = std::array<std::optional<double>, measure_count>;

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
      return jacobian_ratio(nodes, element);
    case QualityMeasure::chordal_deviation:
    case QualityMeasure::triangle_share:
      break;
  }
  return std::nullopt;
}

bool CriteriaFindings::holds() const {
  return failing == 0 && (*this)[QualityMeasure::triangle_share].failed == 0;
}

bool fails_any(const std::vector<Vec3>& nodes, const MeshElement& element, const QualityCriteria& criteria) {
  for (int m = 0; m < measure_count; ++m) {
    if (!criteria.of[m].on) continue;
    const auto value = measured(nodes, element, static_cast<QualityMeasure>(m));
    if (value && criteria.of[m].fails(*value)) return true;
  }
  return false;
}

std::vector<double> chordal_deviations(const std::vector<Vec3>& nodes,
                                       const std::vector<MeshElement>& elements) {
  static const double smooth_turn = std::cos(radians(40));
  const Stars stars(nodes.size(), elements);
  std::vector<Vec3> unit;
  for (const MeshElement& e : elements) unit.push_back(normalized(area_normal(nodes, e)));
  const auto normal_at = [&](Index node, Index element) {
    Vec3 sum;
    for (Index k = stars.first[node]; k < stars.first[node + 1]; ++k)
      if (dot(unit[stars.elements[k]], unit[element]) > smooth_turn) sum += unit[stars.elements[k]];
    return normalized(sum);
  };
  std::vector<double> out(elements.size(), 0);
  for (Index k = 0; k < Index(elements.size()); ++k) {
    const MeshElement& e = elements[k];
    std::array<Vec3, 4> normal;
    for (int i = 0; i < corner_count(e); ++i) normal[i] = normal_at(e[i], k);
    for (int i = 0; i < corner_count(e); ++i)
      for (int j = 0; j < i; ++j)
        out[k] = std::max(out[k], std::abs(dot(normal[i] - normal[j], nodes[e[i]] - nodes[e[j]])) / 8);
  }
  return out;
}

namespace {

/// Values of all elements, measured once for all groups they are in.
class Judge {
 public:
  Judge(const std::vector<Vec3>& nodes, const std::vector<MeshElement>& elements,
        const QualityCriteria& criteria)
      : elements_(elements), criteria_(criteria), values_(elements.size()) {
    const std::vector<double> deviations = chordal_deviations(nodes, elements);
    for (size_t e = 0; e < elements.size(); ++e) {
      for (int m = 0; m < measure_count; ++m)
        values_[e][m] = measured(nodes, elements[e], static_cast<QualityMeasure>(m));
      values_[e][static_cast<size_t>(QualityMeasure::chordal_deviation)] = deviations[e];
    }
  }

  template <class Positions>
  CriteriaFindings findings(const Positions& positions) const {
    CriteriaFindings out;
    int triangles = 0;
    for (const Index e : positions) {
      ++out.elements;
      triangles += !is_quad(elements_[e]);
      out.failing += look(e, out);
    }
    if (out.elements > 0)
      take(out.of[static_cast<size_t>(QualityMeasure::triangle_share)],
           criteria_[QualityMeasure::triangle_share], 100.0 * triangles / out.elements, no_index);
    return out;
  }

 private:
  bool look(Index e, CriteriaFindings& out) const {
    bool fails = false;
    for (int m = 0; m < measure_count; ++m) {
      const auto& value = values_[e][m];
      if (!value) continue;
      take(out.of[m], criteria_.of[m], *value, e);
      fails |= criteria_.of[m].on && criteria_.of[m].fails(*value);
    }
    return fails;
  }

  const std::vector<MeshElement>& elements_;
  const QualityCriteria& criteria_;
  std::vector<Values> values_;
};

}  // namespace

JudgedMesh judge(const std::vector<Vec3>& nodes, const std::vector<MeshElement>& elements,
                 const QualityCriteria& criteria, const std::vector<ElementGroup>& parts,
                 const std::vector<ElementGroup>& beads) {
  const Judge judging(nodes, elements, criteria);
  std::vector<Index> all(elements.size());
  std::iota(all.begin(), all.end(), 0);
  JudgedMesh out{criteria, {{"all", judging.findings(all)}}, {}};
  for (const ElementGroup& part : parts) out.parts.push_back({part.name, judging.findings(part.elements)});
  for (const ElementGroup& bead : beads) out.beads.push_back({bead.name, judging.findings(bead.elements)});
  return out;
}

}  // namespace beadmesh
