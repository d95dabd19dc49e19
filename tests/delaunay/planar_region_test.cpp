#include "beadmesh/delaunay/planar_region.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "delaunay/shapes.h"

namespace beadmesh {
namespace {

using namespace shapes;

void expect_failure(const PlanarRegion& input, const std::string& what, const std::string& loop,
                    const std::string& in_message = {}) {
  const auto checked = checked_region(input);
  ASSERT_FALSE(checked) << what;
  EXPECT_EQ(checked.error().code, "delaunay.region." + what);
  EXPECT_EQ(checked.error().entity, loop);
  EXPECT_NE(checked.error().message.find(in_message), std::string::npos) << checked.error().message;
}

TEST(PlanarRegion, area_and_diagonal) {
  EXPECT_DOUBLE_EQ(signed_area({square(1e5, 1e5, 2), {}, {}}), 4);
  EXPECT_DOUBLE_EQ(signed_area({reversed(square(0, 0, 2)), {}, {}}), -4);
  EXPECT_DOUBLE_EQ(diagonal(region({{{0, 0}, {3, 0}, {3, 4}}})), 5);
  EXPECT_EQ(diagonal({}), 0);
}

TEST(PlanarRegion, contains_what_is_inside_the_outer_loop_and_in_no_hole) {
  const PlanarRegion ring = region({square(0, 0, 10), square(3, 3, 4)});
  EXPECT_TRUE(contains(ring, {1, 5}));
  EXPECT_TRUE(contains(ring, {1, 3})) << "level with corners of the hole";
  EXPECT_FALSE(contains(ring, {5, 5}));
  EXPECT_FALSE(contains(ring, {-1, 3}));
  EXPECT_FALSE(contains(ring, {11, 7}));
}

TEST(PlanarRegion, orders_and_orients) {
  const auto checked =
      checked_region(region({square(1, 1, 2), reversed(square(0, 0, 9)), reversed(square(5, 5, 2))}));
  ASSERT_TRUE(checked) << to_line(checked.error());
  EXPECT_DOUBLE_EQ(signed_area(checked->loops[0]), 81);
  EXPECT_DOUBLE_EQ(signed_area(checked->loops[1]), -4);
  EXPECT_EQ(checked->loops[1].points.front(), (Vec2{1, 1}));
  EXPECT_EQ(checked->loops[2].points.front(), (Vec2{5, 7})) << "already clockwise: unchanged";
}

// The upper half of a disc, clockwise: three arcs of 60 degrees from (-1, 0), and the chord back.
PlanarRegion half_disc() {
  PlanarRegion half;
  half.curves = {nullptr, std::make_shared<CircularArc>(Vec2{0, 0}, 1.0)};
  PlanarLoop& loop = half.loops.emplace_back();
  for (const double angle : {180.0, 120.0, 60.0, 0.0}) {
    loop.points.push_back({std::cos(radians(angle)), std::sin(radians(angle))});
    loop.corner.push_back(angle == 180 || angle == 0);
    loop.curve.push_back(angle == 0 ? no_index : 1);
    loop.parameters.push_back({radians(angle), radians(angle - 60)});
  }
  return half;
}

TEST(PlanarRegion, attributes_turn_with_the_loop) {
  const PlanarRegion input = half_disc();
  const auto checked = checked_region(input);
  ASSERT_TRUE(checked) << to_line(checked.error());
  const PlanarLoop& loop = checked->loops[0];
  const Points& before = input.loops[0].points;
  EXPECT_EQ(loop.points, (Points{before[0], before[3], before[2], before[1]}));
  EXPECT_EQ(loop.corner, (std::vector<bool>{true, true, false, false}));
  EXPECT_EQ(loop.curve, (std::vector<Index>{no_index, 1, 1, 1}));
  for (int i = 1; i < 4; ++i) {
    EXPECT_DOUBLE_EQ(loop.parameters[i][0], radians(60.0 * (i - 1)));
    EXPECT_DOUBLE_EQ(loop.parameters[i][1], radians(60.0 * i));
  }
  EXPECT_EQ(checked->curves, input.curves);
}

TEST(PlanarRegion, curves_must_exist_and_pass_through_the_points) {
  PlanarRegion missing = half_disc();
  missing.loops[0].curve[1] = 2;
  expect_failure(missing, "attributes", "loop 1", "segment 2");
  missing.loops[0].curve[1] = 0;  // exists, but is null
  expect_failure(missing, "attributes", "loop 1", "segment 2");
  PlanarRegion beside = half_disc();
  beside.loops[0].parameters[2][1] += 1e-3;
  expect_failure(beside, "attributes", "loop 1", "point 4");
  beside.loops[0].parameters[2][1] = std::numeric_limits<double>::quiet_NaN();
  expect_failure(beside, "attributes", "loop 1", "point 4");
  PlanarRegion short_list = half_disc();
  short_list.loops[0].parameters.pop_back();
  expect_failure(short_list, "attributes", "loop 1", "3 parameter");
}

TEST(PlanarRegion, bad_loops) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Points good = square(0, 0, 10);
  expect_failure({}, "empty", "");
  expect_failure(region({good, {{1, 1}, {2, 2}}}), "few_points", "loop 2");
  expect_failure(region({{{0, 0}, {1, nan}, {1, 1}}}), "not_finite", "loop 1", "point 2");
  expect_failure(region({{{0, 0}, {1, 0}, {1, 0}, {1, 1}}}), "repeated_point", "loop 1",
                 "point 2 of loop 1 and point 3 of loop 1");
  expect_failure(region({{{0, 0}, {1, 0}, {1, 1}, {0, 0}}}), "repeated_point", "loop 1",
                 "point 4 of loop 1 and point 1 of loop 1");
  expect_failure(region({good, {{1, 1}, {2, 2}, {3, 3}, {5, 5}}}), "zero_area", "loop 2");
  PlanarRegion attributes = region({good});
  attributes.loops[0].corner = {true};
  expect_failure(attributes, "attributes", "loop 1");
}

TEST(PlanarRegion, crossing_and_touching) {
  const Points good = square(0, 0, 10);
  expect_failure(region({{{0, 0}, {2, 2}, {2, 0}, {0, 3}}}), "crossing", "loop 1", "crosses");
  expect_failure(region({good, square(5, 5, 10)}), "crossing", "loop 1", "loop 2");
  expect_failure(region({good, square(5, 5, 5)}), "touching", "loop 2", "(10, 10)");
  expect_failure(region({good, {{1, 1}, {10, 5}, {1, 5}}}), "touching", "loop 2",
                 "point 2 of loop 2 (10, 5)");
  expect_failure(region({{{0, 0}, {4, 0}, {2, 2}, {4, 4}, {0, 4}, {2, 2}}}), "touching", "loop 1", "(2, 2)");
  expect_failure(region({{{0, 0}, {4, 0}, {4, 4}, {4, 0}, {2, 9}}}), "touching", "loop 1");
}

TEST(PlanarRegion, misplaced_loops) {
  const Points good = square(0, 0, 10);
  expect_failure(region({square(20, 0, 2), good}), "outside", "loop 1", "loop 2");
  expect_failure(region({good, square(1, 1, 8), square(2, 2, 3)}), "nested", "loop 3");
}

TEST(PlanarRegion, errors_use_the_callers_names) {
  const PointName name = [](std::size_t loop, std::size_t point) {
    return "corner " + std::to_string(10 * loop + point);
  };
  const auto crossing = checked_region(region({square(0, 0, 10), square(5, 5, 10)}), name);
  ASSERT_FALSE(crossing);
  EXPECT_NE(crossing.error().message.find("corner 13 (5, 15)"), std::string::npos)
      << crossing.error().message;
  EXPECT_EQ(crossing.error().message.find("point"), std::string::npos) << crossing.error().message;
  const auto outside = checked_region(region({square(0, 0, 10), square(50, 5, 10)}), name);
  ASSERT_FALSE(outside);
  EXPECT_EQ(outside.error().entity, "loop 2");
  EXPECT_NE(outside.error().message.find("corner 10 (50, 5)"), std::string::npos) << outside.error().message;
}

TEST(PlanarRegion, a_wound_strip_of_many_points) {
  Points outer, inner;
  for (int i = 0; i < 20'000; ++i) {
    const double t = 10 + 0.01 * i;
    outer.push_back((t + 2) * Vec2{std::cos(t), std::sin(t)});
    inner.push_back(t * Vec2{std::cos(t), std::sin(t)});
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  EXPECT_TRUE(checked_region(region({outer})));
  std::swap(outer[100], outer[5000]);
  EXPECT_EQ(checked_region(region({outer})).error().code, "delaunay.region.crossing");
}

RC_GTEST_PROP(PlanarRegion, any_order_direction_and_place_gives_the_same_area, ()) {
  std::vector<Points> loops{random_star(10, 20)};
  for (const Vec2 centre : {Vec2{-2, 0}, Vec2{2, 0}})
    loops.push_back(transformed(random_star(0.5, 1.5), 0, 1, centre));
  const double angle = *rc::gen::inRange(0, 628) * 0.01, scale = std::pow(10, *rc::gen::inRange(-3, 7));
  for (Points& points : loops) {
    points = transformed(points, angle, scale, {1e5 * scale, 0});
    if (*rc::gen::arbitrary<bool>()) points = reversed(points);
  }
  std::swap(loops[0], loops[*rc::gen::inRange(0, 3)]);
  const auto checked = checked_region(region(loops));
  RC_ASSERT(checked.has_value());
  RC_ASSERT(signed_area(checked->loops[0]) > 0);
  RC_ASSERT(signed_area(checked->loops[1]) < 0);
  RC_ASSERT(signed_area(checked->loops[2]) < 0);
}

}  // namespace
}  // namespace beadmesh
