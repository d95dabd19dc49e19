// What counts as equal, as touching and as too short on a face.
#pragma once

#include "beadmesh/delaunay/planar_region.h"

namespace beadmesh {

/// Lengths, from the size of the face and from how many digits its coordinates leave.
struct Tolerances {
  double rounding =
      0;               ///< of a distance: 1e-12 of the size, or 16 units of the last place of the coordinates
  double contact = 0;  ///< what is nearer touches, and points are one: 1e-9 of the size, or 16 roundings
  double chord = 0;  ///< of an edge's polyline to the axis: 0.5e-7 of the size; measured in the middle of its
                     ///< lines, where they need not be the furthest off, so that half of 1e-7 is kept back
  double segment = 0;  ///< shortest segment that sampling makes: 1e-5 of the size
  double leg =
      0;  ///< the same at a corner that is nearly flat, whose triangle is as small: 1e-10 of the size
};

Tolerances tolerances_of(const PlanarRegion& region);

}  // namespace beadmesh
