#include "beadmesh/mesh/node_star.h"

#include <algorithm>

namespace beadmesh {

void NodeStar::gather(Index node, const SurfaceNodes& nodes, const QuadConnectivity& mesh) {
  const std::vector<Index>& star = mesh.star(node);
  elements_.resize(star.size());
  const auto leaves_towards = [&](Index other) {
    return std::any_of(star.begin(), star.end(),
                       [&](Index e) { return corner_neighbours(mesh.element(e), node).first == other; });
  };
  for (size_t k = 0; k < star.size(); ++k) {
    const MeshElement& element = mesh.element(star[k]);
    StarElement& one = elements_[k];
    one.element = star[k];
    one.at = corner_of(element, node);
    one.places = places_of(nodes, element);
    one.is_own = {};
    one.is_own[one.at] = true;
    const int count = one.places.count, before = (one.at + count - 1) % count;
    one.is_own[before] = !leaves_towards(element[before]);
  }
}

void NodeStar::gather_edges(Index node, const QuadConnectivity& mesh, const SlidingLines& lines) {
  ends_.clear();
  for (StarElement& one : elements_) {
    const MeshElement& element = mesh.element(one.element);
    const int count = one.places.count;
    for (const int i : {0, 1}) {
      const Index end = element[(one.at + (i == 0 ? 1 : count - 1)) % count];
      const auto known = std::find(ends_.begin(), ends_.end(), end);
      one.edges[i] = {Index(known - ends_.begin()), known == ends_.end(),
                      lines.on_crest(node) && lines.on_crest(end)};
      if (known == ends_.end()) ends_.push_back(end);
    }
  }
}

}  // namespace beadmesh
