// How the radius changes between two points of an edge.
#pragma once

#include "beadmesh/medial/medial_object.h"

namespace beadmesh {

/// The cubic through the radii of two points with their slopes. Along the axis the radius grows by minus the
/// cosine of the angle between the way and a foot, seen from the centre; so the slopes are known at every
/// point that has its feet on its circle. Elsewhere (corners, merged junctions) the cubic is of lower degree.
class RadiusAlong {
 public:
  RadiusAlong(const MedialPoint& from, const MedialPoint& to);

  double at(double part) const;
  double least() const;
  double greatest() const;
  /// Mean over the length.
  double mean() const;

 private:
  double r0_, r1_, m0_, m1_;  // radii and slopes per part
};

}  // namespace beadmesh
