#include "beadmesh/write/bead_json.h"

#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "beadmesh/write/json_lines.h"

namespace beadmesh {
namespace {

using json::number;
using json::Value;

Value faces_of(const Panel& panel, const Bead& bead) {
  Value list = Value::array();
  for (const Index number : input_numbers(panel, bead.faces)) list.push_back(number);
  return list;
}

Value ridge_of(const Bead& bead) {
  Value list = Value::array();
  for (const RidgeCurve& curve : bead.ridge) {
    Value line = json::polyline(curve.points);
    if (curve.closed && curve.points.size() > 1 && curve.points.front() != curve.points.back())
      line.push_back(line.front());
    list.push_back(std::move(line));
  }
  return list;
}

Value row_of(const Panel& panel, const Bead& bead) {
  return {{"id", bead.id},
          {"kind", name_of(bead.kind)},
          {"shape", bead.shape},
          {"faces", faces_of(panel, bead)},
          {"point", json::point(bead.point)},
          {"loops", bead.loops},
          {"length", number(bead.length)},
          {"width", number(bead.width)},
          {"height", number(bead.height)},
          {"aspect_ratio", number(bead.aspect_ratio)},
          {"confidence", number(bead.confidence)},
          {"junctions", bead.junctions},
          {"ends", bead.ends},
          {"medial_edges", bead.medial_edges},
          {"ridge", ridge_of(bead)}};
}

/// Findings in short: what fails, by criterion; measures that are off are left out.
Value criteria_of(const JudgedMesh& judged) {
  const CriteriaFindings& all = judged.parts.front().findings;
  Value limits, failed;
  for (int m = 0; m < measure_count; ++m) {
    if (!judged.criteria.of[m].on) continue;
    const std::string name(name_of(static_cast<QualityMeasure>(m)));
    limits[name] = number(judged.criteria.of[m].fail);
    failed[name] = all.of[m].failed;
  }
  return {{"elements", all.elements}, {"failing", all.failing}, {"failed", failed}, {"limits", limits}};
}

Value quality_of(const PanelMesh& mesh) {
  Value object = json::quality(mesh.quality);
  if (!mesh.judged.parts.empty()) object["criteria"] = criteria_of(mesh.judged);
  return object;
}

/// Elements of a bead that fail any criterion.
std::optional<int> failing_of(const PanelMesh& mesh, Index bead) {
  for (size_t k = 0; k < mesh.judged.beads.size(); ++k)
    if (mesh.mesh.beads[k].bead == bead) return mesh.judged.beads[k].findings.failing;
  return std::nullopt;
}

Value meshing_of(const BeadMeshing& meshing, std::optional<int> failing) {
  Value notes = Value::array();
  for (const std::string& note : meshing.notes) notes.push_back(note);
  Value object{{"method", meshing.method}, {"elements", meshing.elements}};
  if (failing) object["failing"] = *failing;
  if (meshing.elements_across) object["elements_across"] = meshing.elements_across;
  object["size"] = number(meshing.size);
  object["min_edge"] = number(meshing.min_edge);
  object["notes"] = std::move(notes);
  return object;
}

/// One entry for each part and thickness; none where the file tells neither.
Value parts_of(const Panel& panel) {
  std::map<std::pair<Index, long>, std::vector<Index>> groups;  // thickness in hundredths of a mm
  for (size_t f = 0; f < panel.faces.size(); ++f) {
    const PanelFace& face = panel.faces[f];
    if (face.part == no_index && face.thickness <= 0) continue;
    groups[{face.part, std::lround(100 * face.thickness)}].push_back(Index(f));
  }
  Value list = Value::array();
  for (const auto& [key, faces] : groups) {
    Value entry = Value::object();
    if (key.first != no_index) {
      const PanelPart& part = panel.parts[key.first];
      entry["name"] = part.name;
      if (part.id > 0) entry["id"] = part.id;
      if (part.colour)
        entry["colour"] = {number((*part.colour)[0]), number((*part.colour)[1]), number((*part.colour)[2])};
    }
    if (key.second > 0) entry["thickness"] = number(double(key.second) / 100);
    entry["faces"] = input_numbers(panel, faces);
    list.push_back(std::move(entry));
  }
  return list;
}

Value number_or_null(const std::optional<double>& value) {
  return value ? number(*value) : Value();
}

Value design_of(const BeadDesign& design) {
  const SectionMeasures& s = design.sections;
  const auto where_measured = [&](double value) { return s.sections ? number(value) : Value(); };
  return {{"sections", s.sections},
          {"depth", where_measured(s.depth)},
          {"depth_to_width", where_measured(s.depth_to_width)},
          {"wall_angle", where_measured(degrees(s.wall_angle))},
          {"crown_radius", number_or_null(s.crown_radius)},
          {"root_radius", number_or_null(s.root_radius)},
          {"bead_distance", number_or_null(design.distances.bead)},
          {"nearest_bead", design.distances.bead ? Value(design.distances.nearest_bead) : Value()},
          {"rim_distance", number_or_null(design.distances.rim)},
          {"hole_distance", number_or_null(design.distances.hole)},
          {"exceeded", design.exceeded}};
}

std::string text_of(const Panel& panel, const BeadTable& table, const PanelMesh* mesh,
                    const std::vector<BeadDesign>& designs = {}) {
  Value beads = Value::array(), rejected = Value::array();
  for (size_t i = 0; i < table.beads.size(); ++i) {
    Value row = row_of(panel, table.beads[i]);
    if (mesh && i < mesh->meshing.size())
      row["mesh"] = meshing_of(mesh->meshing[i], failing_of(*mesh, table.beads[i].id));
    if (i < designs.size()) row["design"] = design_of(designs[i]);
    beads.push_back(std::move(row));
  }
  for (const RejectedFace& face : table.faces_not_beads)
    rejected.push_back({{"face", face.face}, {"reason", face.reason}});

  Value object;
  object["schema"] = "beadmesh.beads/1";
  object["input"] = panel.input;
  object["unit"] = "mm";
  if (Value parts = parts_of(panel); !parts.empty()) object["parts"] = std::move(parts);
  object["beads"] = std::move(beads);
  object["faces_not_beads"] = std::move(rejected);
  if (mesh)
    object["mesh"] = Value{{"nodes", mesh->quality.nodes},
                           {"quads", mesh->quality.quads},
                           {"trias", mesh->quality.trias},
                           {"quality", quality_of(*mesh)}};
  object["diagnostics"] = json::diagnostics(table.diagnostics);
  return json::lines_of(object);
}

}  // namespace

std::string bead_json(const Panel& panel, const BeadTable& table) {
  return text_of(panel, table, nullptr);
}

std::string bead_json(const Panel& panel, const BeadTable& table, const std::vector<BeadDesign>& designs) {
  return text_of(panel, table, nullptr, designs);
}

std::string bead_json(const Panel& panel, const PanelMesh& mesh, const std::vector<BeadDesign>& designs) {
  return text_of(panel, mesh.table, &mesh, designs);
}

}  // namespace beadmesh
