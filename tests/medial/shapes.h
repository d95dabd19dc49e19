// Analytic shapes of lines and arcs, sampled as flattened CAD outlines are, and what can be done to them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "beadmesh/delaunay/planar_region.h"

namespace beadmesh::shapes {

/// How a curve becomes points: no longer than `spacing` and no more than `chord` off. `phase` shifts the
/// points of arcs and lines within their pieces (0 to 1).
struct Facetting {
  double spacing = 2;
  double chord = 0.05;
  double phase = 0;
};

inline PlanarRegion region_of(std::vector<std::vector<Vec2>> loops, bool smooth = false) {
  PlanarRegion region;
  for (auto& points : loops) {
    const std::size_t n = points.size();
    region.loops.push_back(
        {std::move(points), smooth ? std::vector<bool>(n, false) : std::vector<bool>{}, {}});
  }
  return region;
}

inline void add_line(std::vector<Vec2>& points, Vec2 from, Vec2 to, const Facetting& facetting) {
  const double length = distance(from, to);
  if (length < 1e-9) return;
  const int n = std::max(1, static_cast<int>(std::ceil(length / facetting.spacing - 1e-9)));
  points.push_back(from);
  for (int i = facetting.phase > 0 ? 0 : 1; i < n; ++i)
    points.push_back(lerp(from, to, (i + facetting.phase) / n));
}

inline void add_arc(std::vector<Vec2>& points, Vec2 centre, double radius, double start, double angle,
                    const Facetting& facetting) {
  const double by_chord = 2 * std::acos(std::max(0.5, 1 - facetting.chord / radius));
  const double step = std::min(by_chord, facetting.spacing / radius);
  const int n = std::max(2, static_cast<int>(std::ceil(std::abs(angle) / step - 1e-9)));
  points.push_back(centre + Vec2{std::cos(start), std::sin(start)} * radius);
  for (int i = facetting.phase > 0 ? 0 : 1; i < n; ++i) {
    const double at = start + angle * (i + facetting.phase) / n;
    points.push_back(centre + Vec2{std::cos(at), std::sin(at)} * radius);
  }
}

inline std::vector<Vec2> circle(Vec2 centre, double radius, const Facetting& facetting) {
  std::vector<Vec2> points;
  add_arc(points, centre, radius, 0.1, 2 * pi, {facetting.spacing, facetting.chord, 0});
  return points;
}

/// A polygon whose corner i is rounded by radius[i] (0: stays sharp and is tagged so).
inline PlanarLoop rounded(const std::vector<Vec2>& corners, const std::vector<double>& radius,
                          const Facetting& facetting = {}) {
  PlanarLoop loop;
  const std::size_t n = corners.size();
  struct Joint {
    Vec2 in, out, centre;
    double start = 0, angle = 0, radius = 0;
  };
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = normalized(corners[i] - corners[(i + n - 1) % n]);
    const Vec2 b = normalized(corners[(i + 1) % n] - corners[i]);
    const double turn = std::atan2(cross(a, b), dot(a, b)), r = radius[i];
    const double back = r * std::tan(std::abs(turn) / 2);
    const Vec2 in = corners[i] - a * back, side = left_normal(a) * (turn > 0 ? 1.0 : -1.0);
    joints.push_back({in, corners[i] + b * back, in + side * r, std::atan2(-side.y, -side.x), turn, r});
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t first = loop.points.size();
    if (radius[i] > 0)
      add_arc(loop.points, joints[i].centre, radius[i], joints[i].start, joints[i].angle, facetting);
    add_line(loop.points, joints[i].out, joints[(i + 1) % n].in, facetting);
    loop.corner.resize(loop.points.size(), false);
    if (radius[i] == 0) loop.corner[first] = true;
  }
  return loop;
}

inline PlanarRegion rounded_region(const std::vector<Vec2>& corners, const std::vector<double>& radius,
                                   const Facetting& facetting = {}) {
  return {{rounded(corners, radius, facetting)}};
}

inline PlanarRegion rectangle(double width, double height) {
  return region_of({{{0, 0}, {width, 0}, {width, height}, {0, height}}});
}

/// From (0, 0) to (length, 0), round ends about these.
inline PlanarRegion stadium(double length, double r, const Facetting& facetting = {}) {
  std::vector<Vec2> points;
  add_line(points, {0, -r}, {length, -r}, facetting);
  add_arc(points, {length, 0}, r, -pi / 2, pi, facetting);
  add_line(points, {length, r}, {0, r}, facetting);
  add_arc(points, {0, 0}, r, pi / 2, pi, facetting);
  return region_of({points}, true);
}

