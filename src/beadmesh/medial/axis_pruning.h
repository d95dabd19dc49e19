// Noise and near-coincident junctions removed from the medial axis (section 3.5).
#pragma once

#include "beadmesh/medial/axis_graph.h"
#include "beadmesh/medial/boundary_curve.h"

namespace beadmesh {

/// What the boundary may lose at a sample: `fixed` where that is positive, else the noise or the bulge of the
/// facets.
class PruneTolerance {
 public:
  PruneTolerance(const BoundaryCurve& curve, const BoundarySamples& samples, double fixed)
      : curve_(curve), samples_(samples), fixed_(fixed) {}
  double at(Index sample) const;
  /// Whether a leaf is the centre of curvature at a vertex of an exact curve: a branch of the axis, however
  /// short.
  bool is_vertex(const Circle& disc, Sector sector) const;
  /// Without the facets' bulge.
  double noise() const;

 private:
  const BoundaryCurve& curve_;
  const BoundarySamples& samples_;
  double fixed_;
};

/// How far the disc `tip` reaches out of the disc `inner`: what the boundary would lose with it.
double protrusion(const Circle& tip, const Circle& inner);

/// Removes leaves, smallest protrusion first, while that is below the tolerance; never a corner.
void prune(AxisTriangles& axis, const PruneTolerance& tolerance);

/// Algorithm 3, junctions only, with union-find: makes two junctions one where the edge between them is
/// shorter than the noise; and, where `crossings` is set, where it has no wall of its own: it is shorter than
/// the local thickness and faces concave boundary of one loop on both sides (the crossing of an X).
void merge_junctions(AxisTriangles& axis, const BoundaryCurve& curve, const BoundarySamples& samples,
                     bool crossings, double noise);

/// Cuts smooth ends back by what is noise and puts them on the centre of the arc that they touch, where there
/// is one.
void settle_ends(AxisTriangles& axis, const BoundaryCurve& curve, const BoundarySamples& samples,
                 const PruneTolerance& tolerance);

}  // namespace beadmesh
