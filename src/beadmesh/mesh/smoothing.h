// Node movement on the surface (references 33 and 34 of the paper), with hard guards.
#pragma once

#include "beadmesh/flatten/flat_face.h"
#include "beadmesh/mesh/planar_mesh.h"
#include "beadmesh/mesh/sliding_lines.h"

namespace beadmesh {

struct SmoothingOptions {
  double size = 5;        ///< default 5 mm: target edge length on the surface
  double min_edge = 2.5;  ///< default 2.5 mm: no move may add to what the node's edges miss to it
  int variational_passes =
      20;  ///< default 20: Winslow / isoparametric / length-weighted Laplace sweeps at most
  int optimisation_passes = 10;  ///< default 10: sweeps over the worst elements at most
  int surface_passes = 0;        ///< default 0: sweeps that bring the elements nearer to the surface and take
                                 ///< warpage away
  double hopeless =
      -2;  ///< default -2 = never: worst scaled Jacobian under which surface passes are left out
  double flat_floor = 0.858;  ///< default 0.858: scaled Jacobian that is given up for less warpage
  /// Default: evenness counts as well. Where the worst shape is what is looked for, angles alone.
  enum class Aim { angles_and_evenness, angles } aim = Aim::angles_and_evenness;
  double hopeless_when_near =
      -2;  ///< default -2 = never: the same as `hopeless`, after the first surface passes
};

struct SmoothingReport {
  double scaled_jacobian_min = 0, scaled_jacobian_mean = 0;  ///< on the surface
  int inverted = 0;
  int edges_below_min = 0;
  bool given_up = false;  ///< shape under SmoothingOptions::hopeless or hopeless_when_near
  double deviation = 0;   ///< largest distance seen between elements and surface; 0 without surface passes
};

/// Moves free nodes in the flat plane, measures on the surface (3-D positions through `map`; null: the
/// plane). First untangles what is inverted, then the variational pass, then the optimisation of the worst
/// (mean ratio and shortest edge, line search), last, where asked for, the distance of the elements from the
/// surface. Sliding nodes move along `lines` and stay between their neighbours there; the lines take over
/// their new places. Fixed nodes stay. Deterministic.
SmoothingReport smooth(PlanarMesh& mesh, const SurfaceMap* map, std::vector<SlidingLine>& lines,
                       const SmoothingOptions& options = {});
/// Without lines.
SmoothingReport smooth(PlanarMesh& mesh, const SurfaceMap* map, const SmoothingOptions& options = {});

}  // namespace beadmesh
