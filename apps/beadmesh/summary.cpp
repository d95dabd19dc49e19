#include "summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace beadmesh::app {
namespace {

std::string plural(size_t count, const char* word) {
  return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

std::string faces_of(const Panel& panel, const Bead& bead) {
  std::string text;
  for (const Index number : input_numbers(panel, bead.faces))
    text += fmt::format("{}{}", text.empty() ? "" : ",", number);
  return text.size() > 14 ? text.substr(0, 12) + ".." : text;
}

std::string counts_by_kind(const BeadTable& table) {
  std::string text;
  for (const BeadKind kind : {BeadKind::I, BeadKind::generic, BeadKind::annular}) {
    const auto count =
        std::count_if(table.beads.begin(), table.beads.end(), [&](const Bead& b) { return b.kind == kind; });
    if (count) text += fmt::format("{}{} {}", text.empty() ? " (" : ", ", count, name_of(kind));
  }
  return text.empty() ? "" : text + ")";
}

std::string failing_line(const GroupFindings& group) {
  const CriteriaFindings& f = group.findings;
  return fmt::format("{}: {} of {} fail ({:.2f} %)\n", group.name, f.failing, plural(f.elements, "element"),
                     f.elements ? 100.0 * f.failing / f.elements : 0.0);
}

std::string count_of(const MedialObject& object, MedialVertexType type, const char* name) {
  const auto count = std::count_if(object.vertices.begin(), object.vertices.end(),
                                   [&](const MedialVertex& v) { return v.type == type; });
  return count ? fmt::format(" {}{}", count, name) : "";
}

}  // namespace

std::string bead_summary(const Panel& panel, const BeadTable& table,
                         const std::vector<BeadMeshing>& meshing) {
  std::string text = fmt::format("{}: {}, {}{}\n", panel.input, plural(input_face_count(panel), "face"),
                                 plural(table.beads.size(), "bead"), counts_by_kind(table));
  if (table.beads.empty()) return text;
  text += fmt::format("{:>4}  {:8} {:8} {:14} {:>9} {:>8} {:>8} {:>6}", "id", "kind", "shape", "faces",
                      "length", "width", "height", "ratio");
  text += meshing.empty() ? "\n" : fmt::format("  {:8} {:>8}\n", "meshed", "elements");
  for (size_t i = 0; i < table.beads.size(); ++i) {
    const Bead& b = table.beads[i];
    text += fmt::format("{:>4}  {:8} {:8} {:14} {:>9.2f} {:>8.2f} {:>8.2f} {:>6.1f}", b.id, name_of(b.kind),
                        b.shape, faces_of(panel, b), b.length, b.width, b.height, b.aspect_ratio);
    text += i < meshing.size() ? fmt::format("  {:8} {:>8}\n", meshing[i].method, meshing[i].elements) : "\n";
  }
  return text;
}

std::string design_summary(const std::vector<BeadDesign>& designs) {
  if (designs.empty()) return "";
  const auto text_of = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.2f}", *value) : std::string("-");
  };
  std::string text =
      fmt::format("{:>4} {:>12} {:>10} {:>8} {:>8} {:>14} {:>8} {:>8}  {}\n", "id", "depth/width",
                  "wall angle", "crown r", "root r", "next bead", "rim", "hole", "past its limit");
  for (const BeadDesign& design : designs) {
    const SectionMeasures& s = design.sections;
    const BeadDistances& d = design.distances;
    std::string exceeded;
    for (const std::string& name : design.exceeded) exceeded += (exceeded.empty() ? "" : ", ") + name;
    text += fmt::format("{:>4} {:>12} {:>10} {:>8} {:>8} {:>14} {:>8} {:>8}  {}\n", design.id,
                        s.sections ? fmt::format("{:.3f}", s.depth_to_width) : "-",
                        s.sections ? fmt::format("{:.1f}", degrees(s.wall_angle)) : "-",
                        text_of(s.crown_radius), text_of(s.root_radius),
                        d.bead ? fmt::format("{:.2f} to {}", *d.bead, d.nearest_bead) : "-", text_of(d.rim),
                        text_of(d.hole), exceeded);
  }
  return text;
}

