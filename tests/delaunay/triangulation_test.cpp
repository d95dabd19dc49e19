#include "beadmesh/delaunay/triangulation.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "delaunay/shapes.h"

namespace beadmesh {
namespace {

using namespace shapes;
using Loops = std::vector<std::vector<Index>>;

void expect_triangles(const PlanarRegion& input, std::size_t count) {
  const auto checked = checked_region(input);
  ASSERT_TRUE(checked) << to_line(checked.error());
  const auto [points, loops] = flattened(*checked);
  const auto result = triangulate(points, loops);
  ASSERT_TRUE(result) << to_line(result.error());
  EXPECT_EQ(result->triangles.size(), count);
  EXPECT_EQ(verify_triangulation(*result, loops), std::vector<std::string>{});
}

std::string code(const Points& points, const Loops& loops) {
  const auto result = triangulate(points, loops);
  return result ? "" : result.error().code;
}

TEST(Triangulation, known_counts) {
  expect_triangles(region({{{0, 0}, {1, 0}, {0, 1}}}), 1);
  expect_triangles(region({square(0, 0, 1)}), 2);
  expect_triangles(region({l_shape()}), 4);
  expect_triangles(region({comb(15)}), comb(15).size() - 2);
  expect_triangles(region({circle({0, 0}, 3, 64)}), 62);
  expect_triangles(region({circle({0, 0}, 3, 64), circle({0, 0}, 1, 40)}), 104);
  expect_triangles(region({square(0, 0, 9), square(1, 1, 2), square(4, 4, 2)}), 14);
}

TEST(Triangulation, annulus_with_cocircular_points_anywhere) {
  for (const double scale : {1e-3, 1.0, 1e6})
    for (const double angle : {0.0, 0.1, 1.0}) {
      const auto place = [&](const Points& points) { return transformed(points, angle, scale, {1e5, -1e5}); };
      expect_triangles(region({place(circle({0, 0}, 100, 300)), place(circle({0, 0}, 60, 200))}), 500);
    }
}

TEST(Triangulation, long_constraint_across_many_points) {
  // A saw whose blade is one segment: no tooth may be joined across it.
  Points points{{0, 0}, {1000, 0}};
  for (int i = 500; i-- > 0;) points.push_back({2.0 * i + 1, i % 2 ? 1e-3 : 30.0});
  expect_triangles(region({points}), points.size() - 2);
}

// The edge between two regions crosses all the Delaunay edges between their points, which are much nearer to
// each other.
TEST(Triangulation, long_constraint_between_close_chains) {
  for (const double angle : {0.0, 0.7})
    for (const double bend : {0.0, 1e-9, 1e-6}) {
      const int n = 3000;
      Points upper{{0, 0}, {2.0 * n, 0}}, lower{{2.0 * n - 1, -5}};
      const auto height = [&](int i) { return 1e-3 + bend * i * (n - i); };
      for (int i = n; i-- > 1;) upper.push_back({2.0 * i, height(i)});
      for (int i = n; i-- > 1;) lower.push_back({2.0 * i - 0.5, -height(i)});
      lower.push_back({1, -5});
      const auto [points, loops] =
          flattened(region({transformed(upper, angle, 1, {}), transformed(lower, angle, 1, {})}));
      const auto result = triangulate(points, loops);
      ASSERT_TRUE(result) << to_line(result.error());
      EXPECT_TRUE(verify_triangulation(*result, loops).empty());
    }
}

TEST(Triangulation, grid_of_inner_points) {
  Points points = square(0, 0, 20);
  for (int i = 1; i < 20; ++i)
    for (int j = 1; j < 20; ++j) points.push_back({1.0 * i, 1.0 * j});
  points.push_back({30, 5});  // outside: in no triangle
  const Loops loops{{0, 1, 2, 3}};
  const auto result = triangulate(points, loops);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->triangles.size(), 2u + 2 * 19 * 19);
  EXPECT_TRUE(verify_triangulation(*result, loops).empty());
}

TEST(Triangulation, loops_may_share_points) {
  const Points points{{0, 0}, {4, 0}, {8, 0}, {8, 8}, {0, 8}, {2, 4}, {6, 4}};
  const Loops touching_hole{{0, 1, 2, 3, 4}, {1, 5, 6}};
  const auto result = triangulate(points, touching_hole);
  ASSERT_TRUE(result) << to_line(result.error());
  EXPECT_EQ(result->triangles.size(), 6u);
  EXPECT_TRUE(verify_triangulation(*result, touching_hole).empty());
}

TEST(Triangulation, two_outer_loops_are_two_regions) {
  auto [points, loops] = flattened(region({square(0, 0, 1), square(5, 0, 1)}));
  const auto result = triangulate(points, loops);
  ASSERT_TRUE(result);
  EXPECT_EQ(result->triangles.size(), 4u);
  EXPECT_TRUE(verify_triangulation(*result, loops).empty());
}

TEST(Triangulation, failures_name_the_points) {
  const Points corners = square(0, 0, 4);
  const Loops loop{{0, 1, 2, 3}};
  EXPECT_EQ(code({{0, 0}, {1, 1}}, loop), "delaunay.too_few_points");
  EXPECT_EQ(code(corners, {}), "delaunay.no_loops");
  EXPECT_EQ(code(corners, {{0, 1}}), "delaunay.short_loop");
  EXPECT_EQ(code(corners, {{0, 1, 4}}), "delaunay.bad_index");
  EXPECT_EQ(code(corners, {{0, 1, -1}}), "delaunay.bad_index");
  EXPECT_EQ(code(corners, {{0, 1, 1, 2}}), "delaunay.repeated_edge");
  EXPECT_EQ(code(corners, {{0, 1, 2, 1}}), "delaunay.repeated_edge");
  EXPECT_EQ(code(corners, {{0, 2, 1, 3}}), "delaunay.crossing");
  EXPECT_EQ(code(corners, {{3, 2, 1, 0}}), "delaunay.orientation");
  EXPECT_EQ(code({{0, 0}, {1, 1}, {2, 2}, {3, 3}}, loop), "delaunay.point_on_edge");
  EXPECT_EQ(code({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 0}}, loop), "delaunay.point_on_edge");
  EXPECT_EQ(code({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {4, 4}}, loop), "delaunay.duplicate");
  EXPECT_EQ(code({{0, 0}, {4, 0}, {4, 4}, {0, std::numeric_limits<double>::infinity()}}, loop),
            "delaunay.range");
  EXPECT_EQ(triangulate({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 0}}, loop).error().entity, "point 4");
}

