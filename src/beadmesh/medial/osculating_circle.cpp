#include "beadmesh/medial/osculating_circle.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

constexpr int steps = 48;  // over which the vertex is looked for
constexpr int golden_steps = 60;

double curvature(const BoundaryCurve& curve, Index loop, double position) {
  const BoundaryPlace place = curve.place_at(loop, position);
  if (curve.is_straight(loop, place.segment)) return 0;
  Vec2 normal;
  return 1 / curve.signed_radius(place, normal);
}

/// Position of the greatest curvature between low and high, by golden section.
double vertex_between(const BoundaryCurve& curve, Index loop, double low, double high) {
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double at_a = curvature(curve, loop, a), at_b = curvature(curve, loop, b);
  for (int step = 0; step < golden_steps; ++step) {
    if (at_a < at_b) {
      low = a, a = b, at_a = at_b;
      b = low + golden * (high - low), at_b = curvature(curve, loop, b);
    } else {
      high = b, b = a, at_b = at_a;
      a = high - golden * (high - low), at_a = curvature(curve, loop, a);
    }
  }
  return (low + high) / 2;
}

}  // namespace

std::optional<Circle> osculating_circle(const BoundaryCurve& curve, const Stretch& stretch,
                                        const Circle& start, BoundaryPlace& vertex) {
  const Index loop = stretch.loop;
  if (!curve.is_exact(loop)) return std::nullopt;
  const double step = (stretch.to - stretch.from) / steps, middle = (stretch.from + stretch.to) / 2;
  double best = middle, greatest = curvature(curve, loop, middle);
  for (int k = 0; k <= steps; ++k) {
    const double there = curvature(curve, loop, stretch.from + k * step);
    if (there > greatest * (1 + 1e-9)) greatest = there, best = stretch.from + k * step;
  }
  if (best < stretch.from + step / 2 || best > stretch.to - step / 2 || !(greatest > 0)) return std::nullopt;
  const double refined = vertex_between(curve, loop, best - step, best + step);
  if (curvature(curve, loop, refined) > greatest) best = refined;  // on an arc any place is as good
  vertex = curve.place_at(loop, best);
  Vec2 inward;
  const double radius = curve.signed_radius(vertex, inward);
  const Circle circle{curve.point(vertex) + inward * radius, radius};
  if (!(distance(circle.centre, start.centre) < 0.5 * start.radius)) return std::nullopt;
  return circle;
}

}  // namespace beadmesh
