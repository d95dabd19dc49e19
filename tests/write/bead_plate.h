// A plate of quads with one straight bead, made by hand: input for the tests of writers and reports.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "beadmesh/mesh/panel_mesh.h"
#include "beadmesh/panel/panel.h"

namespace beadmesh::test {

inline constexpr Index plate_columns = 20, plate_rows = 10;

/// Two faces: 1 the sheet, 2 the bead, a strip of columns 4 to 15 and rows 3 to 6; 5 mm squares, 4 mm high.
/// A square and a triangle on its right, in two parts.
inline ShellMesh two_elements() {
  ShellMesh mesh;
  mesh.title = "two elements -- no bead";
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0.5, 0.25}};
  mesh.parts = {{7, "sheet", 1.25}, {9, "flange", 0.8}};
  mesh.elements = {{{0, 1, 2, 3}, 0, 1, 0}, {{1, 4, 2, no_index}, 1, 2, 0}};
  return mesh;
}

inline Panel plate_panel() {
  Panel panel;
  panel.input = "plate.step";
  panel.faces.resize(2);
  panel.faces[0].number = 1;
  panel.faces[1].number = 2;
  return panel;
}

inline bool in_bead(Index column, Index row) {
  return column >= 4 && column < 16 && row >= 3 && row < 7;
}

inline ShellMesh plate_mesh(Index columns = plate_columns, Index rows = plate_rows) {
  ShellMesh mesh;
  mesh.title = "plate.step, size 5 mm, minimum edge 2.5 mm";
  mesh.parts = {{1, "sheet", 0.8}, {2, "bead_I", 0.8}};
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i <= columns; ++i) {
      const double across = std::abs(j - 5.0) / 2, along = std::max(std::abs(i - 10.0) - 5, 0.0);
      const double rise = 4 * std::max(0.0, 1 - across * across) * std::max(0.0, 1 - along);
      mesh.nodes.push_back({5.0 * i, 5.0 * j, rise});
    }
  BeadSet set{1, "I", "I", {}, {}};
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const Index a = j * (columns + 1) + i, b = a + columns + 1;
      const bool bead = in_bead(i, j);
      if (bead) set.elements.push_back(static_cast<Index>(mesh.elements.size()));
      mesh.elements.push_back({{a, a + 1, b + 1, b}, bead ? 1 : 0, bead ? 2 : 1, bead ? 1 : 0});
    }
  for (Index i = 5; i <= 15; ++i) set.crest_nodes.push_back(5 * (columns + 1) + i);
  set.crest_lines = {set.crest_nodes};
  set.boundary_nodes = boundary_nodes(mesh, set.elements);
  for (const Index e : set.elements)
    if (e % columns == 4 || e % columns == 15) set.cap_elements.push_back(e);
  mesh.beads = {set};
  return mesh;
}

inline BeadTable plate_table() {
  Bead bead;
  bead.id = 1;
  bead.shape = "I";
  bead.faces = {1};
  bead.point = {50, 25, 4};
  bead.length = 40, bead.width = 20, bead.height = 4, bead.aspect_ratio = 2;
  bead.ends = 2, bead.medial_edges = 1;
  bead.ridge = {{{{30, 25}, {70, 25}}, {{30, 25, 4}, {70, 25, 4}}, false}};
  BeadTable table;
  table.beads = {bead};
  table.faces_not_beads = {{1, "aspect ratio 1.1 < 2.0"}};
  return table;
}

inline PanelMesh plate() {
  PanelMesh panel;
  panel.table = plate_table();
  panel.meshing = {{"blocks", 48, {}, 4, 5, 2.5}};
  panel.mesh = plate_mesh();
  panel.quality.nodes = static_cast<int>(panel.mesh.nodes.size());
  panel.quality.quads = static_cast<int>(panel.mesh.elements.size());
  panel.quality.scaled_jacobian_min = 0.83;
  panel.quality.scaled_jacobian_mean = 0.97;
  panel.quality.edge_min = 5;
  panel.quality.edge_max = 5.8;
  return panel;
}

}  // namespace beadmesh::test
