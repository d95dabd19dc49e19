// Movement of single nodes: the kernel of the smoothing and of the local smoothing after topological edits.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "beadmesh/mesh/node_star.h"
#include "beadmesh/mesh/quad_connectivity.h"
#include "beadmesh/mesh/sliding_lines.h"
#include "beadmesh/mesh/surface_nodes.h"

namespace beadmesh {

struct MotionLimits {
  double size = 5;
  double min_edge = 2.5;
  double floor = 0.7;        ///< scaled Jacobians above it may be traded against each other
  double flat_floor = 0.85;  ///< the same for MotionAim::flat
  double aim = 0;            ///< what falls short of this scaled Jacobian is driven towards it; 0: nothing
};

/// What an optimisation step is after; `even`: worst shapes and evenness; `surface`: shape and the elements'
/// distance from the surface; `flat`: these and their warpage.
enum class MotionAim { mean, worst, even, edges, surface, flat };

/// How good one element is: scaled Jacobian on the surface; where the element is turned over in the plane,
/// below -1.
double signed_quality(const SurfaceNodes& nodes, const MeshElement& element);

/// Least over largest determinant at the Gauss points (element_quality.h); 1 for triangles.
double evenness(const SurfaceNodes& nodes, const MeshElement& element);

/// Moves one node at a time. Keeps references to all it is given. Copies work on the same mesh, each with
/// scratch memory of its own: nodes without a common element may be moved by several of them at once.
class NodeMotion {
 public:
  NodeMotion(SurfaceNodes& nodes, const QuadConnectivity& mesh, const std::vector<NodeFreedom>& freedom,
             SlidingLines& lines, const MotionLimits& limits)
      : nodes_(nodes),
        mesh_(mesh),
        freedom_(freedom),
        lines_(lines),
        limits_(limits),
        facet_hints_(std::make_shared<std::vector<Index>>()) {}

  bool is_movable(Index node) const {
    return freedom_[node] == NodeFreedom::free ||
           (freedom_[node] == NodeFreedom::sliding && lines_.slides(node));
  }
  /// Least scaled Jacobian around the node.
  double worst_around(Index node) const;
  /// Least evenness around the node.
  double evenness_around(Index node) const;
  /// Largest shortfall of an edge at the node below the minimum edge length, as a share of it; 0: none.
  double shortfall(Index node) const;

  /// Largest distance from the surface of the elements and edges around the node, where it is looked at.
  double deviation(Index node) const;

  /// Makes the corner areas in the plane positive that the node takes part in (Knupp 2001: a convex problem
  /// per node).
  bool untangle(Index node);
  /// Variational step: Winslow on four quads, isoparametric on other fans of quads, length-weighted at
  /// triangles.
  bool relax(Index node);
  /// One Newton step with line search on the shape and edge-length objective.
  bool optimise(Index node, MotionAim aim);
  /// Makes room for what is remembered about the surface; before the first look at it.
  void prepare_for_surface();
  /// Distance in the plane that the last successful step covered.
  double last_step() const { return last_step_; }

 private:
  struct State {
    double cost = 0, worst = 0, shortage = 0, deviation = 0;
  };
  void gather(Index node, MotionAim aim) const;
  State measure(MotionAim aim) const;
  void add_deviations(MotionAim aim, State& state) const;
  double floor_of(const State& before, MotionAim aim) const;
  template <class Visit>
  void visit_deviations(Visit visit) const;
  Vec3 surface_at(Vec2 flat, Index element, int slot) const;
  std::array<Vec3, 2> surface_along(const StarElement& element, int side, Vec2 node, Vec2 end) const;
  double cost_at(const SurfacePlace& place, MotionAim aim);
  bool keep_if_better(Index node, const SurfacePlace& place, const State& before, MotionAim aim);
  bool optimise_free(Index node, MotionAim aim);
  bool optimise_sliding(Index node, MotionAim aim);
  bool fan(Index node, std::vector<Index>& sides, std::vector<Index>& diagonals) const;
  Vec2 winslow(std::span<const Index> sides, std::span<const Index> diagonals) const;
  Vec2 isoparametric(std::span<const Index> sides, std::span<const Index> diagonals) const;
  Vec2 length_weighted(Index node) const;

  SurfaceNodes& nodes_;
  const QuadConnectivity& mesh_;
  const std::vector<NodeFreedom>& freedom_;
  SlidingLines& lines_;
  MotionLimits limits_;
  double last_step_ = 0;
  std::vector<Index> sides_, diagonals_;

  mutable NodeStar star_;  ///< of the node looked at
  /// Places on an edge are looked up once, though two elements share them: per edge of the star.
  mutable std::vector<std::array<Vec3, 2>> along_edges_;
  /// Facets where the places of each element were last found.
  std::shared_ptr<std::vector<Index>> facet_hints_;
};

}  // namespace beadmesh
