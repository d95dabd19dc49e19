#include "beadmesh/report/panel_html.h"

#include <fmt/format.h>

#include "beadmesh/core/version.h"
#include "beadmesh/report/drawing.h"
#include "beadmesh/report/packed_numbers.h"
#include "beadmesh/report/panel_scene.h"
#include "beadmesh/report/panel_svg.h"
#include "beadmesh/report/report_tables.h"
#include "beadmesh/report/viewer_bundle.h"

namespace beadmesh {
namespace {

using drawing::escaped;

/// Larger flat pictures are left out: without WebGL such a panel shows its tables only.
constexpr size_t most_flat_elements = 100000;

std::string heading(const ReportFacts& facts) {
  std::string text = fmt::format("<header><h1>{}</h1>\n<ul class=\"settings\">", escaped(facts.title));
  for (const auto& [name, value] : facts.settings)
    text += fmt::format("<li>{} <b>{}</b></li>", escaped(name), escaped(value));
  return text + "</ul></header>\n";
}

/// The picture that stands in where there is no WebGL.
std::string flat_picture(const PanelMesh& mesh) {
  if (mesh.mesh.elements.empty() || mesh.mesh.elements.size() > most_flat_elements) return "";
  return "<script type=\"text/plain\" id=\"flat-picture\">" + packed_text(panel_svg(mesh)) + "</script>\n";
}

}  // namespace

ReportFacts facts_of_run(const Panel& panel, double size, double min_edge, double thickness) {
  return {panel.input,
          {{"size", fmt::format("{:g} mm", size)},
           {"minimum edge", fmt::format("{:g} mm", min_edge)},
           {"thickness", fmt::format("{:g} mm", thickness)},
           {"faces", std::to_string(input_face_count(panel))},
           {"beadmesh", std::string(version())}},
          min_edge,
          criteria_of_sizes(size, min_edge)};
}

ReportFacts facts_of_recognition(const Panel& panel, const BeadTable& table) {
  return {panel.input,
          {{"faces", std::to_string(input_face_count(panel))},
           {"beads", std::to_string(table.beads.size())},
           {"beadmesh", std::string(version())}}};
}

std::string panel_html(const Panel& panel, const PanelMesh& mesh, const ReportFacts& facts) {
  namespace tables = report_tables;
  std::string text = "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n";
  text += "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n<title>" +
          escaped(facts.title) + "</title>\n<style>";
  text += viewer_style();
  text += "</style></head>\n<body>\n" + heading(facts) +
          "<main>\n<div id=\"stage\"><noscript>The picture needs JavaScript; the tables do "
          "not.</noscript></div>\n"
          "<div id=\"tables\">\n";
  text += tables::overview(mesh) + tables::beads(panel, mesh) + tables::design(facts) +
          tables::quality(mesh, facts) + tables::diagnostics(mesh.table) +
          tables::faces_not_beads(mesh.table);
  text += fmt::format("</div>\n</main>\n<footer>beadmesh {}</footer>\n", version());
  text += flat_picture(mesh);
  text += "<script type=\"application/json\" id=\"scene\">" + panel_scene(panel, mesh, facts) +
          "</script>\n<script>";
  text += viewer_script();
  return text + "</script>\n</body></html>\n";
}

}  // namespace beadmesh
