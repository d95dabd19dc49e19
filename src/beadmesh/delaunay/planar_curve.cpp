#include "beadmesh/delaunay/planar_curve.h"

#include <cmath>

namespace beadmesh {

CurvePoint CircularArc::at(double parameter) const {
  const Vec2 out = Vec2{std::cos(parameter), std::sin(parameter)} * radius_;
  return {centre_ + out, left_normal(out), -out};
}

}  // namespace beadmesh
