// The medial object of a face of the panel, in the flattened plane and on the surface.
#pragma once

#include <array>
#include <vector>

#include "beadmesh/delaunay/planar_region.h"
#include "beadmesh/medial/medial_object.h"

namespace beadmesh {

/// The medial object of a face. The 3-D points lie on the surface; a plane polygon is its own surface, [u, v,
/// 0]. Either kind of feet may be left out (empty): then they are known in the plane only.
struct FaceMedial {
  Index face = 0;       ///< 1-based number
  PlanarRegion region;  ///< the flattened boundary
  MedialObject object;
  std::vector<Vec3> vertex_points;                          ///< per vertex
  std::vector<std::vector<Vec3>> edge_points;               ///< per edge and point
  std::vector<std::vector<Vec3>> vertex_feet;               ///< per vertex and touching point
  std::vector<std::vector<std::array<Vec3, 2>>> edge_feet;  ///< per edge and point: left, right
};

}  // namespace beadmesh
