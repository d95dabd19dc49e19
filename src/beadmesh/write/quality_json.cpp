#include "beadmesh/write/quality_json.h"

#include "beadmesh/write/json_lines.h"

namespace beadmesh {
namespace {

json::Value criterion_json(QualityMeasure measure, const Criterion& criterion) {
  return {{"name", std::string(name_of(measure))},    {"on", criterion.on},
          {"weight", json::number(criterion.weight)}, {"ideal", json::number(criterion.ideal)},
          {"good", json::number(criterion.good)},     {"warn", json::number(criterion.warn)},
          {"fail", json::number(criterion.fail)},     {"worst", json::number(criterion.worst)}};
}

json::Value findings_json(QualityMeasure measure, const MeasureFindings& findings,
                          const std::vector<Index>& ids) {
  json::Value object;
  object["name"] = std::string(name_of(measure));
  object["extreme"] = findings.extreme ? json::number(*findings.extreme) : json::Value(nullptr);
  object["element"] = findings.extreme_element == no_index ? json::Value(nullptr)
                                                           : json::Value(ids[findings.extreme_element]);
  object["failed"] = findings.failed;
  object["warned"] = findings.warned;
  return object;
}

json::Value groups_json(const std::vector<GroupFindings>& groups, const std::vector<Index>& ids) {
  json::Value list = json::Value::array();
  for (const GroupFindings& group : groups) {
    json::Value one{{"name", group.name},
                    {"elements", group.findings.elements},
                    {"failing", group.findings.failing},
                    {"measures", json::Value::array()}};
    for (int m = 0; m < measure_count; ++m)
      one["measures"].push_back(findings_json(static_cast<QualityMeasure>(m), group.findings.of[m], ids));
    list.push_back(std::move(one));
  }
  return list;
}

void add_judgement(json::Value& object, const JudgedMesh& judged, const std::vector<Index>& ids) {
  object["criteria"] = json::Value::array();
  for (int m = 0; m < measure_count; ++m)
    object["criteria"].push_back(criterion_json(static_cast<QualityMeasure>(m), judged.criteria.of[m]));
  object["parts"] = groups_json(judged.parts, ids);
  object["beads"] = groups_json(judged.beads, ids);
}

json::Value repair_json(const RepairFacts& repair, const QualityCriteria& criteria) {
  json::Value failed;
  for (int m = 0; m < measure_count; ++m)
    if (criteria.of[m].on)
      failed[std::string(name_of(static_cast<QualityMeasure>(m)))] = repair.before.of[m].failed;
  return {{"zones", repair.zones},
          {"moved_nodes", repair.moved_nodes},
          {"failing_before", repair.before.failing},
          {"failed_before", failed}};
}

}  // namespace

std::string quality_json(const std::string& input, const QualitySummary& quality, double size,
                         double min_edge, const JudgedMesh& judged, const std::vector<Index>& element_ids,
                         const std::optional<RepairFacts>& repair) {
  json::Value object;
  object["schema"] = "beadmesh.check/1";
  object["input"] = input;
  object["size"] = size > 0 ? json::number(size) : json::Value(nullptr);
  object["min_edge"] = min_edge > 0 ? json::number(min_edge) : json::Value(nullptr);
  object["mesh"] = json::Value{{"nodes", quality.nodes},
                               {"quads", quality.quads},
                               {"trias", quality.trias},
                               {"quality", json::quality(quality)}};
  if (!judged.parts.empty()) add_judgement(object, judged, element_ids);
  if (repair) object["repair"] = repair_json(*repair, judged.criteria);
  return json::lines_of(object);
}

}  // namespace beadmesh
