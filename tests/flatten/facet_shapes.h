// Facetted shapes with known plane images, for the tests of this room.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "beadmesh/panel/facets.h"

namespace beadmesh::shapes {

/// Fills in the loops from the triangles; the longest loop becomes the outer one.
inline void find_loops(Facets& facets) {
  std::set<std::pair<Index, Index>> sides;
  for (const Triangle& t : facets.triangles)
    for (int k = 0; k < 3; ++k) sides.insert({t[k], t[(k + 1) % 3]});
  std::map<Index, Index> next;
  for (const auto& [a, b] : sides)
    if (!sides.contains({b, a})) next[a] = b;
  facets.loops.clear();
  while (!next.empty()) {
    std::vector<Index> loop;
    for (Index at = next.begin()->first; next.contains(at);) {
      loop.push_back(at);
      const Index to = next[at];
      next.erase(at);
      at = to;
    }
    facets.loops.push_back(loop);
  }
  const auto length = [&](const std::vector<Index>& loop) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
      sum += distance(facets.points[loop[i]], facets.points[loop[(i + 1) % loop.size()]]);
    return sum;
  };
  std::stable_sort(facets.loops.begin(), facets.loops.end(),
                   [&](const auto& a, const auto& b) { return length(a) > length(b); });
}

/// Drops unused points and finds the loops.
inline Facets finished(Facets facets) {
  std::vector<Index> to(facets.points.size(), no_index);
  std::vector<Vec3> points;
  for (Triangle& t : facets.triangles)
    for (Index& v : t) {
      if (to[v] == no_index) {
        to[v] = static_cast<Index>(points.size());
        points.push_back(facets.points[v]);
      }
      v = to[v];
    }
  facets.points = points;
  facets.panel_points.assign(points.size(), 0);
  facets.triangle_surface.assign(facets.triangles.size(), 0);
  facets.surfaces.assign(1, nullptr);
  find_loops(facets);
  return facets;
}

/// Triangulated parameter rectangle [0, 1] x [0, 1] of `columns` x `rows` cells, mapped by `point`; cells for
/// which `keep` is false are left out. Diagonals all run the same way, so that the triangulation is not
/// symmetric.
inline Facets sheet(Index columns, Index rows, const std::function<Vec3(double, double)>& point,
                    const std::function<bool(double, double)>& keep = {}) {
  Facets facets;
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i <= columns; ++i)
      facets.points.push_back(point(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      if (keep && !keep((i + 0.5) / columns, (j + 0.5) / rows)) continue;
      const Index a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
      facets.triangles.push_back({a, b, d});
      facets.triangles.push_back({a, d, c});
    }
  return finished(facets);
}

/// Part of a cylinder of radius r about the y axis, `angle` wide and `length` long; from outside.
inline Facets cylinder(double r, double angle, double length, Index columns = 48, Index rows = 20) {
  return sheet(columns, rows, [=](double s, double t) {
    const double a = (s - 0.5) * angle;
    return Vec3{r * std::sin(a), length * t, r * std::cos(a)};
  });
}

/// Stadium-shaped dome of the given width, overall length and height: foot tangent to the plane z = 0,
/// section height * cos^2; `base` bends the plane. Polar grid about the middle line, `skew` shifts the
/// triangulation so that it is not symmetric.
inline Facets stadium_dome(double length, double width, double height, Index around = 96, Index rings = 10,
                           const std::function<Vec3(Vec3)>& base = {}, double skew = 0.3) {
  Facets facets;
  const double radius = width / 2, half = length / 2 - radius, perimeter = 4 * half + 2 * pi * radius;
  const auto foot = [&](double along) {  // nearest point of the middle line and direction away from it
    along = std::fmod(along, perimeter);
    if (along < 2 * half) return std::pair{Vec2{-half + along, 0}, Vec2{0, -1}};
    along -= 2 * half;
    if (along < pi * radius) {
      const double angle = along / radius - pi / 2;
      return std::pair{Vec2{half, 0}, Vec2{std::cos(angle), std::sin(angle)}};
    }
    along -= pi * radius;
    if (along < 2 * half) return std::pair{Vec2{half - along, 0}, Vec2{0, 1}};
    const double angle = (along - 2 * half) / radius + pi / 2;
    return std::pair{Vec2{-half, 0}, Vec2{std::cos(angle), std::sin(angle)}};
  };
  const auto add = [&](Vec2 plan, double out) {
    const Vec3 p{plan.x, plan.y, height * std::pow(std::cos(out * pi / 2), 2)};
    facets.points.push_back(base ? base(p) : p);
  };
  // Rings from the foot inwards; the innermost one still surrounds the middle line, which is filled by a
  // strip.
  for (Index k = 0; k < rings; ++k)
    for (Index i = 0; i < around; ++i) {
      const double out = 1 - static_cast<double>(k) / rings;
      const auto [middle, away] = foot((i + skew * k) * perimeter / around);
      add(middle + away * (radius * out), out);
    }
  const Index spine = static_cast<Index>(facets.points.size());
  const Index parts = around / 3;
  for (Index i = 0; i <= parts; ++i) add({-half + 2 * half * i / parts, 0}, 0);
  for (Index k = 0; k + 1 < rings; ++k)
    for (Index i = 0; i < around; ++i) {
      const Index a = k * around + i, b = k * around + (i + 1) % around;
      facets.triangles.push_back({a, b, b + around});
      facets.triangles.push_back({a, b + around, a + around});
    }
  // Between the innermost ring and the middle line: every ring edge gets the nearest point of the middle
  // line.
  const Index ring = (rings - 1) * around;
  const auto nearest = [&](Index i) {
    const auto [middle, away] = foot((i + skew * (rings - 1)) * perimeter / around);
    return half > 0 ? std::clamp<Index>(
                          static_cast<Index>(std::lround((middle.x + half) / (2 * half) * parts)), 0, parts)
                    : 0;
  };
  for (Index i = 0; i < around; ++i) {
    const Index a = ring + i, b = ring + (i + 1) % around;
    Index from = nearest(i);
    const Index to = nearest((i + 1) % around);
    facets.triangles.push_back({a, b, spine + to});
    for (; from != to; from += to > from ? 1 : -1)
      facets.triangles.push_back({a, spine + (to > from ? from + 1 : from - 1), spine + from});
  }
  return finished(facets);
}

/// All coordinates through a rotation by `angle` about `axis` (unit).
inline Facets turned(Facets facets, Vec3 axis, double angle) {
  for (Vec3& p : facets.points)
    p = p * std::cos(angle) + cross(axis, p) * std::sin(angle) +
        axis * (dot(axis, p) * (1 - std::cos(angle)));
  return facets;
}

}  // namespace beadmesh::shapes
