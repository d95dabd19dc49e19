// The plane layout of a triangulation that is as rigid as possible.
#pragma once

#include <memory>
#include <vector>

#include "beadmesh/flatten/triangle_geometry.h"

namespace beadmesh {

/// ARAP energy of Liu, Zhang, Xu, Gotsman, Gortler 2008, "A local/global approach to mesh parameterization":
/// sum over triangles of cot(angle) |image edge - rotation * rest edge|^2. The local step finds the best
/// rotation of every triangle, the global step is one solve with a matrix that is factored once.
///
/// The matrix is the finite-element Laplacian: positive semi-definite whatever the angles are, obtuse ones
/// included. A sliver is weakened as a whole (its area is taken as if it were thicker), never a single
/// cotangent of it.
class RigidLayout {
 public:
  RigidLayout(std::size_t point_count, const std::vector<Triangle>& triangles,
              std::vector<RestTriangle> rest);
  ~RigidLayout();

  /// False where the factorisation failed.
  bool is_ready() const;

  /// Unit complex number per triangle: the rotation of the rest triangle closest to its image. Adds up the
  /// energy.
  std::vector<Vec2> rotations(const std::vector<Vec2>& positions, double* energy = nullptr) const;

  /// Positions whose triangles come closest to the turned rest triangles (least squares). Vertex 0 is at the
  /// origin.
  std::vector<Vec2> assembled(const std::vector<Vec2>& rotations) const;

  /// Alternates both steps until no point moves by more than `tolerance`, at most `iterations` times.
  /// Accelerated by Anderson mixing as in Peng et al. 2018 ("Anderson acceleration for geometry
  /// optimization"): long strips bend slowly without. A mixed step that raises the energy is replaced by the
  /// plain one.
  std::vector<Vec2> relaxed(std::vector<Vec2> positions, int iterations, double tolerance) const;

  /// The same from a start without turned-over triangles, with steps so short that none turns over.
  std::vector<Vec2> relaxed_without_flips(std::vector<Vec2> positions, int iterations,
                                          double tolerance) const;

 private:
  struct System;
  std::unique_ptr<System> system_;
};

}  // namespace beadmesh
