#include "beadmesh/write/nastran.h"

#include <ostream>
#include <string>
#include <vector>

#include "beadmesh/write/deck_text.h"

namespace beadmesh {
namespace {

constexpr size_t line_width = 72;

/// Runs of three and more consecutive ids as "a THRU b"; `items` are ascending indices.
std::vector<std::string> ranges(const std::vector<Index>& items, Index first) {
  std::vector<std::string> result;
  for (size_t i = 0; i < items.size();) {
    size_t end = i + 1;
    while (end < items.size() && items[end] == items[end - 1] + 1) ++end;
    if (end - i >= 3) {
      result.push_back(fmt::format("{} THRU {}", items[i] + first, items[end - 1] + first));
      i = end;
    } else {
      result.push_back(fmt::format("{}", items[i] + first));
      ++i;
    }
  }
  return result;
}

/// Of the case control. A continued line ends in a comma; a THRU is never broken.
void write_case_set(Page& page, const NamedSet& set, Index first) {
  const std::vector<std::string> parts = ranges(*set.items, first);
  std::string line = fmt::format("SET {} = ", set.id);
  for (size_t i = 0; i < parts.size(); ++i) {
    const std::string text = parts[i] + (i + 1 < parts.size() ? "," : "");
    if (line.size() + text.size() > line_width) {
      page.line("{}", line);
      line = "  ";
    }
    line += text;
  }
  page.line("{}", line);
}

/// Of the bulk data: seven ids on the first line, eight on the others.
void write_bulk_set(Page& page, const NamedSet& set, Index first) {
  page.text("SET1    {:8}", set.id);
  for (size_t i = 0; i < set.items->size(); ++i) {
    if (i > 0 && i % 8 == 7) {
      page.end_line();
      page.text("        ");
    }
    page.text("{:8}", (*set.items)[i] + first);
  }
  page.end_line();
}

void write_sets(Page& page, const ShellMesh& mesh, const DeckOptions& options) {
  for (const NamedSet& set : sets_of(mesh, options)) {
    page.line("$ set {}: {}", set.id, set.text);
    const Index first = set.is_of_nodes ? options.first_node : options.first_element;
    (options.analysis == DeckAnalysis::none ? write_bulk_set : write_case_set)(page, set, first);
  }
}

void write_control(Page& page, const ShellMesh& mesh, const DeckOptions& options) {
  page.line("SOL 103");
  page.line("CEND");
  page.line("TITLE = {}", plain(mesh.title.empty() ? "beadmesh" : mesh.title, line_width - 8));
  page.line("ECHO = NONE");
  page.line("METHOD = 1");
  page.line("DISPLACEMENT(PLOT) = ALL");
  write_sets(page, mesh, options);
  page.line("BEGIN BULK");
  page.line("PARAM,POST,-1");
  page.line("$ the first {} modes, six of them rigid", mode_count);
  page.line("EIGRL   {:>8}{:>8}{:>8}{:>8}", 1, "", "", mode_count);
}

void write_properties(Page& page, const ShellMesh& mesh, const DeckOptions& options) {
  const Index material = options.first_property;
  page.line("$ steel, a placeholder: E in N/mm2, density in tonne/mm3");
  page.line("MAT1    {:>8}{:>8}{:>8}{:>8}{:>8}", material, "210000.", "", "0.3", "7.85-9");
  for (const ShellPart& part : mesh.parts) {
    const Index id = property_id(part, options);
    page.line("$ property {}: {}", id, plain(part.name, 40));
    page.line("PSHELL  {:>8}{:>8}{:>8}{:>8}{:>8}{:>8}", id, material, short_real(part.thickness), material,
              "", material);
  }
}

void write_nodes(Page& page, const std::vector<Vec3>& nodes, Index id) {
  for (const Vec3& p : nodes) {
    page.line("GRID*   {:>16}{:16}{:>16}{:>16}*", id++, "", Coordinate(p.x).text(), Coordinate(p.y).text());
    page.line("*       {:>16}", Coordinate(p.z).text());
  }
}

void write_elements(Page& page, const ShellMesh& mesh, const DeckOptions& options) {
  Index id = options.first_element;
  const Index first = options.first_node;
  for (const ShellElement& element : mesh.elements) {
    const Index part = property_id(mesh.parts[element.part], options);
    const MeshElement& n = element.nodes;
    if (is_quad(n))
      page.line("CQUAD4  {:8}{:8}{:8}{:8}{:8}{:8}", id, part, n[0] + first, n[1] + first, n[2] + first,
                n[3] + first);
    else
      page.line("CTRIA3  {:8}{:8}{:8}{:8}{:8}", id, part, n[0] + first, n[1] + first, n[2] + first);
    ++id;
  }
}

}  // namespace

void write_nastran(const ShellMesh& mesh, std::ostream& out, const DeckOptions& options) {
  Page page(out);
  const bool runs = options.analysis == DeckAnalysis::modes;
  write_head(page, mesh, options, "$ ");
  if (runs)
    write_control(page, mesh, options);
  else
    write_sets(page, mesh, options);
  write_properties(page, mesh, options);
  write_nodes(page, mesh.nodes, options.first_node);
  write_elements(page, mesh, options);
  if (runs) page.line("ENDDATA");
}

}  // namespace beadmesh