std::string quality_summary(const QualitySummary& q) {
  const int elements = q.quads + q.trias;
  return fmt::format(
      "mesh: {} nodes, {} quads, {} triangles ({:.2f} % quads), {} irregular nodes\n"
      "quality: scaled Jacobian min {:.3f}, mean {:.3f}; {} inverted; warpage up to {:.1f} degrees\n"
      "edges: {:.3f} to {:.3f} mm, {} below the minimum\n",
      q.nodes, q.quads, q.trias, elements ? 100.0 * q.quads / elements : 0.0, q.irregular,
      q.scaled_jacobian_min, q.scaled_jacobian_mean, q.inverted, q.warpage_max, q.edge_min, q.edge_max,
      q.edges_below_min);
}

std::string criteria_summary(const JudgedMesh& judged) {
  if (judged.parts.empty()) return "";
  const CriteriaFindings& all = judged.parts.front().findings;
  std::string text = fmt::format("{:<16} {:>9} {:>9} {:>10} {:>8} {:>8}\n", "criterion", "warn", "fail",
                                 "extreme", "warned", "failed");
  for (int m = 0; m < measure_count; ++m) {
    const Criterion& limits = judged.criteria.of[m];
    const MeasureFindings& found = all.of[m];
    const std::string extreme = found.extreme ? fmt::format("{:.3f}", *found.extreme) : "-";
    text +=
        fmt::format("{:<16} {:>9.3g} {:>9.3g} {:>10} {:>8} {:>8}\n", name_of(static_cast<QualityMeasure>(m)),
                    limits.warn, limits.fail, extreme, limits.on ? fmt::to_string(found.warned) : "off",
                    limits.on ? fmt::to_string(found.failed) : "off");
  }
  for (const GroupFindings& part : judged.parts) text += failing_line(part);
  for (const GroupFindings& bead : judged.beads)
    if (bead.findings.failing > 0) text += failing_line(bead);
  return text;
}

std::string failing_summary(const JudgedMesh& judged) {
  if (judged.parts.empty()) return "";
  const CriteriaFindings& all = judged.parts.front().findings;
  std::string what;
  for (int m = 0; m < measure_count; ++m)
    if (judged.criteria.of[m].on && all.of[m].failed > 0)
      what += fmt::format("{}{} {}", what.empty() ? "" : ", ", name_of(static_cast<QualityMeasure>(m)),
                          all.of[m].failed);
  return fmt::format("criteria: {} of {} fail ({:.2f} %){}{}\n", all.failing, plural(all.elements, "element"),
                     all.elements ? 100.0 * all.failing / all.elements : 0.0, what.empty() ? "" : ": ", what);
}

std::string repair_summary(const RepairFacts& facts, const JudgedMesh& after) {
  const CriteriaFindings& now = after.parts.front().findings;
  std::string what;
  for (int m = 0; m < measure_count; ++m)
    if (after.criteria.of[m].on && (facts.before.of[m].failed > 0 || now.of[m].failed > 0))
      what += fmt::format("; {} {} -> {}", name_of(static_cast<QualityMeasure>(m)), facts.before.of[m].failed,
                          now.of[m].failed);
  return fmt::format("repair: {} -> {} failing, {} moved{}\n", facts.before.failing, now.failing,
                     plural(static_cast<size_t>(facts.moved_nodes), "node"), what);
}

