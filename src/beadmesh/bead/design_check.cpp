#include "beadmesh/bead/design_check.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace beadmesh {
namespace {

constexpr int samples = 160;                // of a section
constexpr int reach = 2;                    // samples on both sides for a curvature
constexpr int most_sections = 40;           // of a medial edge
constexpr double across = radians(165);     // touching lines that are more oblique are left out
constexpr double sharp_root = radians(12);  // a steeper beginning has no root fillet
constexpr double straight = 1e-4;           // 1/mm: less curvature is none

/// The profile of a section: slope angle and arc length at each sample.
struct Section {
  double width = 0, depth = 0;
  std::vector<double> slope, length;
};

/// The side on which the section lies, square to the line between its roots. The normals there tell it, for a
/// line of the unrolled face may run a little along the bead in space; between upright walls they do not.
Vec3 upward(const std::vector<Vec3>& points, const std::vector<Vec3>& normals, Vec3 along) {
  Vec3 highest;
  for (const Vec3 p : points) {
    const Vec3 from_line = (p - points.front()) - along * dot(p - points.front(), along);
    if (norm(from_line) > norm(highest)) highest = from_line;
  }
  Vec3 up = normals.front() + normals.back();
  up = up - along * dot(up, along);
  if (norm(up) < 0.1) return normalized(highest);
  return normalized(dot(up, highest) < 0 ? -up : up);
}

/// Along the touching line of a medial point. None where the line lies on the sheet.
std::optional<Section> section_at(const MedialPoint& medial, const SurfaceMap& map) {
  std::vector<Vec3> points, normals;
  FacetPoint at;
  for (int i = 0; i <= samples; ++i) {
    at = map.locate(lerp(medial.feet[0].point, medial.feet[1].point, double(i) / samples), at.triangle);
    points.push_back(map.surface_point(at));
    normals.push_back(map.normal(at));
  }
  Section section;
  section.width = distance(points.front(), points.back());
  if (section.width <= 0) return {};
  const Vec3 along = (points.back() - points.front()) / section.width;
  const Vec3 up = upward(points, normals, along);
  for (const Vec3 p : points) section.depth = std::max(section.depth, dot(p - points.front(), up));
  if (section.depth < 1e-3 * section.width) return {};
  const double side = dot(normals.front() + normals.back(), up) < 0 ? -1 : 1;
  for (int i = 0; i <= samples; ++i) {
    section.slope.push_back(std::atan2(-side * dot(normals[i], along), side * dot(normals[i], up)));
    section.length.push_back(i ? section.length.back() + distance(points[i], points[i - 1]) : 0.0);
  }
  return section;
}

void keep_least(std::optional<double>& least, double value) {
  if (!least || value < *least) least = value;
}

void add_section(const Section& section, SectionMeasures& out) {
  ++out.sections;
  out.depth = std::max(out.depth, section.depth);
  out.depth_to_width = std::max(out.depth_to_width, section.depth / section.width);
  for (const double slope : section.slope) out.wall_angle = std::max(out.wall_angle, std::abs(slope));
  if (std::max(std::abs(section.slope.front()), std::abs(section.slope.back())) > sharp_root)
    out.root_radius = 0;
  for (int i = reach; i + reach <= samples; ++i) {
    const double run = section.length[i + reach] - section.length[i - reach];
    const double turn = section.slope[i + reach] - section.slope[i - reach];
    if (run <= 0 || std::abs(turn) < straight * run) continue;
    keep_least(turn < 0 ? out.crown_radius : out.root_radius, run / std::abs(turn));
  }
}

/// Junctions and ends have no sections of their own.
bool near_an_end(const MedialObject& medial, const MedialEdge& edge, const MedialPoint& point) {
  for (const Index v : {edge.start, edge.end}) {
    if (v == no_index) continue;
    const MedialVertex& vertex = medial.vertices[v];
    const double kept_off = vertex.type == MedialVertexType::J ? 1.0 : 0.1;
    if (distance(point.point, vertex.point) < kept_off * vertex.radius) return true;
  }
  return false;
}

// ---------------------------------------------------------------- distances

struct Box {
  Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};

