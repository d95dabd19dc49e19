// Polylines drawn in the flat plane and measured on the surface.
#pragma once

#include <vector>

#include "beadmesh/core/vector.h"
#include "beadmesh/flatten/flat_face.h"

namespace beadmesh {

/// Arc length on the surface at parameter t in [0, 1] of a flat polyline, and back. t is the share of the
/// flat length.
class SurfacePolyline {
 public:
  /// Sampled at least 16 times and at every point.
  SurfacePolyline(const std::vector<Vec2>& flat, const SurfaceMap& map);

  double length() const { return surface_.back(); }
  /// Flat point at an arc length on the surface.
  Vec2 point_at(double arc_length) const;
  /// Share of the flat length there.
  double flat_share_at(double arc_length) const;

 private:
  std::vector<Vec2> points_;
  std::vector<double> flat_, surface_;
};

}  // namespace beadmesh
