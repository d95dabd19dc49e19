// The corners of one element and their shape: the innermost loop of all node movement.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "beadmesh/mesh/surface_nodes.h"

namespace beadmesh {

/// Where the corners of an element are, coordinate by coordinate, so that all four are computed at once.
struct CornerPlaces {
  int count = 4;
  std::array<double, 4> x, y, z;  ///< on the surface; of the first `count` corners
  std::array<Vec2, 4> flat;

  void set(int corner, Vec2 in_plane, const Vec3& space) {
    x[corner] = space.x, y[corner] = space.y, z[corner] = space.z;
    flat[corner] = in_plane;
  }
  Vec3 space(int corner) const { return {x[corner], y[corner], z[corner]}; }
};

inline CornerPlaces places_of(const SurfaceNodes& nodes, const MeshElement& element) {
  CornerPlaces places;
  places.count = corner_count(element);
  for (int i = 0; i < places.count; ++i) places.set(i, nodes.flat(element[i]), nodes.space(element[i]));
  return places;
}

/// What element_quality.h calls jacobian_ratio: the determinant of a bilinear map is linear in both
/// parameters.
inline double evenness_of(const std::array<double, 4>& corner_areas) {
  const auto [a, b, c, d] = corner_areas;
  const double mean = (a + b + c + d) / 4;
  const double spread = (std::abs(b + c - a - d) + std::abs(c + d - a - b)) / (4 * std::sqrt(3.0));
  return mean + spread > 0 ? (mean - spread) / (mean + spread) : 0;
}

/// Scaled Jacobian per corner and length of the side that starts there.
struct CornerShapes {
  int count;
  std::array<double, 4> jacobian, side, area;  ///< of the first `count` corners
  double worst;

  /// Least over largest determinant at the Gauss points; 1 for triangles.
  double evenness() const { return count == 4 ? evenness_of(area) : 1; }
};

/// Of `count` corners, a number known to the compiler.
template <int count>
CornerShapes shapes_at(const CornerPlaces& p) {
  CornerShapes result;
  result.count = count;
  std::array<double, 4> sx, sy, sz;
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    sx[i] = p.x[next] - p.x[i], sy[i] = p.y[next] - p.y[i], sz[i] = p.z[next] - p.z[i];
  }
  for (int i = 0; i < count; ++i) result.side[i] = std::sqrt(sx[i] * sx[i] + sy[i] * sy[i] + sz[i] * sz[i]);
  const auto side = [&](int i) { return Vec3{sx[i], sy[i], sz[i]}; };
  const Vec3 normal =
      normalized(count == 4 ? cross(side(0) + side(1), side(1) + side(2)) : cross(side(0), side(1)));
  const double scale = count == 4 ? 1 : 2 / std::sqrt(3.0);
  std::array<double, 4> lengths;
  for (int i = 0; i < count; ++i) {
    const int before = (i + count - 1) % count;
    lengths[i] = result.side[i] * result.side[before];
    result.area[i] = dot(cross(side(before), side(i)), normal);
  }
  for (int i = 0; i < count; ++i) result.jacobian[i] = scale * result.area[i] / lengths[i];
  result.worst = std::numeric_limits<double>::infinity();
  for (int i = 0; i < count; ++i) {
    if (!(lengths[i] > 0)) result.jacobian[i] = 0;
    result.worst = std::min(result.worst, result.jacobian[i]);
  }
  return result;
}

inline CornerShapes shapes_of(const CornerPlaces& places) {
  return places.count == 4 ? shapes_at<4>(places) : shapes_at<3>(places);
}

/// Positive where the element is not turned over in the plane; else its area over the product of the
/// diagonals (or of two sides), in [-1, 0].
inline double flat_orientation(const CornerPlaces& places) {
  const auto& [a, b, c, d] = places.flat;
  const Vec2 p = places.count == 4 ? c - a : b - a;
  const Vec2 q = places.count == 4 ? d - b : c - a;
  const double area = cross(p, q);
  if (area > 0) return 1;
  const double scale = norm(p) * norm(q);
  return scale > 0 ? area / scale : 0;
}

/// Worst scaled Jacobian; below -1 where the element is turned over in the plane.
inline double signed_quality(const CornerPlaces& places) {
  const double orientation = flat_orientation(places);
  return orientation > 0 ? shapes_of(places).worst : orientation - 1;
}

}  // namespace beadmesh
