#include "beadmesh/write/abaqus.h"

#include <ostream>

#include "beadmesh/write/deck_text.h"

namespace beadmesh {
namespace {

void write_nodes(Page& page, const std::vector<Vec3>& nodes, Index id) {
  page.line("*NODE");
  for (const Vec3& p : nodes)
    page.line("{}, {}, {}, {}", id++, Coordinate(p.x).text(), Coordinate(p.y).text(), Coordinate(p.z).text());
}

/// Those of one part and one type.
void write_block(Page& page, const ShellMesh& mesh, const DeckOptions& options, Index part, bool quads) {
  const Index first = options.first_node;
  bool any = false;
  for (size_t e = 0; e < mesh.elements.size(); ++e) {
    const MeshElement& n = mesh.elements[e].nodes;
    if (mesh.elements[e].part != part || is_quad(n) != quads) continue;
    if (!any) page.line("*ELEMENT, TYPE={}, ELSET={}", quads ? "S4" : "S3", plain(mesh.parts[part].name, 70));
    any = true;
    page.text("{}, {}, {}, {}", Index(e) + options.first_element, n[0] + first, n[1] + first, n[2] + first);
    if (quads) page.text(", {}", n[3] + first);
    page.end_line();
  }
}

bool is_used(const ShellMesh& mesh, Index part) {
  for (const ShellElement& element : mesh.elements)
    if (element.part == part) return true;
  return false;
}

void write_sets(Page& page, const ShellMesh& mesh, const DeckOptions& options) {
  for (const NamedSet& set : sets_of(mesh, options)) {
    page.line("** {}", set.text);
    page.line("*{0}, {0}={1}", set.is_of_nodes ? "NSET" : "ELSET", set.name);
    page.rows_of_ids(*set.items, set.is_of_nodes ? options.first_node : options.first_element, 16, 0, ", ");
  }
}

void write_sections(Page& page, const ShellMesh& mesh) {
  page.line("** steel, a placeholder: N, mm, tonne, s");
  page.line("*MATERIAL, NAME=steel");
  page.line("*ELASTIC");
  page.line("{}, {}", short_real(steel_modulus), short_real(steel_poisson));
  page.line("*DENSITY");
  page.line("{}", short_real(steel_density));
  for (size_t part = 0; part < mesh.parts.size(); ++part) {
    if (!is_used(mesh, Index(part))) continue;
    page.line("*SHELL SECTION, ELSET={}, MATERIAL=steel", plain(mesh.parts[part].name, 70));
    page.line("{}", short_real(mesh.parts[part].thickness));
  }
}

void write_step(Page& page) {
  page.line("** the first {} modes, six of them rigid", mode_count);
  page.line("*STEP");
  page.line("*FREQUENCY");
  page.line("{}", mode_count);
  page.line("*NODE FILE");
  page.line("U");
  page.line("*END STEP");
}

}  // namespace

void write_abaqus(const ShellMesh& mesh, std::ostream& out, const DeckOptions& options) {
  Page page(out);
  const bool runs = options.analysis == DeckAnalysis::modes;
  write_head(page, mesh, options, "** ");
  if (runs) {
    page.line("*HEADING");
    page.line("{}", plain(mesh.title.empty() ? "beadmesh" : mesh.title, 80));
  }
  write_nodes(page, mesh.nodes, options.first_node);
  for (Index part = 0; part < Index(mesh.parts.size()); ++part)
    for (const bool quads : {true, false}) write_block(page, mesh, options, part, quads);
  write_sets(page, mesh, options);
  write_sections(page, mesh);
  if (runs) write_step(page);
}

}  // namespace beadmesh
