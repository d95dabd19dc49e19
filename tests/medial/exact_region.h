// Regions of lines, circular arcs and ellipses that carry their exact curves,
// or facets of them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "medial/shapes.h"

namespace beadmesh::exact_shapes {

using shapes::comb_corners;

/// Whether the region knows its curves, and how densely they are sampled.
struct Accuracy {
  bool curves = true;
  double step = radians(7.5);  ///< greatest angle of a facet
  double phase = 0;            ///< 0 to 1: shifts the points of closed curves by a part of a facet
};

class EllipseCurve final : public PlanarCurve {
 public:
  EllipseCurve(double a, double b) : a_(a), b_(b) {}
  CurvePoint at(double t) const override {
    const double c = std::cos(t), s = std::sin(t);
    return {{a_ * c, b_ * s}, {-a_ * s, b_ * c}, {-a_ * c, -b_ * s}};
  }

 private:
  double a_, b_;
};

/// A curve after a rotation, a scale and a shift.
class MovedCurve final : public PlanarCurve {
 public:
  MovedCurve(std::shared_ptr<const PlanarCurve> curve, double angle, double scale, Vec2 shift)
      : curve_(std::move(curve)),
        cos_(scale * std::cos(angle)),
        sin_(scale * std::sin(angle)),
        shift_(shift) {}
  CurvePoint at(double t) const override {
    const CurvePoint p = curve_->at(t);
    return {turned(p.point) + shift_, turned(p.velocity), turned(p.acceleration)};
  }

 private:
  Vec2 turned(Vec2 p) const { return {cos_ * p.x - sin_ * p.y, sin_ * p.x + cos_ * p.y}; }
  std::shared_ptr<const PlanarCurve> curve_;
  double cos_, sin_;
  Vec2 shift_;
};

/// Puts pieces one after the other into a loop of a region; joints are corners
/// where it is told so.
class LoopBuilder {
 public:
  LoopBuilder(PlanarRegion& region, const Accuracy& accuracy) : region_(region), accuracy_(accuracy) {}

  LoopBuilder& line(Vec2 from, bool corner_at_start = true) {
    add(from, corner_at_start, no_index, {0, 0});
    return *this;
  }
  /// Counter-clockwise for a positive sweep.
  LoopBuilder& arc(Vec2 centre, double radius, double start, double sweep, bool corner_at_start = false) {
    return curve(std::make_shared<CircularArc>(centre, radius), start, sweep, corner_at_start);
  }
  LoopBuilder& curve(std::shared_ptr<const PlanarCurve> curve, double start, double sweep,
                     bool corner_at_start = false) {
    const auto id = static_cast<Index>(region_.curves.size());
    const int n = static_cast<int>(std::ceil(std::abs(sweep) / accuracy_.step - 1e-9));
    for (int i = 0; i < n; ++i) {
      const double from = start + sweep * i / n, to = start + sweep * (i + 1) / n;
      add(curve->at(from).point, corner_at_start && i == 0, id, {from, to});
    }
    region_.curves.push_back(std::move(curve));
    return *this;
  }
  LoopBuilder& closed_curve(std::shared_ptr<const PlanarCurve> closed) {
    return curve(std::move(closed), accuracy_.phase * accuracy_.step, 2 * pi);
  }
  LoopBuilder& circle(Vec2 centre, double radius) {
    return closed_curve(std::make_shared<CircularArc>(centre, radius));
  }
  LoopBuilder& polygon(const std::vector<Vec2>& points) {
    for (const Vec2 p : points) line(p);
    return *this;
  }
  void close() { region_.loops.push_back(std::move(loop_)); }

 private:
  void add(Vec2 point, bool corner, Index curve, std::array<double, 2> parameters) {
    loop_.points.push_back(point);
    loop_.corner.push_back(corner);
    if (!accuracy_.curves) return;
    loop_.curve.push_back(curve);
    loop_.parameters.push_back(parameters);
  }

