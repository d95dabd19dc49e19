// Topological edits of a quad mesh as transactions: elements out, elements in, local smoothing, kept only
// where better.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "beadmesh/mesh/node_motion.h"

namespace beadmesh {

/// An edit: the elements of a disc are exchanged for others with the same outline.
struct Replacement {
  std::vector<Index> removed;
  std::vector<Vec2> new_nodes;  ///< positions of nodes node_count(), node_count() + 1, ...
  std::vector<MeshElement> added;
  std::vector<std::pair<Index, Vec2>> moved;  ///< nodes that start from another place
};

struct EditorLimits {
  double size = 5, min_edge = 2.5;
  double good_enough = 0.6;  ///< an edit may lower the worst scaled Jacobian around it down to this
};

/// What an edit must achieve to be kept.
enum class EditAim {
  fewer_irregular,  ///< the sum of penalties falls, shape and size do not suffer
  longer_edges,     ///< edges below the minimum get fewer
  better_shape,     ///< the worst scaled Jacobian around rises clearly
  fewer_triangles,  ///< for edits that marry triangles: nothing but sound shapes
};

/// The mesh under edit. All calls leave it conforming.
class MeshEditor {
 public:
  MeshEditor(PlanarMesh& mesh, const SurfaceMap* map, const std::vector<std::array<Index, 2>>& kept_edges,
             const EditorLimits& limits);

  const QuadConnectivity& mesh() const { return mesh_; }
  const SurfaceNodes& nodes() const { return nodes_; }
  const EditorLimits& limits() const { return limits_; }
  bool is_boundary(Index node) const { return boundary_[node]; }
  bool is_free(Index node) const { return freedom_[node] == NodeFreedom::free; }
  bool is_kept_edge(Index a, Index b) const;

  /// How far `valence` elements are from what the node's angle asks for: 0 for four at an inner node, 1 for
  /// three or five, growing quickly beyond; at the boundary by the angle (a straight line asks for two).
  double penalty(Index node, int valence) const;
  double penalty(Index node) const { return penalty(node, mesh_.valence(node)); }
  bool is_irregular(Index node) const { return penalty(node) > 0.6 && !mesh_.star(node).empty(); }
  /// Nodes without exactly four quads, boundary left out.
  int count_irregular() const;
  int count_triangles() const;

  /// Makes the edit, smooths around it, judges, and undoes it where it is not worth it. `touched` gets the
  /// nodes around a kept edit.
  bool try_replace(const Replacement& edit, EditAim aim, std::vector<Index>& touched);

  /// Writes the mesh back without the nodes that are gone; fixed nodes in front keep their numbers.
  /// Returns the new number per old node, no_index for those that are gone.
  std::vector<Index> write_back(PlanarMesh& mesh) const;

 private:
  struct Judgement {
    double penalty = 0;   ///< of the nodes
    double worst = 1;     ///< scaled Jacobian
    double shortage = 0;  ///< what edges miss to the minimum length
    double excess = 0;    ///< what edges have beyond twice the size, nearly
    double energy = 0;    ///< shape and size, weighted by area, so that few and many elements compare
  };
  struct Undo {
    std::vector<std::pair<Index, MeshElement>> removed;
    std::vector<std::pair<Index, SurfacePlace>> places;
    Index element_count = 0, node_count = 0;
  };

  std::vector<Index> corners_of(const std::vector<MeshElement>& elements) const;
  bool respects_kept_edges(const std::vector<MeshElement>& before,
                           const std::vector<MeshElement>& after) const;
  void apply(const Replacement& edit, Undo& undo);
  void roll_back(const Undo& undo);
  bool is_sound(const std::vector<MeshElement>& before, const std::vector<MeshElement>& after,
                const std::vector<Index>& rim) const;
  std::vector<Index> zone_around(const std::vector<Index>& nodes) const;
  Judgement judge(const std::vector<Index>& nodes, const std::vector<Index>& zone) const;
  bool is_better(const Judgement& after, const Judgement& before, EditAim aim) const;
  std::vector<Index> elements_around(const std::vector<Index>& nodes, const std::vector<Index>& zone) const;
  double reachable(const std::vector<Index>& elements) const;
  double wanted_worst(const Judgement& before, EditAim aim) const;
  bool is_hopeless(const Judgement& now, const Judgement& before, double share) const;
  bool smooth_zone(const std::vector<Index>& zone, const std::function<bool()>& is_hopeless);

  EditorLimits limits_;
  SurfaceNodes nodes_;
  QuadConnectivity mesh_;
  std::vector<NodeFreedom> freedom_;
  std::vector<bool> boundary_;
  std::vector<double> angle_;  ///< per node: what the elements around it have to fill, in right angles
  std::vector<std::array<Index, 2>> kept_edges_;
  SlidingLines no_lines_;
  NodeMotion motion_;
};

}  // namespace beadmesh
