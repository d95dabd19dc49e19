#include "beadmesh/write/bead_csv.h"

#include <fmt/format.h>

namespace beadmesh {
namespace {

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

std::string faces_of(const Panel& panel, const Bead& bead) {
  std::string text;
  for (const Index number : input_numbers(panel, bead.faces))
    text += fmt::format("{}{}", text.empty() ? "" : " ", number);
  return text;
}

constexpr const char* names =
    "id,kind,shape,faces,x,y,z,loops,length,width,height,aspect_ratio,junctions,ends,medial_edges";

std::string fields_of(const Panel& panel, const Bead& b) {
  return fmt::format("{},{},{},{},{:.4f},{:.4f},{:.4f},{},{:.4f},{:.4f},{:.4f},{:.4f},{},{},{}", b.id,
                     name_of(b.kind), quoted(b.shape), faces_of(panel, b), b.point.x, b.point.y, b.point.z,
                     b.loops, b.length, b.width, b.height, b.aspect_ratio, b.junctions, b.ends,
                     b.medial_edges);
}

std::string field_of(const std::optional<double>& value) {
  return value ? fmt::format("{:.4f}", *value) : "";
}

std::string design_fields(const BeadDesign& design) {
  const SectionMeasures& s = design.sections;
  const BeadDistances& d = design.distances;
  const auto where_measured = [&](double value) { return s.sections ? fmt::format("{:.4f}", value) : ""; };
  std::string exceeded;
  for (const std::string& name : design.exceeded) exceeded += (exceeded.empty() ? "" : " ") + name;
  return fmt::format("{},{},{},{},{},{},{},{},{},{}", where_measured(s.depth),
                     where_measured(s.depth_to_width), where_measured(degrees(s.wall_angle)),
                     field_of(s.crown_radius), field_of(s.root_radius), field_of(d.bead),
                     d.bead ? fmt::to_string(d.nearest_bead) : "", field_of(d.rim), field_of(d.hole),
                     exceeded);
}

}  // namespace

std::string bead_csv(const Panel& panel, const BeadTable& table) {
  std::string text = std::string(names) + "\n";
  for (const Bead& bead : table.beads) text += fields_of(panel, bead) + "\n";
  return text;
}

std::string bead_csv(const Panel& panel, const BeadTable& table, const std::vector<BeadDesign>& designs) {
  std::string text = std::string(names) +
                     ",depth,depth_to_width,wall_angle,crown_radius,root_radius,bead_distance,nearest_bead,"
                     "rim_distance,hole_distance,exceeded\n";
  for (size_t i = 0; i < table.beads.size(); ++i)
    text += fields_of(panel, table.beads[i]) + "," + design_fields(designs[i]) + "\n";
  return text;
}

}  // namespace beadmesh
