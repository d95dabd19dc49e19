#include "beadmesh/geometry/polyline.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace beadmesh {
namespace {

const std::vector<Vec2> corner{{0, 0}, {3, 0}, {3, 4}};

TEST(Polyline, open_lengths_and_points) {
  const Polyline<Vec2> line(corner);
  EXPECT_EQ(line.segments(), 2);
  EXPECT_DOUBLE_EQ(line.length(), 7);
  EXPECT_EQ(line.point_at(-1), (Vec2{0, 0}));
  EXPECT_EQ(line.point_at(1.5), (Vec2{1.5, 0}));
  EXPECT_EQ(line.point_at(5), (Vec2{3, 2}));
  EXPECT_EQ(line.point_at(99), (Vec2{3, 4}));
  EXPECT_EQ(line.direction_at(5), (Vec2{0, 1}));
  EXPECT_EQ(line.segment_at(3), 1);
}

TEST(Polyline, closed_goes_round) {
  const Polyline<Vec2> loop(corner, true);
  EXPECT_EQ(loop.segments(), 3);
  EXPECT_DOUBLE_EQ(loop.length(), 12);
  EXPECT_EQ(loop.point_at(13), (Vec2{1, 0}));
  EXPECT_EQ(loop.point_at(-1).x, loop.point_at(11).x);
  EXPECT_NEAR(distance(loop.point_at(9.5), Vec2{1.5, 2}), 0, 1e-12);
}

TEST(Polyline, resampled_keeps_ends) {
  const auto points = Polyline<Vec2>(corner).resampled(7);
  ASSERT_EQ(points.size(), 8u);
  EXPECT_EQ(points[3], (Vec2{3, 0}));
  EXPECT_EQ(points.back(), (Vec2{3, 4}));
  EXPECT_EQ(Polyline<Vec2>(corner, true).resampled(6).size(), 6u);
}

TEST(Polyline, single_and_repeated_points) {
  const Polyline<Vec3> point({{1, 2, 3}});
  EXPECT_EQ(point.length(), 0);
  EXPECT_EQ(point.point_at(5), (Vec3{1, 2, 3}));
  EXPECT_EQ(point.nearest({1, 2, 5}).distance, 2);
  const Polyline<Vec3> twice({{0, 0, 0}, {0, 0, 0}, {0, 0, 2}, {0, 0, 2}});
  EXPECT_EQ(twice.point_at(1), (Vec3{0, 0, 1}));
  EXPECT_EQ(twice.point_at(2), (Vec3{0, 0, 2}));
}

TEST(Polyline, nearest_point) {
  const Polyline<Vec2> line(corner);
  const auto inside = line.nearest({1, 1});
  EXPECT_EQ(inside.point, (Vec2{1, 0}));
  EXPECT_EQ(inside.position, 1);
  EXPECT_EQ(line.nearest({4, 9}).position, 7);
}

RC_GTEST_PROP(Polyline, a_point_on_it_is_its_own_nearest, (int k)) {
  const Polyline<Vec2> loop({{0, 0}, {10, 1}, {7, 8}, {-2, 5}}, true);
  const Vec2 p = loop.point_at(k * 0.01);
  RC_ASSERT(loop.nearest(p).distance < 1e-12);
}

}  // namespace
}  // namespace beadmesh
