#include "beadmesh/report/report_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "beadmesh/report/drawing.h"

namespace beadmesh::report_tables {
namespace {

using drawing::escaped;

struct Column {
  std::string_view name;
  bool number = false;
  const char* meaning = "";
};

std::string section(const char* id, const char* heading, size_t count, const std::string& body) {
  return fmt::format("<section id=\"{}\" data-count=\"{}\"><h2>{}</h2>\n{}</section>\n", id, count, heading,
                     body.empty() ? "<p class=\"none\">None.</p>\n" : body);
}

template <size_t n>
std::string table(const char* caption, const Column (&columns)[n], const std::string& rows) {
  std::string text =
      fmt::format("<div class=\"wide\"><table class=\"sortable\"><caption>{}</caption><thead><tr>", caption);
  for (const Column& column : columns)
    text += fmt::format("<th scope=\"col\"{}{}>{}</th>", column.number ? " class=\"number\"" : "",
                        *column.meaning ? fmt::format(" title=\"{}\"", column.meaning) : "", column.name);
  return text + "</tr></thead><tbody>\n" + rows + "</tbody></table></div>\n";
}

std::string number(const std::string& value) {
  return "<td class=\"number\">" + value + "</td>";
}

std::string figure(const std::string& value, const char* name, bool bad = false) {
  return fmt::format("<div class=\"figure{}\"><dt>{}</dt><dd>{}</dd></div>\n", bad ? " bad" : "", name,
                     value);
}

/// 12345 as 12,345.
std::string grouped(long value) {
  const std::string digits = std::to_string(value);
  std::string text;
  for (size_t i = 0; i < digits.size(); ++i) {
    const size_t left = digits.size() - i;
    if (i > 0 && left % 3 == 0 && digits[i - 1] != '-') text += ',';
    text += digits[i];
  }
  return text;
}

std::string joined(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += (text.empty() ? "" : "; ") + note;
  return text;
}

std::string faces_of(const Panel& panel, const Bead& bead) {
  std::string text;
  for (const Index face : input_numbers(panel, bead.faces))
    text += fmt::format("{}{}", text.empty() ? "" : ", ", face);
  return text;
}

std::string meshing_cells(const PanelMesh& mesh, size_t i) {
  if (i >= mesh.meshing.size()) return "";
  const BeadMeshing& meshing = mesh.meshing[i];
  return fmt::format("<td{}>{}</td>{}<td class=\"text\">{}</td>",
                     meshing.method == "fallback" ? " class=\"fallback\"" : "", escaped(meshing.method),
                     number(std::to_string(meshing.elements)), escaped(joined(meshing.notes)));
}

std::string bead_row(const Panel& panel, const PanelMesh& mesh, size_t i) {
  const Bead& b = mesh.table.beads[i];
  const std::string kind = name_of(b.kind);
  std::string text =
      fmt::format("<tr data-bead=\"{}\"><th scope=\"row\" class=\"number\">{}</th>", b.id, b.id);
  text += fmt::format("<td><i class=\"kind kind-{}\"></i>{}</td><td>{}</td><td class=\"text\">{}</td>", kind,
                      kind, escaped(b.shape), faces_of(panel, b));
  for (const auto& [value, digits] :
       {std::pair{b.length, 1}, {b.width, 2}, {b.height, 2}, {b.aspect_ratio, 1}})
    text += number(fmt::format("{:.{}f}", value, digits));
  text += number(std::to_string(b.junctions)) + number(std::to_string(b.ends));
  return text + meshing_cells(mesh, i) + "</tr>\n";
}

/// A figure of the design; `name` is what it is called where it is past its limit.
std::string design_cell(const BeadDesign& design, const char* name, const std::optional<double>& value,
                        int digits) {
  if (!value) return number("–");
  const bool past = std::count(design.exceeded.begin(), design.exceeded.end(), name) > 0;
  return fmt::format("<td class=\"number{}\">{}{:.{}f}</td>", past ? " fails" : "", past ? "✗ " : "", *value,
                     digits);
}

std::string design_row(const BeadDesign& design) {
  const SectionMeasures& s = design.sections;
  const BeadDistances& d = design.distances;
  const auto measured = [&](double value) { return s.sections ? std::optional(value) : std::nullopt; };
  return fmt::format("<tr data-bead=\"{}\"><th scope=\"row\" class=\"number\">{}</th>", design.id,
                     design.id) +
         design_cell(design, "depth", measured(s.depth), 2) +
         design_cell(design, "depth_to_width", measured(s.depth_to_width), 3) +
         design_cell(design, "wall_angle", measured(degrees(s.wall_angle)), 1) +
         design_cell(design, "crown_radius", s.crown_radius, 2) +
         design_cell(design, "root_radius", s.root_radius, 2) +
         design_cell(design, "bead_distance", d.bead, 2) +
         number(d.bead ? std::to_string(d.nearest_bead) : "–") +
         design_cell(design, "rim_distance", d.rim, 2) + design_cell(design, "hole_distance", d.hole, 2) +
         "</tr>\n";
}

/// "wall angle, ° (≤ 60)"; the bare name where there is no limit.
std::string with_limit(const char* name, const char* sign, const std::optional<double>& limit) {
  return limit ? fmt::format("{} ({} {:g})", name, sign, *limit) : name;
}

std::string limit_of(double value) {
  return fmt::format("{:.4g}", value);
}

std::string element_cell(Index element) {
  if (element == no_index) return "<td class=\"number\">–</td>";
  return fmt::format("<td class=\"number\">{}</td>", element + 1);
}

struct Verdict {
  const char *style, *text;
};

Verdict verdict_on(const Criterion& limits, const MeasureFindings& found) {
  if (!limits.on) return {"none", "not judged"};
  if (!found.extreme) return {"none", "no such element"};
  return found.failed > 0 ? Verdict{"fails", "✗ fails"} : Verdict{"passes", "✓ passes"};
}

std::string criterion_row(QualityMeasure measure, const Criterion& limits, const MeasureFindings& found) {
  std::string text = found.extreme_element == no_index
                         ? "<tr>"
                         : fmt::format("<tr data-element=\"{}\">", found.extreme_element);
  text += fmt::format("<th scope=\"row\">{}</th>", name_of(measure));
  text += number(fmt::format("{} {}", limits.large_is_bad() ? "≤" : "≥", limit_of(limits.fail)));
  text += number(found.extreme ? fmt::format("{:.3f}", *found.extreme) : "–");
  text += element_cell(found.extreme_element);
  text += number(limits.on ? grouped(found.warned) : "–") + number(limits.on ? grouped(found.failed) : "–");
  const Verdict verdict = verdict_on(limits, found);
  return text + fmt::format("<td class=\"{}\">{}</td></tr>\n", verdict.style, verdict.text);
}

std::vector<MeshElement> elements_of(const ShellMesh& mesh) {
  std::vector<MeshElement> elements;
  for (const ShellElement& element : mesh.elements) elements.push_back(element.nodes);
  return elements;
}

/// "bead 3" gives 3, anything else 0: diagnostics name beads so.
Index bead_named(std::string_view entity) {
  if (entity.substr(0, 5) != "bead ") return 0;
  Index id = 0;
  for (const char c : entity.substr(5)) {
    if (c < '0' || c > '9' || id > 100000000) return 0;
    id = id * 10 + (c - '0');
  }
  return id;
}

std::string diagnostic_row(const Diagnostic& d) {
  std::string about;
  if (const Index bead = bead_named(d.entity)) about += fmt::format(" data-bead=\"{}\"", bead);
  if (d.face != no_index) about += fmt::format(" data-face=\"{}\"", d.face);
  const std::string_view severity = name_of(d.severity);
  return fmt::format(
      "<tr{}><td class=\"{}\">{}</td><td>{}</td>{}<td>{}</td><td class=\"text\">{}</td><td "
      "class=\"text\">{}</td></tr>\n",
      about, severity, severity, escaped(d.code), number(d.face == no_index ? "" : std::to_string(d.face)),
      escaped(d.entity), escaped(d.message), escaped(d.hint));
}

}  // namespace

std::string overview(const PanelMesh& mesh) {
  const QualitySummary& q = mesh.quality;
  const int elements = q.quads + q.trias;
  if (elements == 0) return "";
  std::string text = "<dl class=\"figures\">\n";
  text += figure(grouped(static_cast<long>(mesh.table.beads.size())), "beads");
  text += figure(grouped(q.nodes), "nodes") + figure(grouped(q.quads), "quads") +
          figure(grouped(q.trias), "triangles");
  text += figure(fmt::format("{:.2f} %", 100.0 * q.quads / elements), "quads of all elements");
  text += figure(fmt::format("{:.3f}", q.scaled_jacobian_min), "scaled Jacobian, min",
                 q.scaled_jacobian_min <= 0);
  text += figure(fmt::format("{:.3f}", q.scaled_jacobian_mean), "scaled Jacobian, mean");
  text += figure(fmt::format("{:.2f}", q.edge_min), "shortest edge, mm", q.edges_below_min > 0);
  text += figure(fmt::format("{:.2f}", q.edge_max), "longest edge, mm");
  text += figure(grouped(q.edges_below_min), "edges below minimum", q.edges_below_min > 0);
  text += figure(grouped(q.inverted), "inverted", q.inverted > 0);
  text += figure(fmt::format("{:.1f}°", q.warpage_max), "largest warpage");
  text += figure(grouped(q.warped_over_15), "warped over 15°");
  text += figure(grouped(q.irregular), "irregular nodes");
  return "<section id=\"overview\"><h2>Overview</h2>\n" + text + "</dl></section>\n";
}

std::string beads(const Panel& panel, const PanelMesh& mesh) {
  static constexpr Column recognised[] = {
      {"id", true},
      {"kind", false, "I: one crest; generic: with junctions; annular: around a hole"},
      {"shape"},
      {"faces", false, "numbers in the order of the file"},
      {"length, mm", true, "of all crest lines"},
      {"width, mm", true, "mean over the crest lines"},
      {"height, mm", true, "of the crest over the boundary"},
      {"ratio", true, "mean of length to width of the arms"},
      {"junctions", true},
      {"ends", true}};
  static constexpr Column meshed[] = {recognised[0], recognised[1], recognised[2], recognised[3],
                                      recognised[4], recognised[5], recognised[6], recognised[7],
                                      recognised[8], recognised[9], {"meshed by"}, {"elements", true},
                                      {"notes"}};
  std::string rows;
  for (size_t i = 0; i < mesh.table.beads.size(); ++i) rows += bead_row(panel, mesh, i);
  if (!rows.empty())
    rows = mesh.meshing.empty() ? table("Beads that were recognised", recognised, rows)
                                : table("Beads and how they were meshed", meshed, rows);
  return section("beads", "Beads", mesh.table.beads.size(), rows);
}

std::string design(const ReportFacts& facts) {
  if (facts.designs.empty()) return "";
  const DesignLimits& l = facts.design_limits;
  const auto angle = l.max_wall_angle ? std::optional(degrees(*l.max_wall_angle)) : std::nullopt;
  const std::string heads[] = {with_limit("depth to width", "≤", l.max_depth_to_width),
                               with_limit("wall angle, °", "≤", angle),
                               with_limit("crown radius, mm", "≥", l.min_crown_radius),
                               with_limit("root radius, mm", "≥", l.min_root_radius),
                               with_limit("to the next bead, mm", "≥", l.min_bead_distance),
                               with_limit("to the rim, mm", "≥", l.min_rim_distance),
                               with_limit("to a hole, mm", "≥", l.min_hole_distance)};
  const Column columns[] = {{"id", true},
                            {"depth, mm", true, "greatest height over the line between the roots"},
                            {heads[0], true, "greatest, each by the width of its own section"},
                            {heads[1], true, "steepest, to the line between the roots"},
                            {heads[2], true, "smallest where the section is convex"},
                            {heads[3], true, "smallest where the section is concave; 0: a sharp root"},
                            {heads[4], true, "between the boundaries; 0: they share one"},
                            {"next bead", true},
                            {heads[5], true, "from the boundary to the outline of the panel"},
                            {heads[6], true, "from the boundary to the nearest other free edge"}};
  std::string rows;
  for (const BeadDesign& one : facts.designs) rows += design_row(one);
  return section("design", "Design", facts.designs.size(),
                 table("Design of the beads; ✗: past its limit", columns, rows));
}

std::string quality(const PanelMesh& mesh, const ReportFacts& facts) {
  if (mesh.mesh.elements.empty() || !facts.criteria) return "";
  static constexpr Column columns[] = {{"criterion"},
                                       {"limit", true},
                                       {"worst value", true},
                                       {"worst element", true, "number in the deck"},
                                       {"near the limit", true, "elements past the warning limit"},
                                       {"failed", true, "elements past the limit"},
                                       {"verdict"}};
  const CriteriaFindings found =
      judge(mesh.mesh.nodes, elements_of(mesh.mesh), *facts.criteria).parts.front().findings;
  std::string rows;
  int failed = 0;
  for (int m = 0; m < measure_count; ++m) {
    rows += criterion_row(static_cast<QualityMeasure>(m), facts.criteria->of[m], found.of[m]);
    failed += facts.criteria->of[m].on && found.of[m].failed > 0;
  }
  const std::string all =
      fmt::format("<p>{} of {} elements fail a criterion ({:.2f} %).</p>\n", grouped(found.failing),
                  grouped(found.elements), found.elements ? 100.0 * found.failing / found.elements : 0.0);
  return section("quality", "Quality", static_cast<size_t>(failed),
                 all + table("Element quality against the limits", columns, rows));
}

std::string diagnostics(const BeadTable& table_of_beads) {
  static constexpr Column columns[] = {{"severity"}, {"code"},    {"face", true},
                                       {"entity"},   {"message"}, {"hint"}};
  std::string rows;
  for (const Diagnostic& d : table_of_beads.diagnostics) rows += diagnostic_row(d);
  return section("diagnostics", "Diagnostics", table_of_beads.diagnostics.size(),
                 rows.empty() ? "" : table("Diagnostics", columns, rows));
}

std::string faces_not_beads(const BeadTable& table_of_beads) {
  static constexpr Column columns[] = {{"face", true}, {"reason"}};
  std::string rows;
  for (const RejectedFace& face : table_of_beads.faces_not_beads)
    rows += fmt::format(
        "<tr data-face=\"{}\"><th scope=\"row\" class=\"number\">{}</th><td class=\"text\">{}</td></tr>\n",
        face.face, face.face, escaped(face.reason));
  return section("faces", "Faces that are no beads", table_of_beads.faces_not_beads.size(),
                 rows.empty() ? "" : table("Faces that are no beads, and why", columns, rows));
}

}  // namespace beadmesh::report_tables
