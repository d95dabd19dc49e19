// A slowly curving surface through a band of points and normals, to be continued beyond it.
#pragma once

#include <array>
#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh {

/// A point of a sheet and its unit normal there.
struct SheetContact {
  Vec3 point, normal;
};

/// A quadratic height field (least squares for points and normals) over the plane that the normals are
/// perpendicular to in the mean.
class QuadraticSheet {
 public:
  explicit QuadraticSheet(const std::vector<SheetContact>& contacts);

  /// Over the sheet along its mean normal, mm.
  double height(Vec3 point) const;
  /// Unit normal of the sheet under the point.
  Vec3 normal(Vec3 point) const;

 private:
  Vec2 plan(Vec3 point) const;

  Vec3 origin_, x_, y_, up_;
  double scale_ = 1;                      ///< half the extent of the contacts, mm
  std::array<double, 6> coefficients_{};  ///< of 1, x, y, xx, xy, yy in units of scale
};

}  // namespace beadmesh
