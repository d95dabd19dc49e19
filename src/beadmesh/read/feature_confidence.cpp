#include "beadmesh/read/feature_confidence.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

constexpr double clear_turn = radians(6);
constexpr double enough_across = 2.5;
constexpr double least = 0.05;

struct FeatureMeasure {
  double area = 0, outline = 0;
  double turned = 0;  ///< integral over the outline of how clearly it turns, 0 to 1
  int triangles = 0;
};

/// Largest turn to the neighbours in the same face.
double unrest(const FacetMesh& mesh, const FacetGroups& groups, Index t) {
  double most = 0;
  for (Index h = 3 * t; h < 3 * t + 3; ++h)
    if (mesh.beyond(h) != no_index && groups.face[mesh.beyond(h)] == groups.face[t])
      most = std::max(most, mesh.turn(h));
  return most;
}

}  // namespace

std::vector<double> confidences(const FacetMesh& mesh, const FacetGroups& groups) {
  std::vector<FeatureMeasure> measures(groups.is_feature.size());
  for (Index h = 0; h < 3 * mesh.triangle_count(); ++h) {
    FeatureMeasure& of = measures[groups.face[h / 3]];
    if (h % 3 == 0) of.area += mesh.area(h / 3), ++of.triangles;
    const Index other = mesh.beyond(h);
    if (other == no_index || groups.is_feature[groups.face[other]]) continue;
    if (!groups.is_feature[groups.face[h / 3]]) continue;
    const double clear = (mesh.turn(h) - unrest(mesh, groups, other)) / clear_turn;
    of.outline += mesh.length(h);
    of.turned += mesh.length(h) * std::clamp(clear, 0.0, 1.0);
  }
  std::vector<double> result(measures.size(), 0);
  for (size_t f = 0; f < measures.size(); ++f) {
    const FeatureMeasure& of = measures[f];
    if (!groups.is_feature[f]) continue;
    result[f] = least;
    if (!(of.outline > 0)) continue;
    const double width = 2 * of.area / of.outline, facet = std::sqrt(2 * of.area / of.triangles);
    const double across = facet > 0 ? std::min(1.0, width / facet / enough_across) : 1;
    result[f] = std::clamp(of.turned / of.outline * across, least, 1.0);
  }
  return result;
}

}  // namespace beadmesh
