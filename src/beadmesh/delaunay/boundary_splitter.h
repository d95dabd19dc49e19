// New samples in a triangulated boundary, the triangulation kept constrained Delaunay.
#pragma once

#include <vector>

#include "beadmesh/delaunay/boundary_samples.h"
#include "beadmesh/delaunay/triangulation.h"

namespace beadmesh {

/// Splits boundary edges one at a time. A sample is known by the number that it got when it came: the given
/// ones by their places, the new ones after them. An edge of the boundary is known by the sample that it
/// starts from. Based on: Lawson's flips (1977) about the new point.
class BoundarySplitter {
 public:
  /// Triangle corners must be places in `samples`.
  BoundarySplitter(BoundarySamples samples, Triangulation triangulation);

  const BoundarySample& sample(Index i) const { return samples_.samples[i]; }
  Index count() const { return static_cast<Index>(samples_.samples.size()); }
  /// Number of samples at the beginning, and where each loop's began (one more at the end).
  Index given() const { return samples_.first.back(); }
  const std::vector<Index>& firsts() const { return samples_.first; }
  Index next(Index i) const { return next_[i]; }
  Index previous(Index i) const { return previous_[i]; }
  /// The corner of the edge's triangle that is opposite of it.
  Index apex(Index edge) const;
  /// Whether the edges before and after the sample have one triangle.
  bool is_ear(Index i) const { return half_edge_[i] / 3 == half_edge_[previous_[i]] / 3; }

  /// Puts a sample on the edge. Its point may lie off the edge, but must keep both new triangles the right
  /// way round: else `on_chord` is tried, and where that fails too nothing is done. Returns the new sample's
  /// number, or no_index. Appends to `touched` the boundary edges that are new or got another triangle.
  Index split(Index edge, const BoundarySample& added, Vec2 on_chord, std::vector<Index>& touched);

  /// Hands samples and triangulation back, in loop order. The splitter is empty then.
  void finish(BoundarySamples& samples, Triangulation& triangulation);

 private:
  bool fits(Vec2 p, Index edge) const;
  void attach(Index half_edge, Index other);
  void legalise(Index half_edge, std::vector<Index>& touched);
  void flip(Index half_edge, Index other);

  Index corner(Index half_edge) const { return triangulation_.triangles[half_edge / 3][half_edge % 3]; }
  Index start(Index half_edge) const {
    return triangulation_.triangles[half_edge / 3][(half_edge % 3 + 1) % 3];
  }
  Index opposite(Index half_edge) const;

  BoundarySamples samples_;
  Triangulation triangulation_;
  std::vector<Index> next_, previous_;
  std::vector<Index> half_edge_;  // per sample: 3 t + slot of the boundary edge that starts there
  std::vector<Index> pending_;
};

}  // namespace beadmesh
