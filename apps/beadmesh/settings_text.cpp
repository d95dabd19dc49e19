#include "settings_text.h"

#include <fmt/format.h>

namespace beadmesh::app {
namespace {

void append(std::string& text, const std::string& more) {
  text += (text.empty() ? "" : ", ") + more;
}

std::string control_text(const BeadMeshControl& control) {
  std::string text;
  if (control.size) append(text, fmt::format("size = {:g}", *control.size));
  if (control.min_edge) append(text, fmt::format("min_edge = {:g}", *control.min_edge));
  if (control.elements_across) append(text, fmt::format("elements_across = {}", *control.elements_across));
  if (control.elements_along) append(text, fmt::format("elements_along = {}", *control.elements_along));
  if (control.clamp_rows) append(text, fmt::format("clamp_rows = {}", *control.clamp_rows));
  constexpr const char* methods[] = {"automatic", "blocks", "ridge", "face"};
  if (control.method) append(text, fmt::format("method = \"{}\"", methods[int(*control.method)]));
  return text;
}

std::string point_text(Vec3 point) {
  return fmt::format("point = [{:g}, {:g}, {:g}]", point.x, point.y, point.z);
}

void add_controls(const BeadControls& controls, std::vector<std::string>& lines) {
  const auto add = [&](const char* table, const BeadMeshControl& control) {
    const std::string text = control_text(control);
    if (!text.empty()) lines.push_back(fmt::format("{} {}", table, text));
  };
  add("[mesh.bead]", controls.all);
  add("[mesh.bead.I]", controls.of(BeadKind::I));
  add("[mesh.bead.generic]", controls.of(BeadKind::generic));
  add("[mesh.bead.annular]", controls.of(BeadKind::annular));
  for (const auto& [bead, control] : controls.single) {
    std::string text = bead.id > 0 ? fmt::format("id = {}", bead.id) : point_text(bead.point);
    if (const std::string more = control_text(control); !more.empty()) append(text, more);
    lines.push_back("[[mesh.beads]] " + text);
  }
}

std::string washer_text(const WasherControl& washers) {
  std::string text = fmt::format("[mesh.holes] rows = {}", washers.rows);
  if (washers.width) append(text, fmt::format("width = {:g}", *washers.width));
  if (washers.min_diameter) append(text, fmt::format("min_diameter = {:g}", *washers.min_diameter));
  if (washers.max_diameter) append(text, fmt::format("max_diameter = {:g}", *washers.max_diameter));
  if (washers.elements_around) append(text, fmt::format("elements_around = {}", *washers.elements_around));
  return text;
}

}  // namespace

std::vector<std::string> settings_lines(const Settings& s) {
  std::vector<std::string> lines = {
      fmt::format("size = {:g}, min_edge = {:g}, thickness = {:g}", s.sizes.size, s.sizes.min_edge,
                  s.sizes.thickness),
      fmt::format("[bead] min_aspect_ratio = {:g}, max_loops = {}, max_joint_angle = {:g}, min_rise = {:g}",
                  s.beads.min_aspect_ratio, s.beads.max_loops, degrees(s.beads.max_joint_angle),
                  s.beads.min_rise),
      fmt::format("[read] chord = {:g}, angle = {:g}, max_facet = {:g}, sew_tolerance = {:g}, "
                  "feature_angle = {:g}, unit = \"{}\"",
                  s.read.chord, degrees(s.read.angle), s.read.max_facet, s.read.sew_tolerance,
                  degrees(s.read.feature_angle), s.read.unit)};
  if (s.sizes.chordal_deviation > 0)
    lines.push_back(fmt::format("chordal_deviation = {:g}", s.sizes.chordal_deviation));
  if (s.sizes.washers != WasherControl{}) lines.push_back(washer_text(s.sizes.washers));
  for (const Vec3 p : s.kept_edges)
    lines.push_back(fmt::format("[mesh] keep_edges = [[{:g}, {:g}, {:g}]]", p.x, p.y, p.z));
  add_controls(s.sizes.beads, lines);
  for (const LocalSize& local : s.sizes.local)
    lines.push_back(fmt::format("[[mesh.local_size]] {}, radius = {:g}, size = {:g}", point_text(local.point),
                                local.radius, local.size));
  return lines;
}

}  // namespace beadmesh::app