std::string medial_summary(const std::string& input, const std::vector<FaceMedial>& faces,
                           const std::vector<PlaneImage>& images) {
  std::string text = fmt::format("{}: medial object of {}\n", input, plural(faces.size(), "face"));
  text += fmt::format("{:>6} {:>6} {:>6} {:>10} {:>24}  vertices\n", "face", "loops", "edges", "length",
                      "thickness");
  for (size_t i = 0; i < faces.size(); ++i) {
    const FaceMedial& face = faces[i];
    double length = 0, low = 0, high = 0, area = 0;
    for (const MedialEdge& edge : face.object.edges) {
      low = length > 0 ? std::min(low, edge.thickness.min) : edge.thickness.min;
      high = std::max(high, edge.thickness.max);
      length += edge.length, area += edge.length * edge.thickness.mean;
    }
    text += fmt::format(
        "{:>6} {:>6} {:>6} {:>10.2f} {:>24} {}{}\n", face.face, face.object.loops, face.object.edges.size(),
        length, fmt::format("{:.2f} / {:.2f} / {:.2f}", low, length > 0 ? area / length : 0.0, high),
        count_of(face.object, MedialVertexType::J, "J") + count_of(face.object, MedialVertexType::C, "C") +
            count_of(face.object, MedialVertexType::S, "S") +
            count_of(face.object, MedialVertexType::isolated, " isolated"),
        i < images.size() && images[i].is_cut() ? fmt::format("; cut open over {:.2f}", images[i].cut_length)
                                                : "");
  }
  return text;
}

namespace {
/// Elements of a worse shape are named as a shortfall.
constexpr double least_jacobian = 0.3;
}  // namespace

std::vector<Diagnostic> shortfalls(const QualitySummary& quality, double min_edge) {
  std::vector<Diagnostic> found;
  if (quality.inverted > 0)
    found.push_back({"quality.inverted", Severity::warning, no_index, "",
                     plural(quality.inverted, "inverted element"), ""});
  if (quality.inverted == 0 && quality.scaled_jacobian_min < least_jacobian)
    found.push_back({"quality.jacobian", Severity::warning, no_index, "",
                     fmt::format("the worst scaled Jacobian is {:.3f}, under {}", quality.scaled_jacobian_min,
                                 least_jacobian),
                     ""});
  if (min_edge > 0 && quality.edges_below_min > 0)
    found.push_back({"quality.min_edge", Severity::warning, no_index, "",
                     fmt::format("{} below the minimum of {} mm, the shortest is {:.4f} mm",
                                 plural(quality.edges_below_min, "edge"), min_edge, quality.edge_min),
                     ""});
  return found;
}

std::vector<Diagnostic> shortfalls(const JudgedMesh& judged) {
  if (judged.parts.empty() || judged.parts.front().findings.holds()) return {};
  const CriteriaFindings& all = judged.parts.front().findings;
  std::string message = plural(all.failing, "element") + " past the limits";
  if (all[QualityMeasure::triangle_share].failed)
    message += fmt::format("; {:.2f} % triangles", *all[QualityMeasure::triangle_share].extreme);
  return {{"quality.criteria", Severity::warning, no_index, "", message, "see the table, or --json"}};
}

std::vector<Diagnostic> shortfalls(const PanelMesh& mesh, double min_edge) {
  std::vector<Diagnostic> found;
  for (const BeadMeshing& meshing : mesh.meshing)
    if (meshing.method == "fallback") {
      // The mesher has named each one already; this line says what it means for the exit status.
      found.push_back(
          {"mesh.fallback", Severity::note, no_index, "", "some beads were meshed by the fall-back", ""});
      break;
    }
  for (Diagnostic& one : shortfalls(mesh.quality, min_edge)) found.push_back(std::move(one));
  return found;
}

bool print_diagnostics(const std::vector<Diagnostic>& diagnostics) {
  bool any_error = false;
  for (const Diagnostic& diagnostic : diagnostics) {
    fmt::print(stderr, "{}\n", to_line(diagnostic));
    any_error |= diagnostic.severity == Severity::error;
  }
  return any_error;
}

}  // namespace beadmesh::app