  PlanarRegion& region_;
  Accuracy accuracy_;
  PlanarLoop loop_;
};

inline PlanarRegion finished(PlanarRegion region, const Accuracy& accuracy) {
  if (!accuracy.curves) region.curves.clear();
  auto checked = checked_region(std::move(region));
  EXPECT_TRUE(checked) << (checked ? "" : to_line(checked.error()));
  return checked ? std::move(*checked) : PlanarRegion{};
}

inline PlanarRegion polygon(const std::vector<std::vector<Vec2>>& loops) {
  PlanarRegion region;
  for (const auto& points : loops) LoopBuilder(region, {}).polygon(points).close();
  return finished(std::move(region), {});
}

/// Round ends about (0, 0) and (length, 0).
inline PlanarRegion stadium(double length, double r, const Accuracy& accuracy = {}) {
  PlanarRegion region;
  LoopBuilder builder(region, accuracy);
  builder.line({0, -r}, false)
      .arc({length, 0}, r, -pi / 2, pi)
      .line({length, r}, false)
      .arc({0, 0}, r, pi / 2, pi);
  builder.close();
  return finished(std::move(region), accuracy);
}

inline PlanarRegion annulus(double outer, double inner, Vec2 inner_centre, const Accuracy& accuracy = {}) {
  PlanarRegion region;
  LoopBuilder(region, accuracy).circle({}, outer).close();
  LoopBuilder(region, accuracy).circle(inner_centre, inner).close();
  return finished(std::move(region), accuracy);
}

inline PlanarRegion ellipse(double a, double b, const Accuracy& accuracy = {}) {
  PlanarRegion region;
  LoopBuilder(region, accuracy).closed_curve(std::make_shared<EllipseCurve>(a, b)).close();
  return finished(std::move(region), accuracy);
}

/// A square from -half to half with a round hole in its middle.
inline PlanarRegion holed_plate(double half, double r, const Accuracy& accuracy = {}) {
  PlanarRegion region;
  LoopBuilder(region, accuracy).polygon({{-half, -half}, {half, -half}, {half, half}, {-half, half}}).close();
  LoopBuilder(region, accuracy).circle({}, r).close();
  return finished(std::move(region), accuracy);
}

/// A polygon whose corner i is rounded by radius[i]; 0: it stays sharp.
inline PlanarRegion rounded(const std::vector<Vec2>& corners, const std::vector<double>& radius,
                            const Accuracy& accuracy = {}) {
  PlanarRegion region;
  LoopBuilder builder(region, accuracy);
  const std::size_t n = corners.size();
  const auto turn_at = [&](std::size_t i) {
    const Vec2 a = corners[i] - corners[(i + n - 1) % n], b = corners[(i + 1) % n] - corners[i];
    return std::atan2(cross(a, b), dot(a, b));
  };
  const auto back = [&](std::size_t i) { return radius[i] * std::tan(std::abs(turn_at(i)) / 2); };
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const Vec2 a = normalized(corners[i] - corners[(i + n - 1) % n]),
               b = normalized(corners[next] - corners[i]);
    const double turn = turn_at(i), r = radius[i];
    const Vec2 side = left_normal(a) * (turn > 0 ? 1.0 : -1.0);
    if (r > 0) builder.arc(corners[i] - a * back(i) + side * r, r, std::atan2(-side.y, -side.x), turn);
    const bool has_line = distance(corners[i], corners[next]) > (1 + 1e-9) * (back(i) + back(next));
    if (has_line) builder.line(corners[i] + b * back(i), r == 0);
  }
  builder.close();
  return finished(std::move(region), accuracy);
}

/// A plate with 8 x 5 round holes, rows staggered so that four neighbours never
/// lie on a circle.
inline PlanarRegion gasket(const Accuracy& accuracy = {}) {
  PlanarRegion region = rounded({{0, 0}, {177, 0}, {177, 104}, {0, 104}}, {12, 12, 12, 12}, accuracy);
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 8; ++column) {
      const Vec2 centre{14 + 20.0 * column + (row % 2 ? 9.0 : 0.0) + 0.3 * ((row * 5 + column * 3) % 7),
                        14 + 19.0 * row + 0.4 * ((row * 3 + column * 5) % 4)};
      LoopBuilder(region, accuracy).circle(centre, 5 + 0.3 * ((row + column) % 3)).close();
    }
  return finished(std::move(region), accuracy);
}

/// Turned by `angle` about the origin, then scaled, then shifted.
inline PlanarRegion moved(PlanarRegion region, double angle, double scale, Vec2 shift) {
  const double c = scale * std::cos(angle), s = scale * std::sin(angle);
  for (PlanarLoop& loop : region.loops)
    for (Vec2& p : loop.points) p = Vec2{c * p.x - s * p.y, s * p.x + c * p.y} + shift;
  for (auto& curve : region.curves) {
    if (const auto* arc = dynamic_cast<const CircularArc*>(curve.get())) {
      // A turned arc stays an arc: its parameters turn with it.
      const Vec2 centre = arc->centre();
      const auto id = static_cast<Index>(&curve - region.curves.data());
      for (PlanarLoop& loop : region.loops)
        for (std::size_t i = 0; i < loop.curve.size(); ++i)
          if (loop.curve[i] == id)
            for (double& t : loop.parameters[i]) t += angle;
      curve = std::make_shared<CircularArc>(
          Vec2{c * centre.x - s * centre.y, s * centre.x + c * centre.y} + shift, arc->radius() * scale);
    } else if (curve) {
      curve = std::make_shared<MovedCurve>(curve, angle, scale, shift);
    }
  }
  return region;
}

/// Every loop starts `by` points later.
inline PlanarRegion started_later(PlanarRegion region, std::size_t by) {
  const auto turn = [by](auto& list) {
    if (!list.empty())
      std::rotate(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(by % list.size()), list.end());
  };
  for (PlanarLoop& loop : region.loops)
    turn(loop.points), turn(loop.corner), turn(loop.curve), turn(loop.parameters);
  return region;
}

/// Every loop runs the other way, which checked_region turns back.
inline PlanarRegion run_backwards(PlanarRegion region) {
  for (PlanarLoop& loop : region.loops) {
    std::reverse(loop.points.begin(), loop.points.end());
    std::reverse(loop.corner.begin(), loop.corner.end());
    // Segment i now ends where it started: the list turns round, and its first
    // one becomes the last.
    std::reverse(loop.curve.begin(), loop.curve.end());
    std::reverse(loop.parameters.begin(), loop.parameters.end());
    for (auto& ends : loop.parameters) std::swap(ends[0], ends[1]);
    if (!loop.curve.empty()) {
      std::rotate(loop.curve.begin(), loop.curve.begin() + 1, loop.curve.end());
      std::rotate(loop.parameters.begin(), loop.parameters.begin() + 1, loop.parameters.end());
    }
  }
  return region;
}

}  // namespace beadmesh::exact_shapes