/// Two circles and their outer tangents.
inline PlanarRegion tapered_stadium(double length, double r0, double r1, const Facetting& facetting = {}) {
  const double lean = std::asin((r0 - r1) / length);
  const auto on = [&](Vec2 c, double r, double angle) {
    return c + Vec2{std::cos(angle), std::sin(angle)} * r;
  };
  const double low = -pi / 2 + lean, high = pi / 2 - lean;
  std::vector<Vec2> points;
  add_line(points, on({0, 0}, r0, low), on({length, 0}, r1, low), facetting);
  add_arc(points, {length, 0}, r1, low, high - low, facetting);
  add_line(points, on({length, 0}, r1, high), on({0, 0}, r0, high), facetting);
  add_arc(points, {0, 0}, r0, high, 2 * pi - (high - low), facetting);
  return region_of({points}, true);
}

inline PlanarRegion annulus(double outer, double inner, Vec2 inner_centre = {},
                            const Facetting& facetting = {}) {
  return region_of({circle({0, 0}, outer, facetting), circle(inner_centre, inner, facetting)}, true);
}

inline PlanarRegion ellipse(double a, double b, int n, double phase = 0) {
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i)
    points.push_back({a * std::cos(2 * pi * (i + phase) / n), b * std::sin(2 * pi * (i + phase) / n)});
  return region_of({points}, true);
}

/// A letter of strokes `width` wide: outline of a polygon, outer ends fully rounded, inner corners filleted
/// by `fillet`.
inline PlanarRegion letter_t(double width, double fillet, const Facetting& facetting = {}) {
  const double w = width / 2, cap = fillet > 0 ? w : 0;
  return rounded_region({{-w, -60}, {w, -60}, {w, -w}, {50, -w}, {50, w}, {-50, w}, {-50, -w}, {-w, -w}},
                        {cap, cap, fillet, cap, cap, cap, cap, fillet}, facetting);
}

/// Concentric bend where outer = inner + width.
inline PlanarRegion letter_l(double width, double outer, double inner, const Facetting& facetting = {}) {
  const double w = width / 2;
  return rounded_region({{-w, -w}, {90, -w}, {90, w}, {w, w}, {w, 70}, {-w, 70}}, {outer, w, w, inner, w, w},
                        facetting);
}

/// A hook of constant width with concentric bends all the way: one arm.
inline PlanarRegion letter_g(double width, const Facetting& facetting = {}) {
  const double w = width / 2, in = 6, out = in + width;
  return rounded_region({{60 - w, 40},
                         {60 + w, 40},
                         {60 + w, 60 + w},
                         {-w, 60 + w},
                         {-w, -w},
                         {60 + w, -w},
                         {60 + w, 20},
                         {60 - w, 20},
                         {60 - w, w},
                         {w, w},
                         {w, 60 - w},
                         {60 - w, 60 - w}},
                        {w, w, out, out, out, out, w, w, in, in, in, in}, facetting);
}

inline PlanarRegion letter_h(double width, double fillet, const Facetting& facetting = {}) {
  const double w = width / 2;
  return rounded_region({{-w, -60},
                         {w, -60},
                         {w, -w},
                         {60 - w, -w},
                         {60 - w, -60},
                         {60 + w, -60},
                         {60 + w, 50},
                         {60 - w, 50},
                         {60 - w, w},
                         {w, w},
                         {w, 50},
                         {-w, 50}},
                        {w, w, fillet, fillet, w, w, w, w, fillet, fillet, w, w}, facetting);
}

/// Two strokes through the origin, the second one at `angle` to the first.
inline PlanarRegion letter_x(double width, double angle, double fillet, const Facetting& facetting = {}) {
  const double w = width / 2;
  const auto along = [](double at) { return Vec2{std::cos(at), std::sin(at)}; };
  std::vector<Vec2> corners;
  std::vector<double> radius;
  const double ends[] = {0, angle, pi, pi + angle};
  for (int k = 0; k < 4; ++k) {
    const Vec2 d = along(ends[k]), side = left_normal(d);
    corners.push_back(d * 70 - side * w);
    corners.push_back(d * 70 + side * w);
    const double next = (k < 3 ? ends[k + 1] : 2 * pi) - ends[k];
    corners.push_back(along(ends[k] + next / 2) * (w / std::sin(next / 2)));
    radius.insert(radius.end(), {w, w, fillet});
  }
  return rounded_region(corners, radius, facetting);
}

