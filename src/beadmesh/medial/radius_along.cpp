#include "beadmesh/medial/radius_along.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace beadmesh {
namespace {

/// By how much the radius grows at a point over a small way, as a multiple of it; nothing where the feet do
/// not tell.
std::optional<double> slope(const MedialPoint& point, Vec2 way, double length) {
  constexpr double on_circle = 1e-6;
  if (!(length > 0) || !(point.radius > 0)) return std::nullopt;
  double sum = 0;
  for (const Foot& foot : point.feet) {
    const Vec2 spoke = foot.point - point.point;
    if (std::abs(norm(spoke) - point.radius) > on_circle * point.radius) return std::nullopt;
    sum -= dot(way, spoke);
  }
  return std::clamp(sum / (2 * point.radius * length), -1.0, 1.0);
}

/// Parts inside of (0, 1) where the derivative of the cubic is 0; 0 where there is none. Slopes that are no
/// more than three times the chord's and of its sign make it monotone (Fritsch, Carlson 1980).
std::array<double, 2> extrema(double r0, double m0, double r1, double m1) {
  const double chord = r1 - r0;
  const auto fits = [&](double m) {
    return chord >= 0 ? m >= 0 && m <= 3 * chord : m <= 0 && m >= 3 * chord;
  };
  if (fits(m0) && fits(m1)) return {0, 0};
  // r' = a t^2 + b t + m0
  const double a = 6 * (r0 - r1) + 3 * (m0 + m1), b = 6 * (r1 - r0) - 4 * m0 - 2 * m1;
  const double root = b * b - 4 * a * m0;
  if (root < 0) return {0, 0};
  const double q = -(b + std::copysign(std::sqrt(root), b)) / 2;
  const auto inside = [](double t) { return t > 0 && t < 1 ? t : 0; };
  return {a != 0 ? inside(q / a) : 0, q != 0 ? inside(m0 / q) : 0};
}

}  // namespace

RadiusAlong::RadiusAlong(const MedialPoint& from, const MedialPoint& to) : r0_(from.radius), r1_(to.radius) {
  const Vec2 way = to.point - from.point;
  const double length = norm(way), chord = r1_ - r0_;
  const std::optional<double> start = slope(from, way, length), end = slope(to, way, length);
  m0_ = start ? *start * length : end ? 2 * chord - *end * length : chord;
  m1_ = end ? *end * length : start ? 2 * chord - *start * length : chord;
}

double RadiusAlong::at(double part) const {
  const double t = part, u = 1 - part;
  return r0_ * (u * u * (1 + 2 * t)) + r1_ * (t * t * (1 + 2 * u)) + m0_ * (t * u * u) - m1_ * (u * t * t);
}

double RadiusAlong::least() const {
  const auto [a, b] = extrema(r0_, m0_, r1_, m1_);
  return std::min({r0_, r1_, at(a), at(b)});
}

double RadiusAlong::greatest() const {
  const auto [a, b] = extrema(r0_, m0_, r1_, m1_);
  return std::max({r0_, r1_, at(a), at(b)});
}

double RadiusAlong::mean() const {
  return (r0_ + r1_) / 2 + (m0_ - m1_) / 12;
}

}  // namespace beadmesh
