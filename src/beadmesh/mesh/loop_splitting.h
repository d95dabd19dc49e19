// One loop split recursively down to templates and mapped areas. Internal to the room.
#pragma once

#include "beadmesh/mesh/mesh_draft.h"
#include "beadmesh/mesh/node_loop.h"

namespace beadmesh {

/// Weights of the terms of a line's cost against its four angles, each of which counts 1 for 45 degrees off.
struct SplitWeights {
  double misfit = 4;         ///< squared logarithm of the edge length against the wanted one
  double closure = 0.15;     ///< per lattice step by which the walks around the parts fail to close
  double singularity = 0.3;  ///< per irregular node that the line adds to what the parts need
  double length = 0.1;       ///< per edge of the line
  double balance = 0.3;      ///< parts of very unequal counts
};

/// Angle cost of a line that leaves an interior angle `whole` at `part` from one of its sides: 0 where both
/// parts are multiples of 90 degrees, 1 for every 45 degrees off (squared). Negative where the line leaves
/// the angle.
double split_angle_cost(double whole, double part);
/// Cost of `edges` edges on a line that should have `wanted`.
double misfit_cost(double wanted, int edges);

/// Fills the closed loop with quads (and one triangle if its count is odd). After Talbert and Parkinson,
/// "Development of an automatic, two-dimensional finite element mesh generator using quadrilateral elements
/// and Bezier curve boundary definition", 1990, with the lattice walk (node_loop.h) as a further term: it
/// sees which lines leave regular parts.
void fill_by_splitting(MeshDraft& draft, const NodeLoop& loop, const SplitWeights& weights = {});

}  // namespace beadmesh
