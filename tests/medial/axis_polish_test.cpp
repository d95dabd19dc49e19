#include "beadmesh/medial/axis_polish.h"

#include <gtest/gtest.h>

#include "medial/sampled_shape.h"

namespace beadmesh {
namespace {

TEST(Polish, JunctionOfThreeWallsIsTheIncentre) {
  const BoundaryCurve curve(shapes::region_of({{{0, 0}, {40, 0}, {0, 30}}}), radians(160));
  Circle circle{{7, 12}, 9};
  const auto feet = polish(curve, {{0, 0, 1}, {0, 1, 1}, {0, 2, 1}}, circle);
  ASSERT_EQ(feet.size(), 3u);
  EXPECT_LT(distance(circle.centre, {10, 10}), 1e-12);
  EXPECT_NEAR(circle.radius, 10, 1e-12);
}

TEST(Polish, TwoWallsMoveItAlongTheLineBetweenTheFeet) {
  const BoundaryCurve curve(shapes::rectangle(100, 20), radians(160));
  AxisPoint point{{{33, 7}, 8}, {BoundaryPlace{0, 0, 0.5}, BoundaryPlace{0, 2, 0.1}}, {}};
  ASSERT_TRUE(polish(curve, point));
  EXPECT_LT(distance(curve.point(point.feet[1]), {33, 20}), 1e-12);
  EXPECT_LT(distance(point.circle.centre, {33, 10}), 1e-12);
  EXPECT_LT(distance(point.across, {0, -20}), 1e-12);
}

TEST(Polish, WallAndReflexCornerGiveAParabola) {
  const BoundaryCurve curve(shapes::region_of({{{0, 0}, {80, 0}, {80, 20}, {20, 20}, {20, 70}, {0, 70}}}),
                            radians(160));
  AxisPoint point{{{14, 9}, 9}, {BoundaryPlace{0, 0, 0.5}, BoundaryPlace{0, 2, 1}}, {}};
  ASSERT_TRUE(polish(curve, point));
  EXPECT_NEAR(point.circle.centre.y, distance(point.circle.centre, {20, 20}), 1e-12);
  EXPECT_NEAR(point.circle.radius, point.circle.centre.y, 1e-12);
}

TEST(Polish, FailsWhereAllFeetAreOne) {
  const BoundaryCurve curve(shapes::rectangle(100, 20), radians(160));
  Circle circle{{33, 7}, 8};
  AxisPoint point{circle, {BoundaryPlace{0, 0, 0.3}, BoundaryPlace{0, 0, 0.3}}, {}};
  EXPECT_FALSE(polish(curve, point));
  EXPECT_EQ(point.circle.centre, (Vec2{33, 7}));
  EXPECT_TRUE(polish(curve, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, circle).empty());
  EXPECT_EQ(circle.centre, (Vec2{33, 7}));
}

TEST(RunOf, CoversTheSectorAndOneSampleMoreAtEitherEnd) {
  const shapes::SampledShape shape = shapes::sampled(shapes::stadium(100, 8));
  const SegmentRun run = run_of(shape.curve, shape.samples, {10, 12});
  EXPECT_EQ(run.segment, 9);
  EXPECT_EQ(run.count, 4);
  const auto n = static_cast<Index>(shape.samples.samples.size());
  const SegmentRun across = run_of(shape.curve, shape.samples, {n - 1, 0});
  EXPECT_EQ(across.segment, n - 2);
  EXPECT_EQ(across.count, 3);
  EXPECT_EQ(run_of(shape.curve, shape.samples, {5, 4}).count, n);
}

}  // namespace
}  // namespace beadmesh
