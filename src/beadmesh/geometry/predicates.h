// Signs of determinants of points in the plane, right for every input.
// Based on: Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates",
// 1997: a rounding-error bound settles almost every call, expansions of doubles the rest.
#pragma once

#include <cmath>

#include "beadmesh/core/vector.h"

namespace beadmesh {

namespace exact {
/// The same signs without the filter; slow.
double orient2d(Vec2 a, Vec2 b, Vec2 c);
double incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d);
}  // namespace exact

/// The predicates are exact while every coordinate is 0 or of a magnitude between these two: nothing under-
/// or overflows. Outside of it (and for NaN) they still return something.
inline constexpr double least_coordinate = 0x1p-200, greatest_coordinate = 0x1p200;

/// Whether both coordinates are finite and in the range in which the predicates are exact.
bool is_in_exact_range(Vec2 p);

/// Positive where a, b, c turn left, negative where they turn right, 0 where they are collinear. The sign is
/// exact, the value (twice the area of the triangle) is rounded.
inline double orient2d(Vec2 a, Vec2 b, Vec2 c) {
  constexpr double epsilon = 0x1p-53, bound = (3 + 16 * epsilon) * epsilon;
  const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
  const double determinant = left - right;
  if (std::abs(determinant) >= bound * (std::abs(left) + std::abs(right))) return determinant;
  return exact::orient2d(a, b, c);
}

/// Positive where d is inside the circle through a, b, c (given counter-clockwise; the sign turns round for a
/// clockwise triangle), negative outside, 0 on it. The sign is exact, the value is rounded.
inline double incircle(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  constexpr double epsilon = 0x1p-53, bound = (10 + 96 * epsilon) * epsilon;
  const Vec2 ad = a - d, bd = b - d, cd = c - d;
  const double bc1 = bd.x * cd.y, bc2 = cd.x * bd.y, a2 = squared_norm(ad);
  const double ca1 = cd.x * ad.y, ca2 = ad.x * cd.y, b2 = squared_norm(bd);
  const double ab1 = ad.x * bd.y, ab2 = bd.x * ad.y, c2 = squared_norm(cd);
  const double determinant = a2 * (bc1 - bc2) + b2 * (ca1 - ca2) + c2 * (ab1 - ab2);
  const double permanent = (std::abs(bc1) + std::abs(bc2)) * a2 + (std::abs(ca1) + std::abs(ca2)) * b2 +
                           (std::abs(ab1) + std::abs(ab2)) * c2;
  if (std::abs(determinant) > bound * permanent) return determinant;
  return exact::incircle(a, b, c, d);
}

/// What two closed segments have in common.
enum class SegmentContact {
  none,
  endpoint,     ///< an end of one is an end of the other, and nothing else
  touching,     ///< an end of one lies inside the other, and nothing else
  crossing,     ///< one point inside both
  overlapping,  ///< more than a point, or a segment of length 0 on the other
};

/// Exact classification of the segments a b and c d.
SegmentContact segment_contact(Vec2 a, Vec2 b, Vec2 c, Vec2 d);

/// Whether the closed segments have a point in common; exact.
inline bool segments_intersect(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return segment_contact(a, b, c, d) != SegmentContact::none;
}

}  // namespace beadmesh
