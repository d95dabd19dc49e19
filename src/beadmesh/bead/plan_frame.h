// A small piece of a flattened face seen from above: the flat plane bends what is straight in space.
#pragma once

#include "beadmesh/core/vector.h"
#include "beadmesh/flatten/flat_face.h"

namespace beadmesh {

/// Looks along `up` (unit) at the surface around a flat point. Without a map the flat plane is the surface.
class PlanFrame {
 public:
  PlanFrame(const SurfaceMap* map, Vec2 around, Vec3 up);

  Vec2 to_plan(Vec2 flat) const;
  /// Height over the plane through the point looked at; 0 without a map.
  double height(Vec2 flat) const;
  /// Flat point whose image is `plan` (Newton from `guess`, five steps).
  Vec2 to_flat(Vec2 plan, Vec2 guess) const;

 private:
  const SurfaceMap* map_;
  Vec3 origin_, x_, y_, up_;
  double step_ = 1e-3;
};

}  // namespace beadmesh
