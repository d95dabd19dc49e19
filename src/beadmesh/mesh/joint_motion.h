// Nodes around elements that fail the usual criteria, moved together.
#pragma once

#include <vector>

#include "beadmesh/mesh/quad_connectivity.h"
#include "beadmesh/mesh/sliding_lines.h"
#include "beadmesh/mesh/surface_nodes.h"

namespace beadmesh {

struct JointMotionOptions {
  double size = 5;         ///< default 5 mm: target edge length
  double min_edge = 2.5;   ///< default 2.5 mm: no edge becomes shorter
  double shape = 0.7;      ///< default 0.7: scaled Jacobian that is given up for the other criteria
  double deviation = 0.4;  ///< default 0.4 mm: distance from the surface that is given up for them
  double crest = 0.1;      ///< default 0.1 mm: the same for edges on crests
};

/// Where moves of one node at a time get stuck: the free and sliding nodes within two rings of each element
/// that fails (warpage over 15 degrees, Jacobian at the Gauss points under 0.6, sides longer than two sizes,
/// corners beyond 40 and 140 degrees) move together, by a Levenberg-Marquardt method on what the elements
/// around them miss (Levenberg 1944, Marquardt 1963). Kept where fewer elements fail and no other limit is
/// broken further. Deterministic. Returns how many elements no longer fail.
int move_jointly(SurfaceNodes& nodes, const QuadConnectivity& mesh, const std::vector<NodeFreedom>& freedom,
                 SlidingLines& lines, const JointMotionOptions& options = {});
/// The same for a face without sliding nodes.
int move_jointly(PlanarMesh& mesh, const SurfaceMap* map, const JointMotionOptions& options = {});

}  // namespace beadmesh
