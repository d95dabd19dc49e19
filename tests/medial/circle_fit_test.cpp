#include "beadmesh/medial/circle_fit.h"

#include <gtest/gtest.h>

#include "medial/shapes.h"

namespace beadmesh {
namespace {

TEST(CircleFit, FindsTheCircleOfAnArcFromAfar) {
  std::vector<Vec2> points;
  shapes::add_arc(points, {3, -2}, 8, 0.4, 2.0, {});
  const auto fit = fitted_circle(points, {{5, 0}, 5});
  ASSERT_TRUE(fit);
  EXPECT_LT(distance(fit->centre, {3, -2}), 1e-10);
  EXPECT_NEAR(fit->radius, 8, 1e-10);
}

TEST(CircleFit, AveragesNoise) {
  const PlanarRegion region = shapes::noisy(shapes::region_of({shapes::circle({0, 0}, 8, {})}), 0.02, 3);
  const auto fit = fitted_circle(region.loops[0].points, {{1, 1}, 7});
  ASSERT_TRUE(fit);
  EXPECT_LT(norm(fit->centre), 0.02);
}

TEST(CircleFit, NothingFromTwoPointsOrALine) {
  EXPECT_FALSE(fitted_circle({{0, 0}, {1, 0}}, {{0, 1}, 1}));
  EXPECT_FALSE(fitted_circle({{0, 0}, {1, 0}, {2, 0}, {3, 0}}, {{1.5, 0}, 1}));
}

TEST(CircleFit, ArcIsSummedWithItsSign) {
  std::vector<Vec2> points;
  shapes::add_arc(points, {0, 0}, 5, 0, pi, {0.1, 0.01, 0});
  points.push_back({-5, 0});
  EXPECT_NEAR(arc_of(points, {0, 0}), pi, 1e-12);
  std::reverse(points.begin(), points.end());
  EXPECT_NEAR(arc_of(points, {0, 0}), -pi, 1e-12);
}

TEST(CircleFit, PointsNearAreThoseInTheBand) {
  EXPECT_EQ(points_near({{1, 0}, {0, 1.05}, {0, -1.2}}, {{0, 0}, 1}, 0.1).size(), 2u);
}

}  // namespace
}  // namespace beadmesh
