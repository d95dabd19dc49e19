// Exact curves under the boundary of a plane region.
#pragma once

#include "beadmesh/core/vector.h"

namespace beadmesh {

/// A point of a curve and its first two derivatives by the parameter.
struct CurvePoint {
  Vec2 point, velocity, acceleration;
};

/// A regular, twice differentiable curve in the plane. Const calls are safe from several threads.
class PlanarCurve {
 public:
  virtual ~PlanarCurve() = default;
  virtual CurvePoint at(double parameter) const = 0;
};

/// Part of a circle; the parameter is the angle from the x axis in radians.
class CircularArc final : public PlanarCurve {
 public:
  CircularArc(Vec2 centre, double radius) : centre_(centre), radius_(radius) {}
  CurvePoint at(double parameter) const override;
  Vec2 centre() const { return centre_; }
  double radius() const { return radius_; }

 private:
  Vec2 centre_;
  double radius_;
};

}  // namespace beadmesh
