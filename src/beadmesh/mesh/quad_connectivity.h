// Elements around nodes, kept up to date while elements come and go.
#pragma once

#include <utility>
#include <vector>

#include "beadmesh/mesh/planar_mesh.h"

namespace beadmesh {

/// Elements and, per node, the elements around it. Removed elements leave a hole (first corner no_index) that
/// is not used again, so that an edit can be undone by its numbers.
class QuadConnectivity {
 public:
  explicit QuadConnectivity(const PlanarMesh& mesh);

  Index element_count() const { return static_cast<Index>(elements_.size()); }
  Index node_count() const { return static_cast<Index>(stars_.size()); }
  bool is_alive(Index element) const { return elements_[element][0] != no_index; }
  const MeshElement& element(Index element) const { return elements_[element]; }
  /// Elements around a node in no particular but reproducible order.
  const std::vector<Index>& star(Index node) const { return stars_[node]; }
  int valence(Index node) const { return static_cast<int>(stars_[node].size()); }

  Index add_node();
  Index add_element(const MeshElement& element);
  void remove_element(Index element);
  /// Undo of an edit: puts a removed element back; drops elements or nodes (without elements) from `count`
  /// on.
  void restore_element(Index element, const MeshElement& corners);
  void remove_last_elements(Index count);
  void remove_last_nodes(Index count) { stars_.resize(count); }

  /// The element that has the directed edge from -> to, or no_index.
  Index element_with_edge(Index from, Index to) const;
  /// True where an edge at the node has one element only. Edits keep the boundary, so this is asked once per
  /// node.
  bool has_boundary_edge(Index node) const;
  /// The nodes joined to `node` by an edge, ascending.
  std::vector<Index> neighbours(Index node) const;

 private:
  std::vector<MeshElement> elements_;
  std::vector<std::vector<Index>> stars_;
};

/// Position of `node` among the corners; it must be one.
inline int corner_of(const MeshElement& element, Index node) {
  int i = 0;
  while (i < 3 && element[i] != node) ++i;
  return i;
}
/// Corners after and before `node`.
inline std::pair<Index, Index> corner_neighbours(const MeshElement& element, Index node) {
  const int last = corner_count(element) - 1, i = corner_of(element, node);
  return {element[i == last ? 0 : i + 1], element[i == 0 ? last : i - 1]};
}

}  // namespace beadmesh
