// A polyline with its arc lengths, in the plane or in space.
#pragma once

#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh {

/// The point of segment a b that is nearest to p, as the parameter in [0, 1]; 0 for a segment of length 0.
double nearest_parameter(Vec2 a, Vec2 b, Vec2 p);
double nearest_parameter(Vec3 a, Vec3 b, Vec3 p);

/// V is Vec2 or Vec3.
template <class V>
class Polyline {
 public:
  struct Nearest {
    V point;
    double position = 0;  ///< arc length from the first point
    double distance = 0;
  };

  /// At least one point. `closed`: a last segment leads back to the first point (which is not repeated).
  explicit Polyline(std::vector<V> points, bool closed = false);

  const std::vector<V>& points() const { return points_; }
  bool is_closed() const { return closed_; }
  double length() const { return positions_.back(); }
  Index segments() const { return static_cast<Index>(positions_.size()) - 1; }
  /// Arc length from the first point to point i; i == segments() is the end.
  double position(Index i) const { return positions_[i]; }
  /// The segment at an arc length: clamped to the ends, or taken round for a closed one. -1 without segments.
  Index segment_at(double position) const;
  V point_at(double position) const;
  /// Unit direction of the segment at an arc length; zero where it has no length.
  V direction_at(double position) const;
  /// `parts` + 1 points equally far from each other along an open polyline, its ends included; `parts` points
  /// from the first one on along a closed one.
  std::vector<V> resampled(Index parts) const;
  /// Nearest point by a look at every segment, O(n); the first one of several.
  Nearest nearest(V p) const;

 private:
  double wrapped(double position) const;
  V end(Index segment) const { return points_[segment + 1 < points_.size() ? segment + 1 : 0]; }

  std::vector<V> points_;
  std::vector<double> positions_;
  bool closed_;
};

extern template class Polyline<Vec2>;
extern template class Polyline<Vec3>;

}  // namespace beadmesh
