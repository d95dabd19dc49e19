// Inside the read room: a smooth closed curve along a skin, and on which side of it a point lies.
#pragma once

#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh {

/// Where a point lies from an outline.
struct OutlinePlace {
  Vec3 nearest;         ///< of the curve
  double distance = 0;  ///< to it, mm
  double inside = 0;    ///< along the sheet, mm; positive on the left
  double height = 0;    ///< over the sheet at the nearest point, mm
};

/// A closed polyline with the normal of the sheet at each point.
class OutlineCurve {
 public:
  OutlineCurve(std::vector<Vec3> points, std::vector<Vec3> normals);

  OutlinePlace place(Vec3 point) const;

 private:
  struct Box {
    Vec3 low, high;
  };

  Vec3 at(std::size_t i) const { return points_[i % points_.size()]; }
  Vec3 along(std::size_t segment) const;

  std::vector<Vec3> points_, normals_;
  std::vector<Box> boxes_;  ///< of runs of segments
};

}  // namespace beadmesh
