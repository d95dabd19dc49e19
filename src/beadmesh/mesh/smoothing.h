// Node movement on the surface (references 33 and 34 of the paper), with hard guards.
#pragma once

#include "beadmesh/flatten/flat_face.h"
#include "beadmesh/mesh/planar_mesh.h"

namespace beadmesh {

struct SmoothingOptions {
  double size = 5;        ///< default 5 mm: target edge length on the surface
  double min_edge = 2.5;  ///< default 2.5 mm: no move may add to what the node's edges miss to it
  int variational_passes =
      20;  ///< default 20: Winslow / isoparametric / length-weighted Laplace sweeps at most
  int optimisation_passes = 10;  ///< default 10: sweeps over the worst elements at most
};

struct SmoothingReport {
  double scaled_jacobian_min = 0, scaled_jacobian_mean = 0;  ///< on the surface
  int inverted = 0;
  int edges_below_min = 0;
};

/// Moves free nodes in the flat plane, measures on the surface (3-D positions through `map`; null: the
/// plane). First untangles what is inverted, then the variational pass, then the optimisation of the worst
/// (mean ratio and shortest edge, line search). Crest nodes move along `crest_lines` (polylines of node
/// indices: the node stays between its neighbours on the polyline of the original positions). Fixed nodes
/// stay. Deterministic.
SmoothingReport smooth(PlanarMesh& mesh, const SurfaceMap* map,
                       const std::vector<std::vector<Index>>& crest_lines,
                       const SmoothingOptions& options = {});

}  // namespace beadmesh
