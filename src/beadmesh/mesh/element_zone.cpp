#include "beadmesh/mesh/element_zone.h"

#include <map>
#include <set>

namespace beadmesh {

std::vector<Index> elements_within(const QuadConnectivity& mesh, Index element, int rings) {
  std::set<Index> zone{element};
  for (int ring = 0; ring < rings; ++ring) {
    std::set<Index> grown = zone;
    for (const Index e : zone)
      for (int i = 0; i < corner_count(mesh.element(e)); ++i) {
        const auto& star = mesh.star(mesh.element(e)[i]);
        grown.insert(star.begin(), star.end());
      }
    zone = std::move(grown);
  }
  return {zone.begin(), zone.end()};
}

std::vector<std::array<Index, 2>> outline_of(const std::vector<MeshElement>& elements) {
  std::set<std::array<Index, 2>> edges;
  for (const MeshElement& e : elements)
    for (int i = 0; i < corner_count(e); ++i) edges.insert({e[i], e[(i + 1) % corner_count(e)]});
  std::vector<std::array<Index, 2>> outline;
  for (const auto& [a, b] : edges)
    if (!edges.count({b, a})) outline.push_back({a, b});
  return outline;
}

std::optional<std::vector<Index>> closed_loop(const std::vector<std::array<Index, 2>>& outline) {
  std::map<Index, Index> next;
  for (const auto& [a, b] : outline)
    if (!next.emplace(a, b).second) return std::nullopt;
  std::vector<Index> loop;
  for (auto at = next.begin(); at != next.end(); at = next.find(loop.back())) {
    loop.push_back(at->second);
    next.erase(at);
  }
  if (!next.empty() || loop.empty()) return std::nullopt;
  return loop;
}

PlanarMesh living_part(const QuadConnectivity& mesh, const std::vector<Vec2>& places,
                       const std::vector<NodeFreedom>& freedom, std::vector<Index>& number) {
  PlanarMesh out;
  number.assign(mesh.node_count(), no_index);
  for (Index node = 0; node < mesh.node_count(); ++node) {
    if (mesh.star(node).empty()) continue;
    number[node] = static_cast<Index>(out.nodes.size());
    out.nodes.push_back(places[node]);
    out.freedom.push_back(freedom[node]);
  }
  for (Index e = 0; e < mesh.element_count(); ++e) {
    if (!mesh.is_alive(e)) continue;
    MeshElement element = mesh.element(e);
    for (int i = 0; i < corner_count(element); ++i) element[i] = number[element[i]];
    out.elements.push_back(element);
  }
  return out;
}

}  // namespace beadmesh
