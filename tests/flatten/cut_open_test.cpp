#include "beadmesh/flatten/cut_open.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "flatten/facet_shapes.h"

namespace beadmesh {
namespace {

using namespace shapes;

/// A surface of revolution about z with `columns` around and `rows` along; radius and height by t in [0, 1].
/// `seam`: the first and the last column are vertices of their own over the same panel points.
Facets revolved(Index columns, Index rows, const std::function<Vec2(double)>& profile, bool seam) {
  Facets facets;
  const Index around = seam ? columns + 1 : columns;
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i < around; ++i) {
      const Vec2 p = profile(static_cast<double>(j) / rows);
      const double a = 2 * pi * (i % columns) / columns;
      facets.points.push_back({p.x * std::cos(a), p.x * std::sin(a), p.y});
      facets.panel_points.push_back(j * columns + i % columns);
    }
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const Index a = j * around + i, b = j * around + (i + 1) % around, c = a + around, d = b + around;
      facets.triangles.push_back({a, b, d});
      facets.triangles.push_back({a, d, c});
    }
  facets.triangle_surface.assign(facets.triangles.size(), 0);
  facets.surfaces.assign(1, nullptr);
  find_loops(facets);
  return facets;
}

Facets tube(double radius, double length, bool seam) {
  return revolved(
      36, 12,
      [=](double t) {
        return Vec2{radius, length * t};
      },
      seam);
}

Facets sphere(double from, double to, double radius = 20) {
  return revolved(
      48, 24,
      [=](double t) {
        const double a = from + (to - from) * t;
        return Vec2{radius * std::cos(a), radius * std::sin(a)};
      },
      false);
}

Facets torus() {
  Facets facets;
  constexpr Index m = 32, n = 16;
  for (Index i = 0; i < m; ++i)
    for (Index j = 0; j < n; ++j) {
      const double a = 2 * pi * i / m, b = 2 * pi * j / n, r = 30 + 8 * std::cos(b);
      facets.points.push_back({r * std::cos(a), r * std::sin(a), 8 * std::sin(b)});
    }
  for (Index i = 0; i < m; ++i)
    for (Index j = 0; j < n; ++j) {
      const auto at = [&](Index p, Index q) { return (p % m) * n + q % n; };
      facets.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      facets.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return finished(facets);
}

int sides(const OpenedFace& face) {
  int count = 0;
  for (const auto& loop : face.cut_sides)
    count += static_cast<int>(std::count(loop.begin(), loop.end(), true));
  return count;
}

Vec2 extent(const std::vector<Vec2>& points) {
  const auto [left, right] =
      std::minmax_element(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return a.x < b.x; });
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return a.y < b.y; });
  return {right->x - left->x, high->y - low->y};
}

/// Every invariant of an opened face.
void expect_sound(const OpenedFace& face) {
  EXPECT_EQ(face.flat.positions.size(), face.facets.points.size());
  EXPECT_EQ(face.facets.panel_points.size(), face.facets.points.size());
  EXPECT_EQ(face.facets.triangle_surface.size(), face.facets.triangles.size());
  const auto again = flatten(face.facets);
  EXPECT_TRUE(again) << "the opened facets are sound facets";
  if (face.cut_sides.empty()) return;
  ASSERT_EQ(face.cut_sides.size(), face.facets.loops.size());
  for (std::size_t l = 0; l < face.facets.loops.size(); ++l)
    EXPECT_EQ(face.cut_sides[l].size(), face.facets.loops[l].size());
  EXPECT_EQ(sides(face) % 2, 0) << "every cut has two sides";
}

TEST(CutOpen, LoopTurnsTellHolesFromEndsOfTubes) {
  const auto plate = sheet(
      20, 20,
      [](double s, double t) {
        return Vec3{s * 10, t * 10, 0};
      },
      [](double s, double t) { return std::abs(s - 0.5) > 0.2 || std::abs(t - 0.5) > 0.2; });
  const std::vector<double> flat = loop_turns(plate);
  EXPECT_NEAR(flat[0], 1, 1e-9);
  EXPECT_NEAR(flat[1], -1, 1e-9);
  EXPECT_FALSE(tube_ends(flat));
  const Facets pipe = tube(10, 30, false);
  const std::vector<double> round = loop_turns(pipe);
  EXPECT_NEAR(round[0], 0, 1e-9);
  EXPECT_NEAR(round[1], 0, 1e-9);
  EXPECT_TRUE(tube_ends(round));
  using Ends = std::pair<std::size_t, std::size_t>;
  EXPECT_EQ(tube_ends({-1, 0.1, -1, 0}), (Ends{1, 3})) << "a tube with holes, whatever loop comes first";
  EXPECT_EQ(tube_ends({-0.9, -0.7, -0.8}), (Ends{1, 2})) << "most of a sphere";
  EXPECT_FALSE(tube_ends({-1, -1, 1}));
  EXPECT_FALSE(tube_ends({-2}));
}

