#include "beadmesh/report/panel_html.h"

#include <fmt/format.h>

#include "beadmesh/core/version.h"
#include "beadmesh/report/drawing.h"
#include "beadmesh/report/panel_svg.h"
#include "beadmesh/report/report_page.h"

namespace beadmesh {
namespace {

using drawing::escaped;

std::string heading(const ReportFacts& facts) {
  std::string text = fmt::format("<header><h1>{}</h1>\n<div class=\"settings\">", escaped(facts.title));
  for (const auto& [name, value] : facts.settings)
    text += fmt::format("<span>{} <b>{}</b></span>", escaped(name), escaped(value));
  return text + "</div></header>\n";
}

std::string figure(const std::string& value, const char* name, bool bad = false) {
  return fmt::format("<div class=\"figure{}\"><b>{}</b><small>{}</small></div>\n", bad ? " bad" : "", value,
                     name);
}

std::string figures(const PanelMesh& mesh) {
  const QualitySummary& q = mesh.quality;
  const int elements = q.quads + q.trias;
  std::string text = "<section><div class=\"figures\">\n";
  text += figure(std::to_string(mesh.table.beads.size()), "beads");
  text += figure(std::to_string(q.nodes), "nodes");
  text += figure(std::to_string(q.quads), "quads");
  text += figure(std::to_string(q.trias), "triangles");
  text += figure(fmt::format("{:.2f} %", elements > 0 ? 100.0 * q.quads / elements : 0.0),
                 "quads of all elements");
  text += figure(fmt::format("{:.3f}", q.scaled_jacobian_min), "scaled Jacobian, min",
                 q.scaled_jacobian_min <= 0);
  text += figure(fmt::format("{:.3f}", q.scaled_jacobian_mean), "scaled Jacobian, mean");
  text += figure(fmt::format("{:.2f}", q.edge_min), "shortest edge, mm", q.edges_below_min > 0);
  text += figure(fmt::format("{:.2f}", q.edge_max), "longest edge, mm");
  text += figure(std::to_string(q.edges_below_min), "edges below minimum", q.edges_below_min > 0);
  text += figure(std::to_string(q.inverted), "inverted", q.inverted > 0);
  text += figure(fmt::format("{:.1f}&deg;", q.warpage_max), "largest warpage");
  text += figure(std::to_string(q.warped_over_15), "warped over 15&deg;");
  text += figure(std::to_string(q.irregular), "irregular nodes");
  return text + "</div></section>\n";
}

std::string picture(const PanelMesh& mesh) {
  return "<section><div class=\"picture\">\n" + panel_svg(mesh) +
         "<div class=\"tools\"><button id=\"zoom-in\" title=\"larger\">+</button>"
         "<button id=\"zoom-out\" title=\"smaller\">&minus;</button>"
         "<button id=\"zoom-all\" title=\"all of it\">&#8634;</button></div>\n</div></section>\n";
}

std::string faces_of(const Panel& panel, const Bead& bead) {
  std::string text;
  for (const Index number : input_numbers(panel, bead.faces))
    text += fmt::format("{}{}", text.empty() ? "" : ", ", number);
  return text;
}

std::string method_of(const PanelMesh& mesh, size_t i) {
  if (i >= mesh.meshing.size()) return "<td></td><td class=\"number\"></td><td class=\"text\"></td>";
  const BeadMeshing& meshing = mesh.meshing[i];
  std::string notes;
  for (const std::string& note : meshing.notes) notes += (notes.empty() ? "" : "; ") + note;
  return fmt::format("<td{}>{}</td><td class=\"number\">{}</td><td class=\"text\">{}</td>",
                     meshing.method == "fallback" ? " class=\"fallback\"" : "", escaped(meshing.method),
                     meshing.elements, escaped(notes));
}

std::string bead_row(const Panel& panel, const PanelMesh& mesh, size_t i) {
  const Bead& b = mesh.table.beads[i];
  const std::string kind = name_of(b.kind);
  return fmt::format(
      "<tr><td class=\"number\">{}</td><td><span class=\"dot kind-{}\"></span>{}</td><td>{}</td><td>{}</td>"
      "<td class=\"number\">{:.1f}</td><td class=\"number\">{:.2f}</td><td class=\"number\">{:.2f}</td>"
      "<td class=\"number\">{:.1f}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>{}</tr>\n",
      b.id, kind, kind, escaped(b.shape), faces_of(panel, b), b.length, b.width, b.height, b.aspect_ratio,
      b.junctions, b.ends, method_of(mesh, i));
}

std::string bead_section(const Panel& panel, const PanelMesh& mesh) {
  std::string text = "<section><h2>Beads</h2>\n";
  if (mesh.table.beads.empty()) return text + "<p class=\"none\">None.</p></section>\n";
  text +=
      "<div class=\"wide\"><table class=\"sortable\"><thead><tr><th "
      "class=\"number\">id</th><th>kind</th><th>shape</th>"
      "<th>faces</th><th class=\"number\">length, mm</th><th class=\"number\">width, mm</th><th "
      "class=\"number\">height, mm</th>"
      "<th class=\"number\">aspect ratio</th><th class=\"number\">junctions</th><th "
      "class=\"number\">ends</th><th>meshed by</th>"
      "<th class=\"number\">elements</th><th>notes</th></tr></thead><tbody>\n";
  for (size_t i = 0; i < mesh.table.beads.size(); ++i) text += bead_row(panel, mesh, i);
  return text + "</tbody></table></div></section>\n";
}

std::string rejected_section(const BeadTable& table) {
  std::string text = "<section><h2>Faces that are no beads</h2>\n";
  if (table.faces_not_beads.empty()) return text + "<p class=\"none\">None.</p></section>\n";
  text +=
      "<div class=\"wide\"><table class=\"sortable\"><thead><tr><th "
      "class=\"number\">face</th><th>reason</th></tr></thead><tbody>\n";
  for (const RejectedFace& face : table.faces_not_beads)
    text += fmt::format("<tr><td class=\"number\">{}</td><td class=\"text\">{}</td></tr>\n", face.face,
                        escaped(face.reason));
  return text + "</tbody></table></div></section>\n";
}

std::string diagnostic_rows(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& d : diagnostics)
    text += fmt::format(
        "<tr><td class=\"{}\">{}</td><td>{}</td><td class=\"number\">{}</td><td>{}</td><td "
        "class=\"text\">{}</td>"
        "<td class=\"text\">{}</td></tr>\n",
        name_of(d.severity), name_of(d.severity), escaped(d.code),
        d.face == no_index ? "" : std::to_string(d.face), escaped(d.entity), escaped(d.message),
        escaped(d.hint));
  return text;
}

std::string diagnostic_section(const BeadTable& table) {
  const std::string rows = diagnostic_rows(table.diagnostics);
  std::string text = "<section><h2>Diagnostics</h2>\n";
  if (rows.empty()) return text + "<p class=\"none\">None.</p></section>\n";
  return text +
         "<div class=\"wide\"><table class=\"sortable\"><thead><tr><th>severity</th><th>code</th><th "
         "class=\"number\">face</th>"
         "<th>entity</th><th>message</th><th>hint</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div></section>\n";
}

}  // namespace

std::string panel_html(const Panel& panel, const PanelMesh& mesh, const ReportFacts& facts) {
  std::string text = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n";
  text += "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n<title>" +
          escaped(facts.title) + "</title>\n<style>" + report_style + "</style></head>\n<body>\n";
  text += heading(facts) + figures(mesh) + picture(mesh) + bead_section(panel, mesh) +
          rejected_section(mesh.table) + diagnostic_section(mesh.table);
  text += fmt::format("<footer>beadmesh {}</footer>\n<script>{}</script>\n</body></html>\n", version(),
                      report_script);
  return text;
}

}  // namespace beadmesh
