#include "beadmesh/medial/boundary_curve.h"

#include <gtest/gtest.h>

#include "medial/shapes.h"

namespace beadmesh {
namespace {

constexpr double corner_angle = radians(160);

SegmentRun whole(const BoundaryCurve& curve, Index loop) {
  return {loop, 0, curve.segments(loop)};
}

TEST(BoundaryCurve, FacettedCircleBecomesRound) {
  const PlanarRegion region = shapes::region_of({shapes::circle({0, 0}, 20, {2, 0.05, 0})}, true);
  const BoundaryCurve curve(region, corner_angle);
  for (int i = 0; i < 50; ++i) {
    const Vec2 at{5 * std::cos(0.13 * i), 5 * std::sin(0.13 * i)};
    EXPECT_NEAR(curve.nearest(at, whole(curve, 0)).distance, 15, 1e-5);  // the chords are 0.025 off
  }
}

TEST(BoundaryCurve, PolygonStaysAPolygon) {
  const BoundaryCurve curve(shapes::rectangle(100, 20), corner_angle);
  const Contact foot = curve.nearest({30, 6}, whole(curve, 0));
  EXPECT_EQ(foot.point, (Vec2{30, 0}));
  EXPECT_NEAR(curve.position(foot.place), 30, 1e-12);
  for (const bool corner : curve.tagged_region().loops[0].corner) EXPECT_TRUE(corner);
}

TEST(BoundaryCurve, LongLineBesideAnArcStaysStraight) {
  PlanarRegion region = shapes::stadium(100, 8, {200, 0.05, 0});
  const BoundaryCurve curve(region, corner_angle);
  EXPECT_NEAR(curve.nearest({50, 0}, whole(curve, 0)).distance, 8, 0.05);
}

TEST(BoundaryCurve, SingleBluntPointOfAPolygonIsNoCurve) {
  const BoundaryCurve curve(shapes::region_of({{{0, 0}, {50, -3}, {100, 0}, {100, 40}, {0, 40}}}),
                            corner_angle);
  const Contact foot = curve.nearest({25, 1}, SegmentRun{0, 0, 1});
  EXPECT_NEAR(std::abs(cross(Vec2{50, -3}, foot.point)), 0, 1e-10);
}

TEST(BoundaryCurve, NearestGoesOnDownhillButNotPastACorner) {
  const PlanarRegion region = shapes::region_of({shapes::circle({0, 0}, 20, {})}, true);
  const BoundaryCurve curve(region, corner_angle);
  EXPECT_LT(
      distance(normalized(curve.nearest({15, 0.1}, SegmentRun{0, 5, 2}).point), normalized(Vec2{15, 0.1})),
      1e-3);
  const BoundaryCurve box(shapes::rectangle(100, 20), corner_angle);
  EXPECT_EQ(box.nearest({99, 8}, SegmentRun{0, 0, 1}).place.segment, 0);
}

TEST(BoundaryCurve, SeesNoiseButNotFacets) {
  const PlanarRegion region = shapes::stadium(120, 10);
  EXPECT_EQ(BoundaryCurve(region, corner_angle).noise(), 0);
  const double noise = BoundaryCurve(shapes::noisy(region, 0.01, 5), corner_angle).noise();
  EXPECT_GT(noise, 0.005);
  EXPECT_LT(noise, 0.03);
}

TEST(BoundaryCurve, TurningIsPositiveWhereConvex) {
  const BoundaryCurve curve(shapes::annulus(40, 10), corner_angle);
  EXPECT_NEAR(curve.turning(curve.place_at(0, 30), 10), 20.0 / 40, 0.06);
  EXPECT_NEAR(curve.turning({1, 0, 0}, 5), 10.0 / 10 * (curve.tagged_region().loops[1].points.size() ? 1 : 0),
              0.3);
}

}  // namespace
}  // namespace beadmesh