/// A spine from (0, 0) to (end, width) above teeth of the same width, `length`
/// long; the outer ones are flush.
inline std::vector<Vec2> comb_corners(int teeth, double width, double pitch, double length) {
  const double end = (teeth - 1) * pitch + width;
  std::vector<Vec2> corners{{end, width}, {0, width}};
  for (int k = 0; k < teeth; ++k) {
    const double x = k * pitch;
    if (k > 0) corners.push_back({x, 0});
    corners.push_back({x, -length});
    corners.push_back({x + width, -length});
    if (k + 1 < teeth) corners.push_back({x + width, 0});
  }
  return corners;
}

/// Spine along y = 0 above `teeth` teeth, all of `width`, `pitch` apart, the outer teeth flush with the ends
/// of the spine.
inline PlanarRegion comb(int teeth, double width, double pitch, double length, double fillet = 0,
                         const Facetting& facetting = {}) {
  const double cap = fillet > 0 ? width / 2 : 0;
  const std::vector<Vec2> corners = comb_corners(teeth, width, pitch, length);
  std::vector<double> radius;
  for (const Vec2 corner : corners)
    radius.push_back(corner.y == 0 ? fillet : corner.y < 0 ? cap : fillet > 0 ? width + fillet : 0);
  return rounded_region(corners, radius, facetting);
}

/// A plate with 8 x 5 round holes, rows staggered so that three neighbours never lie on a square.
inline PlanarRegion gasket(const Facetting& facetting = {}) {
  PlanarRegion region = rounded_region({{0, 0}, {177, 0}, {177, 104}, {0, 104}}, {12, 12, 12, 12}, facetting);
  for (int row = 0; row < 5; ++row)
    for (int column = 0; column < 8; ++column) {
      const Vec2 centre{14 + 20.0 * column + (row % 2 ? 9.0 : 0.0) + 0.3 * ((row * 5 + column * 3) % 7),
                        14 + 19.0 * row + 0.4 * ((row * 3 + column * 5) % 4)};
      region.loops.push_back({circle(centre, 5 + 0.3 * ((row + column) % 3), facetting), {}, {}});
    }
  for (PlanarLoop& loop : region.loops) loop.corner.assign(loop.points.size(), false);
  return region;
}

template <class Map>
PlanarRegion mapped(PlanarRegion region, Map map) {
  for (PlanarLoop& loop : region.loops)
    for (Vec2& p : loop.points) p = map(p);
  return region;
}

inline PlanarRegion rotated(const PlanarRegion& region, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return mapped(region, [=](Vec2 p) { return Vec2{c * p.x - s * p.y, s * p.x + c * p.y}; });
}
inline PlanarRegion translated(const PlanarRegion& region, Vec2 by) {
  return mapped(region, [=](Vec2 p) { return p + by; });
}
inline PlanarRegion scaled(const PlanarRegion& region, double factor) {
  return mapped(region, [=](Vec2 p) { return p * factor; });
}

/// Every loop runs the other way.
inline PlanarRegion reversed(PlanarRegion region) {
  for (PlanarLoop& loop : region.loops) {
    std::reverse(loop.points.begin(), loop.points.end());
    std::reverse(loop.corner.begin(), loop.corner.end());
  }
  return region;
}

/// Every loop starts `by` points later.
inline PlanarRegion shifted(PlanarRegion region, std::size_t by) {
  for (PlanarLoop& loop : region.loops) {
    const auto n = loop.points.size();
    std::rotate(loop.points.begin(), loop.points.begin() + static_cast<std::ptrdiff_t>(by % n),
                loop.points.end());
    if (loop.corner.size() == n)
      std::rotate(loop.corner.begin(), loop.corner.begin() + static_cast<std::ptrdiff_t>(by % n),
                  loop.corner.end());
  }
  return region;
}

/// Every point moved by up to `amplitude` in x and y; the same for the same seed on every machine.
inline PlanarRegion noisy(const PlanarRegion& region, double amplitude, std::uint64_t seed) {
  std::uint64_t state = seed * 2654435769u + 1;
  const auto next = [&] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return (static_cast<double>(state >> 11) / 9007199254740992.0 * 2 - 1) * amplitude;
  };
  return mapped(region, [&](Vec2 p) {
    const double x = next();
    return p + Vec2{x, next()};
  });
}

}  // namespace beadmesh::shapes
