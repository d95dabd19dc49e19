#include "beadmesh/write/ls_dyna.h"

#include <ostream>

#include "beadmesh/write/deck_text.h"

namespace beadmesh {
namespace {

void write_control(Page& page) {
  page.line("$ the first {} modes, six of them rigid", mode_count);
  page.line("*CONTROL_IMPLICIT_GENERAL");
  page.line("$   imflag       dt0");
  page.line("{:>10}{:>10}", 1, "1.0");
  page.line("*CONTROL_IMPLICIT_EIGENVALUE");
  page.line("$     neig");
  page.line("{:>10}", mode_count);
  page.line("*CONTROL_TERMINATION");
  page.line("$   endtim");
  page.line("{:>10}", "1.0");
}

void write_parts(Page& page, const ShellMesh& mesh, const DeckOptions& options) {
  const Index material = options.first_property;
  page.line("*MAT_ELASTIC_TITLE");
  page.line("steel, a placeholder: N, mm, tonne, s");
  page.line("$      mid        ro         e        pr");
  page.line("{:>10}{:>10}{:>10}{:>10}", material, short_real(steel_density, 10),
            short_real(steel_modulus, 10), short_real(steel_poisson, 10));
  for (const ShellPart& part : mesh.parts) {
    const Index id = property_id(part, options);
    const std::string name = plain(part.name, 70), thickness = short_real(part.thickness, 10);
    page.line("*SECTION_SHELL_TITLE");
    page.line("{}", name);
    page.line("$    secid    elform      shrf       nip");
    page.line("{:>10}{:>10}{:>10}{:>10}", id, 16, "0.8333333", 5);
    page.line("$       t1        t2        t3        t4");
    page.line("{:>10}{:>10}{:>10}{:>10}", thickness, thickness, thickness, thickness);
    page.line("*PART");
    page.line("{}", name);
    page.line("$      pid     secid       mid");
    page.line("{:>10}{:>10}{:>10}", id, id, material);
  }
}

void write_nodes(Page& page, const std::vector<Vec3>& nodes, Index id) {
  page.line("*NODE");
  page.line("$    nid               x               y               z");
  for (const Vec3& p : nodes)
    page.line("{:>8}{:>16}{:>16}{:>16}", id++, Coordinate(p.x).text(), Coordinate(p.y).text(),
              Coordinate(p.z).text());
}

void write_elements(Page& page, const ShellMesh& mesh, const DeckOptions& options) {
  page.line("*ELEMENT_SHELL");
  page.line("$    eid     pid      n1      n2      n3      n4");
  Index id = options.first_element;
  const Index first = options.first_node;
  for (const ShellElement& element : mesh.elements) {
    const MeshElement& n = element.nodes;
    page.line("{:8}{:8}{:8}{:8}{:8}{:8}", id++, property_id(mesh.parts[element.part], options), n[0] + first,
              n[1] + first, n[2] + first, n[is_quad(n) ? 3 : 2] + first);
  }
}

void write_sets(Page& page, const ShellMesh& mesh, const DeckOptions& options) {
  for (const NamedSet& set : sets_of(mesh, options)) {
    page.line("{}", set.is_of_nodes ? "*SET_NODE_LIST_TITLE" : "*SET_SHELL_LIST_TITLE");
    page.line("{}", set.text);
    page.line("$      sid");
    page.line("{:>10}", set.id);
    page.rows_of_ids(*set.items, set.is_of_nodes ? options.first_node : options.first_element, 8, 10, "");
  }
}

}  // namespace

void write_ls_dyna(const ShellMesh& mesh, std::ostream& out, const DeckOptions& options) {
  Page page(out);
  page.line("*KEYWORD");
  write_head(page, mesh, options, "$ ");
  if (options.analysis == DeckAnalysis::modes) {
    page.line("*TITLE");
    page.line("{}", plain(mesh.title.empty() ? "beadmesh" : mesh.title, 80));
    write_control(page);
  }
  write_parts(page, mesh, options);
  write_nodes(page, mesh.nodes, options.first_node);
  write_elements(page, mesh, options);
  write_sets(page, mesh, options);
  page.line("*END");
}

}  // namespace beadmesh