TEST(CutOpen, TubeWithoutSeamBecomesARectangle) {
  for (const double length : {3.0, 30.0, 300.0}) {
    const auto face = lay_open(tube(10, length, false));
    ASSERT_TRUE(face) << length;
    expect_sound(*face);
    EXPECT_EQ(face->facets.loops.size(), 1);
    EXPECT_LT(face->flat.distortion.max_ratio, 1.001);
    EXPECT_NEAR(cut_length(face->facets, face->cut_sides), length, 1e-6) << "the shortest way";
    const double around = 36 * 20 * std::sin(pi / 36);
    EXPECT_NEAR(norm(extent(face->flat.positions)), std::hypot(around, length), 0.02 * length + 0.2);
  }
}

TEST(CutOpen, TubeWithSeamIsCutThere) {
  const Facets pipe = tube(10, 30, true);
  const auto face = lay_open(pipe);
  ASSERT_TRUE(face);
  expect_sound(*face);
  EXPECT_EQ(face->facets.points.size(), pipe.points.size()) << "as it came";
  EXPECT_EQ(sides(*face), 2 * 12);
  EXPECT_NEAR(cut_length(face->facets, face->cut_sides), 30, 1e-9);
}

TEST(CutOpen, TubeWithAHoleKeepsIt) {
  Facets pipe = tube(10, 30, false);
  std::vector<Triangle> kept;
  for (Index j = 0; j < 12; ++j)
    for (Index i = 0; i < 36; ++i)
      if (i < 16 || i > 20 || j < 4 || j > 7)
        kept.insert(kept.end(), {pipe.triangles[2 * (36 * j + i)], pipe.triangles[2 * (36 * j + i) + 1]});
  pipe.triangles = kept;
  pipe = finished(pipe);
  pipe.panel_points.resize(pipe.points.size());
  std::iota(pipe.panel_points.begin(), pipe.panel_points.end(), 0);
  const auto face = lay_open(pipe);
  ASSERT_TRUE(face);
  expect_sound(*face);
  ASSERT_EQ(face->facets.loops.size(), 2);
  EXPECT_EQ(std::count(face->cut_sides[1].begin(), face->cut_sides[1].end(), true), 0);
}

TEST(CutOpen, FlatRingStaysARing) {
  const auto ring = [](double height, bool seam) {
    return revolved(
        36, 6,
        [=](double t) {
          return Vec2{20 + 10 * t, height * t * (1 - t)};
        },
        seam);
  };
  for (const bool seam : {false, true}) {
    const auto face = lay_open(ring(4, seam));
    ASSERT_TRUE(face);
    expect_sound(*face);
    EXPECT_EQ(face->facets.loops.size(), 2) << "a seam that only closes the parameters is sewn up";
    EXPECT_TRUE(face->cut_sides.empty());
  }
}

TEST(CutOpen, DomeWithASeamToItsPoleIsADisc) {
  const Facets dome = sphere(0, 1.5);
  const auto face = lay_open(dome);
  ASSERT_TRUE(face);
  EXPECT_EQ(face->facets.loops.size(), dome.loops.size());
}

TEST(CutOpen, SphereBandAndClosedSphere) {
  const auto band = lay_open(sphere(-0.5, 0.5));
  ASSERT_TRUE(band);
  expect_sound(*band);
  EXPECT_EQ(band->facets.loops.size(), 1);
  EXPECT_NEAR(cut_length(band->facets, band->cut_sides), 20, 0.3);

  // Closed: the two ends of a sphere without caps pulled together to points.
  Facets ball = sphere(-pi / 2, pi / 2);
  for (Triangle& t : ball.triangles)
    for (Index& v : t) v = v < 48 ? 0 : v >= 48 * 24 ? 48 * 24 : v;
  std::erase_if(ball.triangles,
                [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  ball = finished(ball);
  ASSERT_TRUE(ball.loops.empty());
  const auto face = lay_open(ball);
  ASSERT_TRUE(face) << to_line(face.error());
  expect_sound(*face);
  EXPECT_EQ(face->facets.loops.size(), 1);
  EXPECT_LE(face->flat.distortion.max_ratio, 4);
}

TEST(CutOpen, HandleWithoutASeamIsRefused) {
  const auto face = lay_open(torus());
  ASSERT_FALSE(face);
  EXPECT_EQ(face.error().code, "flatten.not_a_disc");
  EXPECT_FALSE(lay_open(Facets{}));
}

TEST(CutOpen, WhatNeedsNoCutIsLeftAlone) {
  Facets flat = sheet(8, 5, [](double s, double t) { return Vec3{30 * s, 20 * t, 0}; });
  std::iota(flat.panel_points.begin(), flat.panel_points.end(), 0);
  const auto face = lay_open(flat);
  ASSERT_TRUE(face);
  EXPECT_TRUE(face->cut_sides.empty());
  EXPECT_EQ(face->facets.loops, flat.loops);
  EXPECT_EQ(face->flat.positions, flatten(flat)->positions);
}

TEST(CutOpen, TheSameEveryTime) {
  const auto one = lay_open(sphere(-1, 1)), other = lay_open(sphere(-1, 1));
  ASSERT_TRUE(one && other);
  EXPECT_EQ(one->flat.positions, other->flat.positions);
  EXPECT_EQ(one->cut_sides, other->cut_sides);
}

}  // namespace
}  // namespace beadmesh
