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

}  // namespace

std::string bead_csv(const Panel& panel, const BeadTable& table) {
  std::string text =
      "id,kind,shape,faces,x,y,z,loops,length,width,height,aspect_ratio,junctions,ends,medial_edges\n";
  for (const Bead& b : table.beads)
    text += fmt::format("{},{},{},{},{:.4f},{:.4f},{:.4f},{},{:.4f},{:.4f},{:.4f},{:.4f},{},{},{}\n", b.id,
                        name_of(b.kind), quoted(b.shape), faces_of(panel, b), b.point.x, b.point.y, b.point.z,
                        b.loops, b.length, b.width, b.height, b.aspect_ratio, b.junctions, b.ends,
                        b.medial_edges);
  return text;
}

}  // namespace beadmesh
