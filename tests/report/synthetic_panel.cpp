#include "report/synthetic_panel.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "beadmesh/mesh/element_quality.h"

namespace beadmesh::test {
namespace {

constexpr double length = 300, width = 200, half_width = 9, bead_height = 6;

struct Segment {
  Vec2 from, to;
};

double distance_to(const Segment& s, Vec2 p) {
  const Vec2 d = s.to - s.from;
  const double t = std::clamp(dot(p - s.from, d) / dot(d, d), 0.0, 1.0);
  return norm(p - (s.from + d * t));
}

constexpr Segment i_axis{{40, 150}, {130, 165}};
constexpr Segment t_bar{{180, 150}, {270, 150}}, t_stem{{225, 150}, {225, 80}};
constexpr Vec2 ring_centre{85, 70};
constexpr double ring_radius = 38;

/// Distance from the axis of each bead.
std::array<double, 3> distances(Vec2 p) {
  return {distance_to(i_axis, p), std::min(distance_to(t_bar, p), distance_to(t_stem, p)),
          std::abs(norm(p - ring_centre) - ring_radius)};
}

/// 0: sheet, else the bead.
Index bead_at(Vec2 p) {
  const auto d = distances(p);
  for (Index b = 0; b < 3; ++b)
    if (d[b] < half_width) return b + 1;
  return 0;
}

Vec3 on_surface(Vec2 p) {
  double rise = 0;
  for (const double d : distances(p)) {
    const double t = std::min(1.0, d / half_width);
    rise = std::max(rise, bead_height * (1 - t * t) * (1 - t * t));
  }
  return {p.x, p.y, rise + 12 * std::sin(p.x / 120)};
}

class Builder {
 public:
  explicit Builder(int along) : columns_(along), rows_(along * 2 / 3) {}

  SyntheticPanel build() {
    make_mesh();
    make_faces();
    make_beads();
    out_.panel.input = "synthetic.step";
    out_.mesh.table.faces_not_beads = {{1, "it has 4 loops, a bead has at most 2"}};
    out_.mesh.table.diagnostics = {
        {"mesh.bead.control", Severity::warning, 3, "bead 2", "elements across 9 not possible", "use 8"},
        {"read.sewn", Severity::note, no_index, "", "3 edges sewn <within 0.01 mm>", ""}};
    return std::move(out_);
  }

 private:
  void make_mesh() {
    ShellMesh& mesh = out_.mesh.mesh;
    mesh.title = "synthetic";
    mesh.parts = {{1, "sheet", 1}, {2, "bead_I", 1}, {3, "bead_generic", 1}, {4, "bead_annular", 1}};
    for (int j = 0; j <= rows_; ++j)
      for (int i = 0; i <= columns_; ++i) mesh.nodes.push_back(on_surface(plan_point(i, j)));
    std::array<std::vector<ShellElement>, 4> by_bead;
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i) add_cell(i, j, by_bead);
    for (const auto& elements : by_bead)
      mesh.elements.insert(mesh.elements.end(), elements.begin(), elements.end());
    std::vector<MeshElement> plain;
    for (const ShellElement& element : mesh.elements) plain.push_back(element.nodes);
    out_.mesh.quality = summarise(mesh.nodes, plain, 2.5);
  }

  /// Not quite even, as meshes are: packing must not profit from rows of equal numbers.
  Vec2 plan_point(int i, int j) const {
    const double cell = length / columns_, turn = 12.9898 * i + 78.233 * j;
    const bool inside = i > 0 && j > 0 && i < columns_ && j < rows_;
    const Vec2 aside = inside ? Vec2{std::sin(turn), std::cos(1.7 * turn)} * (0.07 * cell) : Vec2{};
    return Vec2{length * i / columns_, width * j / rows_} + aside;
  }

  /// One quad; a hundredth of the cells is two triangles.
  void add_cell(int i, int j, std::array<std::vector<ShellElement>, 4>& by_bead) {
    const Index a = j * (columns_ + 1) + i, b = a + columns_ + 1;
    const Index bead = bead_at({length * (i + 0.5) / columns_, width * (j + 0.5) / rows_});
    const auto add = [&](MeshElement nodes) { by_bead[bead].push_back({nodes, bead, bead + 1, bead}); };
    if ((i + 7 * j) % 100 == 50) {
      add({a, a + 1, b + 1, no_index});
      add({a, b + 1, b, no_index});
    } else {
      add({a, a + 1, b + 1, b});
    }
  }

