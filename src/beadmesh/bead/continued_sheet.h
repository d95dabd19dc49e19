// The sheet around a feature, continued under it.
#pragma once

#include <cstddef>

#include "beadmesh/geometry/quadratic_sheet.h"
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
  QuadraticSheet sheet_;
};

}  // namespace beadmesh
