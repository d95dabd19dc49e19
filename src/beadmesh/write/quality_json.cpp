#include "beadmesh/write/quality_json.h"

#include "beadmesh/write/json_lines.h"

namespace beadmesh {

std::string quality_json(const std::string& input, const QualitySummary& quality, double size,
                         double min_edge) {
  json::Value object;
  object["schema"] = "beadmesh.check/1";
  object["input"] = input;
  object["size"] = size > 0 ? json::number(size) : json::Value(nullptr);
  object["min_edge"] = min_edge > 0 ? json::number(min_edge) : json::Value(nullptr);
  object["mesh"] = json::Value{{"nodes", quality.nodes},
                               {"quads", quality.quads},
                               {"trias", quality.trias},
                               {"quality", json::quality(quality)}};
  return json::lines_of(object);
}

}  // namespace beadmesh
