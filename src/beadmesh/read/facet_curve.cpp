#include "beadmesh/read/facet_curve.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace beadmesh {
namespace {

constexpr double long_neighbour = 3;
constexpr double most_rounding = 0.5;  // mm

struct Piece {
  Vec3 start, end;
  std::array<Vec3, 2> tangent;  ///< unit, at both ends
};

class PiecewiseCubic final : public CurveEvaluator {
 public:
  PiecewiseCubic(std::vector<Piece> pieces, std::vector<double> parameters)
      : pieces_(std::move(pieces)), parameters_(std::move(parameters)) {}

  Vec3 point(double t) const override { return at(t).point; }

  SpaceCurvePoint at(double t) const override {
    const auto next = std::upper_bound(parameters_.begin() + 1, parameters_.end() - 1, t);
    const std::size_t i = std::size_t(next - parameters_.begin()) - 1;
    const double length = parameters_[i + 1] - parameters_[i];
    const double s = (t - parameters_[i]) / length;
    const Piece& p = pieces_[i];
    const Vec3 m0 = p.tangent[0] * length, m1 = p.tangent[1] * length;
    const double s2 = s * s, s3 = s2 * s;
    return {
        p.start * (2 * s3 - 3 * s2 + 1) + m0 * (s3 - 2 * s2 + s) + p.end * (3 * s2 - 2 * s3) + m1 * (s3 - s2),
        (p.start * (6 * s2 - 6 * s) + m0 * (3 * s2 - 4 * s + 1) + p.end * (6 * s - 6 * s2) +
         m1 * (3 * s2 - 2 * s)) /
            length,
        (p.start * (12 * s - 6) + m0 * (6 * s - 4) + p.end * (6 - 12 * s) + m1 * (6 * s - 2)) /
            (length * length)};
  }

 private:
  std::vector<Piece> pieces_;
  std::vector<double> parameters_;
};

/// Tangents behind and ahead of a joint.
std::array<Vec3, 2> tangents_at(Vec3 before, Vec3 here, Vec3 after) {
  const double a = distance(before, here), b = distance(here, after);
  const Vec3 in = (here - before) / a, out = (after - here) / b;
  if (angle_between(in, out) * std::min(a, b) / 8 > most_rounding) return {in, out};
  if (a > long_neighbour * b) return {in, in};
  if (b > long_neighbour * a) return {out, out};
  const Vec3 tangent = normalized(in * b + out * a);
  return {tangent, tangent};
}

/// At an end: as the circle through the first three points begins.
Vec3 end_tangent(Vec3 here, Vec3 next, Vec3 inner_tangent) {
  const Vec3 along = normalized(next - here);
  return normalized(along * (2 * dot(along, inner_tangent)) - inner_tangent);
}

}  // namespace

FacetCurve curve_through(const std::vector<Vec3>& points) {
  const std::size_t n = points.size();
  const bool closed = n > 3 && points.front() == points.back();
  std::vector<double> parameters{0};
  for (std::size_t i = 1; i < n; ++i) {
    const double step = distance(points[i - 1], points[i]);
    if (!(step > 0)) return {};
    parameters.push_back(parameters.back() + step);
  }
  if (n < 3) return {};
  std::vector<std::array<Vec3, 2>> tangents(n);
  for (std::size_t i = 1; i + 1 < n; ++i) tangents[i] = tangents_at(points[i - 1], points[i], points[i + 1]);
  if (closed) {
    tangents[n - 1] = tangents[0] = tangents_at(points[n - 2], points[0], points[1]);
  } else {
    tangents[0][1] = end_tangent(points[0], points[1], tangents[1][0]);
    tangents[n - 1][0] = -end_tangent(points[n - 1], points[n - 2], -tangents[n - 2][1]);
  }
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i + 1 < n; ++i)
    pieces.push_back({points[i], points[i + 1], {tangents[i][1], tangents[i + 1][0]}});
  auto curve = std::make_shared<PiecewiseCubic>(std::move(pieces), parameters);
  return {std::move(curve), std::move(parameters)};
}

}  // namespace beadmesh
