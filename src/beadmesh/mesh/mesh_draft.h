// The growing mesh that the stages of the subdivision mesher share. Internal to the room.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "beadmesh/mesh/subdivision_mesher.h"

namespace beadmesh {

/// First fundamental form of the surface over the plane, for lengths of short flat vectors.
struct SurfaceMetric {
  double xx = 1, xy = 0, yy = 1;
};

class MeshDraft {
 public:
  /// A state of the draft to which it can go back.
  struct Mark {
    std::size_t nodes = 0, elements = 0, edges = 0;
  };
  /// What was added since a mark.
  struct Piece {
    std::vector<Vec2> nodes;
    std::vector<SurfaceMetric> metrics;
    std::vector<double> spacing;
    std::vector<MeshElement> elements;
  };

  /// Takes the loops' nodes over, with their metric and their spacing (mean length of the loop edges at a
  /// node).
  MeshDraft(const NodeLoops& loops, const SurfaceMap* map, double size);
  /// The draft of an area: the given nodes of another draft, ascending, numbered from 0. It asks the other
  /// for edges between them, so that must live on and stay as it is.
  MeshDraft(const MeshDraft& whole, std::vector<Index> nodes);

  const std::vector<Vec2>& nodes() const { return nodes_; }
  const std::vector<MeshElement>& elements() const { return elements_; }
  const Vec2& at(Index node) const { return nodes_[node]; }
  const SurfaceMetric& metric(Index node) const { return metrics_[node]; }
  double size() const { return size_; }
  /// The smaller of the size and the spacings at two nodes: what clearances are measured against.
  double scale(Index a, Index b) const { return std::min({size_, spacing_[a], spacing_[b]}); }

  Index add_node(Vec2 position);
  void move_node(Index node, Vec2 position) { nodes_[node] = position; }
  void add_edge(Index a, Index b) {
    if (edges_.insert(key(a, b)).second) edge_order_.push_back(key(a, b));
  }
  bool has_edge(Index a, Index b) const {
    return edges_.count(key(a, b)) > 0 ||
           (whole_ && a < given_nodes() && b < given_nodes() && whole_->has_edge(of_whole_[a], of_whole_[b]));
  }
  /// Adds the element and its edges.
  void add_element(const MeshElement& element);

  /// Length on the surface of the straight flat line between two nodes.
  double surface_length(Index a, Index b) const;
  /// How many edges the line should have (a real number), graded from the spacing at its ends to the size.
  double edge_count(Index a, Index b) const;
  /// Nodes a .. b of a line of `edges` edges, graded likewise, with its edges entered.
  std::vector<Index> add_line(Index a, Index b, int edges);

  Mark mark() const { return {nodes_.size(), elements_.size(), edge_order_.size()}; }
  /// Takes back what was added since the mark, and returns it.
  Piece take_back(const Mark& mark);
  /// Adds a piece again; the draft must be in the state of its mark.
  void put(const Piece& piece);
  /// Adds a piece of an area's draft; `nodes` are those that the area was given.
  void put(Piece piece, const std::vector<Index>& nodes);
  /// Number of elements at a node.
  int valence(Index node) const { return valences_[node]; }
  /// Nodes of the loops; they are the first ones.
  Index fixed_nodes() const { return fixed_nodes_; }

  PlanarMesh take() &&;

 private:
  Index given_nodes() const { return static_cast<Index>(of_whole_.size()); }
  static std::uint64_t key(Index a, Index b) {
    const auto low = static_cast<std::uint32_t>(a < b ? a : b),
               high = static_cast<std::uint32_t>(a < b ? b : a);
    return (static_cast<std::uint64_t>(high) << 32) | low;
  }
  double spacing_along(Index a, Index b, double length, double at) const;
  SurfaceMetric sample(Vec2 position);

  const SurfaceMap* map_;
  double size_;
  const MeshDraft* whole_ = nullptr;
  std::vector<Index> of_whole_;  ///< of an area: its first nodes in the numbers of the whole
  Index hint_ = no_index, fixed_nodes_ = 0;
  std::vector<Vec2> nodes_;
  std::vector<SurfaceMetric> metrics_;
  std::vector<double> spacing_;
  std::vector<int> valences_;
  std::vector<MeshElement> elements_;
  std::vector<std::uint64_t> edge_order_;
  std::unordered_set<std::uint64_t> edges_;  // asked for membership only: its order never matters
};

}  // namespace beadmesh