  void add(Vec3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  double diagonal() const { return distance(low, high); }
  double gap(const Box& other) const {
    const auto apart = [](double l1, double h1, double l2, double h2) {
      return std::max({0.0, l1 - h2, l2 - h1});
    };
    return norm(Vec3{apart(low.x, high.x, other.low.x, other.high.x),
                     apart(low.y, high.y, other.low.y, other.high.y),
                     apart(low.z, high.z, other.low.z, other.high.z)});
  }
};

struct Line {
  std::vector<Vec3> points;
  Box box;
};

Line line_of(const Panel& panel, const PanelEdge& edge) {
  Line line;
  for (const Index p : edge.points) {
    line.points.push_back(panel.points[p]);
    line.box.add(line.points.back());
  }
  return line;
}

double to_segment(Vec3 p, Vec3 a, Vec3 b) {
  const double squared = squared_norm(b - a);
  const double t = squared > 0 ? std::clamp(dot(p - a, b - a) / squared, 0.0, 1.0) : 0.0;
  return distance(p, lerp(a, b, t));
}

/// Both ways, point to segment: facets' points are close together, so crossings in between do not matter.
double gap_between(const Line& a, const Line& b, double at_most) {
  if (a.box.gap(b.box) >= at_most) return at_most;
  double least = at_most;
  for (const auto& [from, to] : {std::pair{&a, &b}, std::pair{&b, &a}})
    for (const Vec3 p : from->points)
      for (size_t i = 1; i < to->points.size(); ++i)
        least = std::min(least, to_segment(p, to->points[i - 1], to->points[i]));
  return least;
}

using Lines = std::vector<Line>;

std::optional<double> gap_between(const Lines& a, const Lines& b) {
  if (a.empty() || b.empty()) return {};
  double least = 1e300;
  for (const Line& one : a)
    for (const Line& other : b) least = gap_between(one, other, least);
  return least;
}

/// Groups of a disjoint-set forest.
class Groups {
 public:
  explicit Groups(size_t count) : parent_(count) {
    for (size_t i = 0; i < count; ++i) parent_[i] = Index(i);
  }
  Index of(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(Index a, Index b) { parent_[std::max(of(a), of(b))] = std::min(of(a), of(b)); }

 private:
  std::vector<Index> parent_;
};

struct FreeEdges {
  Lines rims, holes;
};

FreeEdges free_edges_of(const Panel& panel) {
  Groups pieces(panel.faces.size()), chains(panel.points.size());
  std::vector<Index> free;
  for (Index e = 0; e < Index(panel.edges.size()); ++e) {
    const PanelEdge& edge = panel.edges[e];
    for (const Index face : edge.faces) pieces.join(face, edge.faces.front());
    if (edge.faces.size() != 1) continue;
    free.push_back(e);
    for (const Index p : edge.points) chains.join(p, edge.points.front());
  }
  std::vector<Box> boxes(panel.points.size());  // of a chain, at its group
  for (const Index e : free)
    for (const Index p : panel.edges[e].points) boxes[chains.of(p)].add(panel.points[p]);
  std::vector<Index> rim_of(panel.faces.size(), no_index);  // a piece's chain, at its group
  for (const Index e : free) {
    const Index chain = chains.of(panel.edges[e].points.front());
    Index& rim = rim_of[pieces.of(panel.edges[e].faces.front())];
    if (rim == no_index || boxes[chain].diagonal() > boxes[rim].diagonal()) rim = chain;
  }
  FreeEdges out;
  for (const Index e : free) {
    const bool is_rim =
        rim_of[pieces.of(panel.edges[e].faces.front())] == chains.of(panel.edges[e].points.front());
    (is_rim ? out.rims : out.holes).push_back(line_of(panel, panel.edges[e]));
  }
  return out;
}

Lines boundary_of(const Panel& panel, const Bead& bead) {
  Lines lines;
  for (const Index face : bead.faces)
    for (const auto& loop : panel.faces[face].loops)
      for (const EdgeUse& use : loop) lines.push_back(line_of(panel, panel.edges[use.edge]));
  return lines;
}

// ---------------------------------------------------------------- limits

struct Measure {
  const char* name;
  const char* words;
  std::optional<double> value, limit;
  bool is_most;  ///< the limit is an upper one
  const char* unit;
  double factor;  ///< into that unit
};

std::vector<Measure> measures_of(const BeadDesign& bead, const DesignLimits& limits) {
  const SectionMeasures& s = bead.sections;
  const auto where_measured = [&](double value) { return s.sections ? std::optional(value) : std::nullopt; };
  return {
      {"depth_to_width", "depth to width", where_measured(s.depth_to_width), limits.max_depth_to_width, true,
       "", 1},
      {"wall_angle", "wall angle", where_measured(s.wall_angle), limits.max_wall_angle, true, " degrees",
       degrees(1)},
      {"crown_radius", "crown radius", s.crown_radius, limits.min_crown_radius, false, " mm", 1},
      {"root_radius", "root radius", s.root_radius, limits.min_root_radius, false, " mm", 1},
      {"bead_distance", "distance to the next bead", bead.distances.bead, limits.min_bead_distance, false,
       " mm", 1},
      {"rim_distance", "distance to the rim", bead.distances.rim, limits.min_rim_distance, false, " mm", 1},
      {"hole_distance", "distance to a hole", bead.distances.hole, limits.min_hole_distance, false, " mm",
       1}};
}

/// Rounded to 0.01, without zeros at the end.
std::string digits(double value) {
  std::string text = std::to_string(std::round(100 * value) / 100);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

/// Relative: what is drawn at the limit is not past it for a rounding error.
constexpr double allowance = 1e-3;

bool is_exceeded(const Measure& m) {
  if (!m.value || !m.limit) return false;
  return m.is_most ? *m.value > *m.limit * (1 + allowance) : *m.value < *m.limit * (1 - allowance);
}

}  // namespace

SectionMeasures measure_sections(const FaceStudy& study, const MedialObject& medial) {
  SectionMeasures out;
  for (const MedialEdge& edge : medial.edges) {
    std::vector<const MedialPoint*> places;
    for (const MedialPoint& point : edge.points)
      if (point.radius > 0 && point.subtended_angle >= across && !near_an_end(medial, edge, point))
        places.push_back(&point);
    const size_t step = places.size() / most_sections + 1;
    for (size_t i = 0; i < places.size(); i += step)
      if (const auto section = section_at(*places[i], *study.map)) add_section(*section, out);
  }
  return out;
}

std::vector<BeadDistances> bead_distances(const Panel& panel, const BeadTable& table) {
  const FreeEdges free = free_edges_of(panel);
  std::vector<Lines> boundaries;
  for (const Bead& bead : table.beads) boundaries.push_back(boundary_of(panel, bead));
  std::vector<BeadDistances> out;
  for (size_t i = 0; i < boundaries.size(); ++i) {
    if (!table.beads[i].listed) continue;
    BeadDistances& own = out.emplace_back();
    own.rim = gap_between(boundaries[i], free.rims);
    own.hole = gap_between(boundaries[i], free.holes);
    for (size_t k = 0; k < boundaries.size(); ++k) {
      if (k == i || !table.beads[k].listed) continue;
      const auto gap = gap_between(boundaries[i], boundaries[k]);
      if (gap && (!own.bead || *gap < *own.bead)) own.bead = gap, own.nearest_bead = table.beads[k].id;
    }
  }
  return out;
}

std::vector<Diagnostic> judge_design(std::vector<BeadDesign>& beads, const DesignLimits& limits) {
  std::vector<Diagnostic> found;
  for (BeadDesign& bead : beads) {
    bead.exceeded.clear();
    for (const Measure& m : measures_of(bead, limits)) {
      if (!is_exceeded(m)) continue;
      bead.exceeded.push_back(m.name);
      found.push_back({std::string("design.") + m.name, Severity::warning, no_index,
                       "bead " + std::to_string(bead.id),
                       std::string(m.words) + " " + digits(*m.value * m.factor) + m.unit + ", the limit is " +
                           digits(*m.limit * m.factor) + m.unit,
                       ""});
    }
  }
  return found;
}

}  // namespace beadmesh