TEST(Triangulation, a_hole_the_wrong_way_round_fails) {
  const auto [points, loops] = flattened(region({square(0, 0, 9), square(3, 3, 3)}));
  EXPECT_EQ(code(points, loops), "delaunay.orientation");
}

TEST(Triangulation, verification_finds_faults) {
  const auto [points, loops] = flattened(region({{{0, 0}, {4, 0}, {5, 1}, {0, 1}}}));
  const auto good = triangulate(points, loops);
  ASSERT_TRUE(good);
  Triangulation turned = *good;
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_FALSE(verify_triangulation(turned, loops).empty());
  Triangulation short_of_one = *good;
  short_of_one.triangles.pop_back();
  short_of_one.neighbours.pop_back();
  EXPECT_FALSE(verify_triangulation(short_of_one, loops).empty());
  Triangulation moved = *good;
  moved.points[1] = {40, 0};  // the diagonal is no longer Delaunay, or a triangle is turned over
  moved.points[2] = {1, 1};
  EXPECT_FALSE(verify_triangulation(moved, loops).empty());
  EXPECT_FALSE(verify_triangulation(*good, {{0, 1, 2}}).empty());
}

// The triangles as sets of points' places, independent of numbers.
std::set<std::set<std::pair<double, double>>> shape_of(const Triangulation& t) {
  std::set<std::set<std::pair<double, double>>> result;
  for (const Triangle& triangle : t.triangles) {
    std::set<std::pair<double, double>> places;
    for (const Index i : triangle) places.insert({t.points[i].x, t.points[i].y});
    result.insert(places);
  }
  return result;
}

RC_GTEST_PROP(Triangulation, random_domains_with_holes, ()) {
  std::vector<Points> loops{random_star(10, 20)};
  for (const Vec2 centre : {Vec2{-2, 0}, Vec2{2, 0}})
    loops.push_back(transformed(random_star(0.1, 1.9), 0, 1, centre));
  const double angle = *rc::gen::inRange(0, 628) * 0.01, scale = std::pow(10, *rc::gen::inRange(-3, 7));
  for (Points& points : loops) points = transformed(points, angle, scale, {1e5, -1e5});
  const auto checked = checked_region(region(loops));
  RC_ASSERT(checked.has_value());
  const auto [points, indices] = flattened(*checked);
  const auto result = triangulate(points, indices);
  RC_ASSERT(result.has_value());
  RC_ASSERT(verify_triangulation(*result, indices).empty());
  RC_ASSERT(result->triangles.size() == points.size() + 2);
}

RC_GTEST_PROP(Triangulation, the_order_of_points_does_not_matter, ()) {
  const Points star = random_star(5, 20);
  const Index n = static_cast<Index>(star.size());
  std::vector<Index> loop(n), turned(n);
  const Index shift = *rc::gen::inRange(0, n);
  Points points(n);
  for (Index i = 0; i < n; ++i) {
    loop[i] = i;
    turned[i] = (i + shift) % n;
    points[turned[i]] = star[i];
  }
  const auto a = triangulate(star, {loop}), b = triangulate(points, {turned});
  RC_ASSERT(a.has_value());
  RC_ASSERT(b.has_value());
  RC_ASSERT(shape_of(*a) == shape_of(*b));
}

// Points of a small grid in any order, most of them collinear or cocircular with others.
RC_GTEST_PROP(Triangulation, inner_points_on_a_coarse_grid, ()) {
  std::set<std::pair<int, int>> chosen;
  for (int i = 0; i < 80; ++i) chosen.insert({*rc::gen::inRange(1, 12), *rc::gen::inRange(1, 12)});
  Points points = square(0, 0, 12);
  for (const auto& [x, y] : chosen) points.push_back({1.0 * x, 1.0 * y});
  const Loops loops{{0, 1, 2, 3}};
  const auto result = triangulate(points, loops);
  RC_ASSERT(result.has_value());
  RC_ASSERT(verify_triangulation(*result, loops).empty());
}

}  // namespace
}  // namespace beadmesh
