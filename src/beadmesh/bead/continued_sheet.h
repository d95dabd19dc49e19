// The sheet around a feature, continued under it.
#pragma once

#include <array>
#include <cstddef>

#include "beadmesh/panel/facets.h"

namespace beadmesh {

/// A quadratic height field that touches a face along one of its loops (least squares for points and
/// normals).
class ContinuedSheet {
 public:
  ContinuedSheet(const Facets& sheet, std::size_t loop);

  /// Over the continued sheet along its mean normal at the loop, mm.
  double height(Vec3 point) const;
  /// Unit normal of the continued sheet under the point.
  Vec3 normal(Vec3 point) const;

 private:
  Vec2 plan(Vec3 point) const;

  Vec3 origin_, x_, y_, up_;
  double scale_ = 1;                      ///< half the loop's extent, mm
  std::array<double, 6> coefficients_{};  ///< of 1, x, y, xx, xy, yy in units of scale
};

}  // namespace beadmesh