  /// Facets of each face are its elements, cut in two.
  void make_faces() {
    out_.panel.faces.resize(4);
    for (Index f = 0; f < 4; ++f) {
      PanelFace& face = out_.panel.faces[f];
      face.number = f + 1;
      std::vector<Triangle> triangles;
      for (const ShellElement& element : out_.mesh.mesh.elements) {
        if (element.bead != f) continue;
        const MeshElement& n = element.nodes;
        triangles.push_back({n[0], n[1], n[2]});
        if (is_quad(n)) triangles.push_back({n[0], n[2], n[3]});
      }
      face.facets = facets_of_triangles(out_.mesh.mesh.nodes, triangles);
    }
  }

  void make_beads() {
    add_bead(BeadKind::I, "I", {line(i_axis)}, false);
    add_bead(BeadKind::generic, "T", {line(t_bar), line(t_stem)}, false);
    std::vector<Vec2> circle;
    for (int i = 0; i < 90; ++i)
      circle.push_back(ring_centre + Vec2{std::cos(i * pi / 45), std::sin(i * pi / 45)} * ring_radius);
    add_bead(BeadKind::annular, "ring", {circle}, true);
  }

  static std::vector<Vec2> line(const Segment& s) {
    std::vector<Vec2> points;
    for (int i = 0; i <= 30; ++i) points.push_back(s.from + (s.to - s.from) * (i / 30.0));
    return points;
  }

  void add_bead(BeadKind kind, const char* shape, const std::vector<std::vector<Vec2>>& axes, bool closed) {
    const Index b = static_cast<Index>(out_.mesh.table.beads.size());
    Bead bead;
    bead.id = b + 1, bead.kind = kind, bead.shape = shape, bead.faces = {b + 1};
    bead.loops = closed ? 2 : 1, bead.ends = closed ? 0 : static_cast<int>(axes.size()) + 1;
    bead.junctions = axes.size() > 1, bead.medial_edges = static_cast<int>(axes.size());
    bead.width = 2 * half_width, bead.height = bead_height;
    FaceMedial medial;
    medial.face = b + 2;
    BeadMeshing meshing{"blocks", 0, {}, 4, 5, 2.5, 4, {}};
    for (const auto& axis : axes) {
      RidgeCurve crest{axis, {}, closed};
      for (const Vec2 p : axis) crest.points.push_back(on_surface(p));
      for (size_t i = 1; i < axis.size(); ++i) bead.length += distance(crest.points[i - 1], crest.points[i]);
      add_axis(medial, crest, closed);
      add_splits(meshing, axis);
      bead.ridge.push_back(std::move(crest));
    }
    bead.aspect_ratio = bead.length / bead.width;
    bead.point = bead.ridge[0].points[bead.ridge[0].points.size() / 2];
    for (const ShellElement& element : out_.mesh.mesh.elements) meshing.elements += element.bead == bead.id;
    out_.mesh.table.beads.push_back(std::move(bead));
    out_.mesh.table.medials.push_back(std::move(medial));
    out_.mesh.meshing.push_back(std::move(meshing));
  }

  static void add_axis(FaceMedial& medial, const RidgeCurve& crest, bool closed) {
    MedialEdge edge;
    edge.type = closed ? MedialEdgeType::N : MedialEdgeType::SS;
    for (size_t i = 0; i < crest.flat.size(); ++i)
      edge.points.push_back({crest.flat[i], half_width * (0.6 + 0.4 * std::sin(i / 8.0)), {}, pi});
    medial.object.edges.push_back(std::move(edge));
    medial.edge_points.push_back(crest.points);
  }

  /// Across the axis, at a quarter and at three quarters.
  static void add_splits(BeadMeshing& meshing, const std::vector<Vec2>& axis) {
    for (const size_t at : {axis.size() / 4, axis.size() * 3 / 4}) {
      const Vec2 along = normalized(axis[at + 1] - axis[at]), across{-along.y, along.x};
      BlockSideLine split{VirtualEdgeKind::split, {}};
      for (int i = -4; i <= 4; ++i)
        split.points.push_back(on_surface(axis[at] + across * (half_width * i / 4.0)));
      meshing.block_lines.push_back(std::move(split));
    }
    BlockSideLine boundary{VirtualEdgeKind::boundary, {}};
    for (size_t i = 0; i + 1 < axis.size(); ++i) {
      const Vec2 along = normalized(axis[i + 1] - axis[i]);
      boundary.points.push_back(on_surface(axis[i] + Vec2{-along.y, along.x} * half_width));
    }
    meshing.block_lines.push_back(std::move(boundary));
  }

  int columns_, rows_;
  SyntheticPanel out_;
};

}  // namespace

SyntheticPanel synthetic_panel(int along) {
  return Builder(along).build();
}

}  // namespace beadmesh::test
