#include "examples/truth.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace beadmesh::examples {
namespace {

using nlohmann::json;

json pair_of(Vec2 p) {
  return json::array({p.x, p.y});
}

json loop_json(const PlanLoop& loop) {
  json edges = json::array();
  for (const PlanEdge& e : loop) {
    if (e.is_arc())
      edges.push_back(
          {{"t", "A"}, {"c", pair_of(e.centre)}, {"r", e.radius}, {"a0", e.start_angle}, {"ang", e.sweep}});
    else
      edges.push_back({{"t", "L"}, {"p", pair_of(e.start)}, {"q", pair_of(e.end)}});
  }
  return edges;
}

json chain_json(const PlanLoop& chain) {
  json points = json::array();
  for (const Vec2 p : sampled(chain)) points.push_back(pair_of(p));
  if (!chain.empty()) points.push_back(pair_of(chain.back().end));
  return points;
}

}  // namespace

bool FeatureTruth::contains(Vec2 p) const {
  return BoundaryDistance(footprint)(p) >= 0;
}

std::vector<FeatureTruth> truth_of(const PanelDesign& design) {
  std::vector<FeatureTruth> result;
  for (const Feature& f : design.features)
    result.push_back({f.name.empty() ? f.shape : f.name, f.shape, f.kind, int(f.footprint.loops.size()),
                      f.footprint.centreline_length, f.footprint.mean_width, std::abs(f.height), f.loops(),
                      f.centrelines()});
  return result;
}

std::string truth_json(const PanelDesign& design) {
  json features = json::array();
  for (const FeatureTruth& t : truth_of(design)) {
    json loops = json::array(), centrelines = json::array();
    for (const PlanLoop& loop : t.footprint) loops.push_back(loop_json(loop));
    for (const PlanLoop& chain : t.centrelines) centrelines.push_back(chain_json(chain));
    features.push_back({{"id", features.size() + 1},
                        {"name", t.name},
                        {"shape", t.shape},
                        {"kind", t.kind.empty() ? "not-bead" : t.kind},
                        {"paper_rule", t.kind.empty() ? "none" : t.kind},
                        {"loops", t.loops},
                        {"height", t.height},
                        {"mean_width", t.width},
                        {"centreline_length", t.length},
                        {"footprint", loops},
                        {"centrelines", centrelines}});
  }
  return json{{"panel", design.name}, {"units", "mm"}, {"features", features}}.dump(1) + "\n";
}

}  // namespace beadmesh::examples
