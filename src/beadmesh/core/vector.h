// Small vectors of the plane and of space. Values, no allocation, no hidden state.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace beadmesh {

/// Index of an item in an array of the same object; `no_index` where there is none.
using Index = std::int32_t;
inline constexpr Index no_index = -1;

struct Vec2 {
  double x = 0, y = 0;
  friend bool operator==(const Vec2&, const Vec2&) = default;
};

struct Vec3 {
  double x = 0, y = 0, z = 0;
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

inline Vec2 operator+(Vec2 a, Vec2 b) {
  return {a.x + b.x, a.y + b.y};
}
inline Vec2 operator-(Vec2 a, Vec2 b) {
  return {a.x - b.x, a.y - b.y};
}
inline Vec2 operator-(Vec2 a) {
  return {-a.x, -a.y};
}
inline Vec2 operator*(Vec2 a, double s) {
  return {a.x * s, a.y * s};
}
inline Vec2 operator*(double s, Vec2 a) {
  return a * s;
}
inline Vec2 operator/(Vec2 a, double s) {
  return {a.x / s, a.y / s};
}
inline Vec2& operator+=(Vec2& a, Vec2 b) {
  return a = a + b;
}
inline Vec2& operator-=(Vec2& a, Vec2 b) {
  return a = a - b;
}
inline double dot(Vec2 a, Vec2 b) {
  return a.x * b.x + a.y * b.y;
}
/// z component of the cross product: positive where b lies to the left of a.
inline double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}
/// a turned by +90 degrees.
inline Vec2 left_normal(Vec2 a) {
  return {-a.y, a.x};
}

inline Vec3 operator+(Vec3 a, Vec3 b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec3 operator-(Vec3 a, Vec3 b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec3 operator-(Vec3 a) {
  return {-a.x, -a.y, -a.z};
}
inline Vec3 operator*(Vec3 a, double s) {
  return {a.x * s, a.y * s, a.z * s};
}
inline Vec3 operator*(double s, Vec3 a) {
  return a * s;
}
inline Vec3 operator/(Vec3 a, double s) {
  return {a.x / s, a.y / s, a.z / s};
}
inline Vec3& operator+=(Vec3& a, Vec3 b) {
  return a = a + b;
}
inline Vec3& operator-=(Vec3& a, Vec3 b) {
  return a = a - b;
}
inline double dot(Vec3 a, Vec3 b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class V>
double squared_norm(V a) {
  return dot(a, a);
}
template <class V>
double norm(V a) {
  return std::sqrt(dot(a, a));
}
template <class V>
double distance(V a, V b) {
  return norm(b - a);
}
/// a scaled to length 1; the zero vector stays zero.
template <class V>
V normalized(V a) {
  const double n = norm(a);
  return n > 0 ? a / n : a;
}
template <class V>
V lerp(V a, V b, double t) {
  return a * (1 - t) + b * t;
}
/// Unsigned angle between a and b in radians, accurate near 0 and pi.
inline double angle_between(Vec2 a, Vec2 b) {
  return std::atan2(std::abs(cross(a, b)), dot(a, b));
}
inline double angle_between(Vec3 a, Vec3 b) {
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double degrees(double radians) {
  return radians * (180 / pi);
}
inline constexpr double radians(double degrees) {
  return degrees * (pi / 180);
}

/// Corners of a triangle, as indices into an array of points.
using Triangle = std::array<Index, 3>;

}  // namespace beadmesh
