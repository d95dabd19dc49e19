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

json::Value findings_json(QualityMeasure measure, const MeasureFindings& findings) {
  json::Value object;
  object["name"] = std::string(name_of(measure));
  object["extreme"] = findings.extreme ? json::number(*findings.extreme) : json::Value(nullptr);
  object["element"] =
      findings.extreme_element == no_index ? json::Value(nullptr) : json::Value(findings.extreme_element + 1);
  object["failed"] = findings.failed;
  object["warned"] = findings.warned;
  return object;
}

void add_judgement(json::Value& object, const JudgedMesh& judged) {
  object["criteria"] = json::Value::array();
  object["parts"] = json::Value::array();
  for (int m = 0; m < measure_count; ++m)
    object["criteria"].push_back(criterion_json(static_cast<QualityMeasure>(m), judged.criteria.of[m]));
  for (const PartFindings& part : judged.parts) {
    json::Value one{{"name", part.name},
                    {"elements", part.findings.elements},
                    {"failing", part.findings.failing},
                    {"measures", json::Value::array()}};
    for (int m = 0; m < measure_count; ++m)
      one["measures"].push_back(findings_json(static_cast<QualityMeasure>(m), part.findings.of[m]));
    object["parts"].push_back(std::move(one));
  }
}

}  // namespace

std::string quality_json(const std::string& input, const QualitySummary& quality, double size,
                         double min_edge, const JudgedMesh& judged) {
  json::Value object;
  object["schema"] = "beadmesh.check/1";
  object["input"] = input;
  object["size"] = size > 0 ? json::number(size) : json::Value(nullptr);
  object["min_edge"] = min_edge > 0 ? json::number(min_edge) : json::Value(nullptr);
  object["mesh"] = json::Value{{"nodes", quality.nodes},
                               {"quads", quality.quads},
                               {"trias", quality.trias},
                               {"quality", json::quality(quality)}};
  if (!judged.parts.empty()) add_judgement(object, judged);
  return json::lines_of(object);
}

}  // namespace beadmesh
