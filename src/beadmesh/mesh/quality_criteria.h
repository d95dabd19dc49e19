// Element criteria in the definitions and the table layout that pre-processors share.
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "beadmesh/core/vector.h"
#include "beadmesh/mesh/planar_mesh.h"

namespace beadmesh {

/// In the order, and with the numbers from 1, of criteria files. Lengths in mm, angles in degrees.
enum class QualityMeasure {
  min_length,         ///< shortest side
  max_length,         ///< longest side
  aspect_ratio,       ///< longest over shortest side
  warpage,            ///< angle between the two triangles of a quad, the larger of both diagonals
  max_angle_quad,     ///< largest corner angle
  min_angle_quad,     ///< smallest corner angle
  max_angle_tria,     ///< as of quads
  min_angle_tria,     ///< as of quads
  skew,               ///< quad: 90 less the smallest angle between the lines that join opposite side middles;
                      ///< triangle: 90 less the smallest angle between a median and the line joining the
                      ///< middles of the two sides at its corner
  jacobian,           ///< least over largest determinant at the 2 x 2 Gauss points; 1 for triangles
  chordal_deviation,  ///< sagitta of the longest bow over a side or diagonal, by the normals of the
                      ///< neighbours
  triangle_share,     ///< of the whole part, per cent
};
constexpr int measure_count = 12;

/// Name in tables and files: "min length", "aspect ratio", ...
std::string_view name_of(QualityMeasure measure);

/// Limits of one measure. Where `fail` is over `ideal`, large values are bad; else small ones.
struct Criterion {
  bool on = true;
  double weight = 1;
  double ideal = 0, good = 0, warn = 0, fail = 0, worst = 0;

  bool large_is_bad() const { return fail >= ideal; }
  /// A length may miss its limit by a millionth, the width of a file's last digit.
  bool fails(double value) const { return is_beyond(value, fail); }
  bool warns(double value) const { return is_beyond(value, warn) && !fails(value); }

 private:
  bool is_beyond(double value, double limit) const {
    const double margin = 1e-6 * std::abs(limit);
    return large_is_bad() ? value > limit + margin : value < limit - margin;
  }
};

struct QualityCriteria {
  std::array<Criterion, measure_count> of;
  const Criterion& operator[](QualityMeasure measure) const { return of[static_cast<size_t>(measure)]; }
  Criterion& operator[](QualityMeasure measure) { return of[static_cast<size_t>(measure)]; }
};

/// Usual limits of a preset: crash (5 / 2.5 mm), nvh (10 / 4 mm), durability (5 / 1.5 mm); none for another
/// name.
std::optional<QualityCriteria> criteria_of_preset(std::string_view preset);

/// Usual limits at these sizes, mm: as the presets, lengths from `min_edge` to twice the size; aspect ratio
/// and share of triangles those of nvh from its size on.
QualityCriteria criteria_of_sizes(double size, double min_edge);

/// Value of one element; none where the measure does not apply to it. Neither chordal deviation nor the share
/// of triangles is a value of an element alone.
std::optional<double> measured(const std::vector<Vec3>& nodes, const MeshElement& element,
                               QualityMeasure measure);

/// Does the element fail any criterion that is on and that is a value of an element alone?
bool fails_any(const std::vector<Vec3>& nodes, const MeshElement& element, const QualityCriteria& criteria);

/// Chordal deviation of each element: by how much a smooth surface through its nodes would bow over its sides
/// and diagonals. The normal at a node is the mean of those of the elements around it that turn by less than
/// 40 degrees from the element's own, so that sharp edges do not count; a bow over the chord c between
/// normals m and n has the sagitta |(n - m) . c| / 8.
std::vector<double> chordal_deviations(const std::vector<Vec3>& nodes,
                                       const std::vector<MeshElement>& elements);

/// What one measure finds in a group of elements.
struct MeasureFindings {
  int failed = 0, warned = 0;
  std::optional<double> extreme;     ///< the value nearest to worst; none where nothing could be measured
  Index extreme_element = no_index;  ///< position in the list of elements
};

struct CriteriaFindings {
  std::array<MeasureFindings, measure_count> of;
  int elements = 0;
  int failing = 0;  ///< elements that fail any criterion that is on

  const MeasureFindings& operator[](QualityMeasure measure) const { return of[static_cast<size_t>(measure)]; }
  bool holds() const;  ///< nothing fails, the share of triangles neither
};

/// A part or a bead: positions in the list of elements.
struct ElementGroup {
  std::string name;
  std::vector<Index> elements;
};

struct GroupFindings {
  std::string name;
  CriteriaFindings findings;
};

/// A judged mesh: the limits and what they find. Empty `parts`: not judged.
struct JudgedMesh {
  QualityCriteria criteria;
  std::vector<GroupFindings> parts;  ///< "all" first, then each property
  std::vector<GroupFindings> beads;
};

/// Judges the whole mesh and each of the groups. Measures that are off are measured and not judged.
JudgedMesh judge(const std::vector<Vec3>& nodes, const std::vector<MeshElement>& elements,
                 const QualityCriteria& criteria, const std::vector<ElementGroup>& parts = {},
                 const std::vector<ElementGroup>& beads = {});

}  // namespace beadmesh
