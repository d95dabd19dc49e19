#include "beadmesh/mesh/quad_connectivity.h"

#include <algorithm>

namespace beadmesh {

QuadConnectivity::QuadConnectivity(const PlanarMesh& mesh)
    : elements_(mesh.elements), stars_(mesh.nodes.size()) {
  std::vector<int> valences(mesh.nodes.size(), 0);
  for (const MeshElement& element : elements_)
    for (int i = 0; i < corner_count(element); ++i) ++valences[element[i]];
  for (size_t node = 0; node < stars_.size(); ++node) stars_[node].reserve(valences[node]);
  for (Index e = 0; e < element_count(); ++e)
    for (int i = 0; i < corner_count(elements_[e]); ++i) stars_[elements_[e][i]].push_back(e);
}

Index QuadConnectivity::add_node() {
  stars_.emplace_back();
  return node_count() - 1;
}

Index QuadConnectivity::add_element(const MeshElement& element) {
  elements_.push_back(element);
  for (int i = 0; i < corner_count(element); ++i) stars_[element[i]].push_back(element_count() - 1);
  return element_count() - 1;
}

void QuadConnectivity::remove_element(Index element) {
  MeshElement& corners = elements_[element];
  for (int i = 0; i < corner_count(corners); ++i) {
    std::vector<Index>& star = stars_[corners[i]];
    star.erase(std::find(star.begin(), star.end(), element));
  }
  corners = {no_index, no_index, no_index, no_index};
}

void QuadConnectivity::restore_element(Index element, const MeshElement& corners) {
  elements_[element] = corners;
  for (int i = 0; i < corner_count(corners); ++i) stars_[corners[i]].push_back(element);
}

void QuadConnectivity::remove_last_elements(Index count) {
  while (element_count() > count) {
    if (is_alive(element_count() - 1)) remove_element(element_count() - 1);
    elements_.pop_back();
  }
}

Index QuadConnectivity::element_with_edge(Index from, Index to) const {
  for (const Index e : stars_[from])
    if (corner_neighbours(elements_[e], from).first == to) return e;
  return no_index;
}

bool QuadConnectivity::has_boundary_edge(Index node) const {
  for (const Index e : stars_[node]) {
    const auto [next, previous] = corner_neighbours(elements_[e], node);
    if (element_with_edge(next, node) == no_index || element_with_edge(node, previous) == no_index)
      return true;
  }
  return false;
}

std::vector<Index> QuadConnectivity::neighbours(Index node) const {
  std::vector<Index> nodes;
  for (const Index e : stars_[node]) {
    const auto [next, previous] = corner_neighbours(elements_[e], node);
    nodes.push_back(next);
    nodes.push_back(previous);
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

}  // namespace beadmesh
