// Plane shapes for the tests.
#pragma once

#include <rapidcheck.h>

#include <cmath>
#include <utility>
#include <vector>

#include "beadmesh/delaunay/planar_region.h"

namespace beadmesh::shapes {

using Points = std::vector<Vec2>;

inline PlanarRegion region(const std::vector<Points>& loops) {
  PlanarRegion result;
  for (const Points& points : loops) result.loops.push_back({points, {}, {}});
  return result;
}

inline Points square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

inline Points reversed(Points points) {
  return {points.rbegin(), points.rend()};
}

inline Points circle(Vec2 centre, double radius, int n) {
  Points points;
  for (int i = 0; i < n; ++i)
    points.push_back(centre + radius * Vec2{std::cos(2 * pi * i / n), std::sin(2 * pi * i / n)});
  return points;
}

inline Points l_shape() {
  return {{0, 0}, {60, 0}, {60, 20}, {20, 20}, {20, 60}, {0, 60}};
}

// Teeth of width 1 on a back of height 1, all of whose points are on a grid.
inline Points comb(int teeth) {
  Points points{{0, 0}, {2.0 * teeth - 1, 0}};
  for (int i = teeth - 1; i >= 0; --i) {
    points.push_back({2.0 * i + 1, 5});
    points.push_back({2.0 * i, 5});
    if (i > 0) points.push_back({2.0 * i, 1});
    if (i > 0) points.push_back({2.0 * i - 1, 1});
  }
  return points;
}

// A star-shaped polygon round the origin with radii in [low, high].
inline Points random_star(double low, double high) {
  const int n = *rc::gen::inRange(3, 60);
  Points points;
  for (int i = 0; i < n; ++i) {
    const double r = low + (high - low) * *rc::gen::inRange(0, 1001) / 1000.0, t = 2 * pi * i / n;
    points.push_back({r * std::cos(t), r * std::sin(t)});
  }
  return points;
}

inline Points transformed(Points points, double angle, double scale, Vec2 shift) {
  for (Vec2& p : points)
    p = Vec2{p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle)} *
            scale +
        shift;
  return points;
}

// All points in one array, and the loops as indices into it.
inline std::pair<Points, std::vector<std::vector<Index>>> flattened(const PlanarRegion& region) {
  std::pair<Points, std::vector<std::vector<Index>>> result;
  for (const PlanarLoop& loop : region.loops) {
    auto& indices = result.second.emplace_back();
    for (const Vec2 p : loop.points) {
      indices.push_back(static_cast<Index>(result.first.size()));
      result.first.push_back(p);
    }
  }
  return result;
}

}  // namespace beadmesh::shapes
