// What the faces do at the edges they share.
#pragma once

#include <limits>
#include <vector>

#include "beadmesh/panel/panel.h"

namespace beadmesh {

/// The largest over the segments of an edge. Infinite where the edge has not just two sides.
struct EdgeShape {
  double turn = std::numeric_limits<double>::infinity();  ///< between the normals of its two sides, radians
  double bend = std::numeric_limits<double>::infinity();  ///< of either side beside the edge, radians a mm
};

/// One for each edge of the panel.
std::vector<EdgeShape> edge_shapes(const Panel& panel);

}  // namespace beadmesh
