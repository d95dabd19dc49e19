#include "beadmesh/medial/radius_along.h"

#include <gtest/gtest.h>

#include "medial/exact_region.h"

namespace beadmesh {
namespace {

/// On the axis x of two circles of radius 10 about (0, 30) and (0, -30) from outside: radius hypot(x, 30)
/// - 10.
MedialPoint between_circles(double x) {
  const double reach = std::hypot(x, 30);
  const auto foot = [&](double y) { return Foot{Vec2{0, y} + Vec2{x, -y} * (10 / reach), 0, 0}; };
  return {{x, 0}, reach - 10, {foot(30), foot(-30)}, 0};
}

// The error of a cubic over 8 mm: 8^4 / 384 of the fourth derivative, 3 / 30^3.
TEST(RadiusAlong, FindsTheNeckBetweenTwoPoints) {
  const RadiusAlong radius(between_circles(-3), between_circles(5));
  EXPECT_NEAR(radius.least(), 20, 1.3e-3);
  EXPECT_NEAR(radius.greatest(), std::hypot(5, 30) - 10, 1e-12);
  EXPECT_NEAR(radius.at(0.5), std::hypot(1, 30) - 10, 1.3e-3);
  double sum = 0;
  for (int i = 0; i < 1000; ++i) sum += (std::hypot(-3 + 8 * (i + 0.5) / 1000, 30) - 10) / 1000;
  EXPECT_NEAR(radius.mean(), sum, 1.3e-3);
}

TEST(RadiusAlong, IsLinearInAWedgeFromItsCorner) {
  const MedialPoint corner{{0, 0}, 0, {Foot{}, Foot{}}, 0};
  const Vec2 foot{4 * 0.8 * 0.8, 4 * 0.8 * 0.6};  // of a wedge with the sine 0.6
  const MedialPoint inside{{4, 0}, 2.4, {Foot{foot, 0, 0}, Foot{{foot.x, -foot.y}, 0, 0}}, 0};
  const RadiusAlong radius(corner, inside);
  EXPECT_NEAR(radius.at(0.25), 0.6, 1e-12);
  EXPECT_NEAR(radius.mean(), 1.2, 1e-12);
  EXPECT_EQ(radius.least(), 0);
}

TEST(RadiusAlong, WithoutFeetOnTheCircleItIsALine) {
  const MedialPoint a{{0, 0}, 3, {Foot{{0, 9}, 0, 0}, Foot{{0, -9}, 0, 0}}, 0};
  const MedialPoint b{{10, 0}, 5, {Foot{{0, 9}, 0, 0}, Foot{{0, -9}, 0, 0}}, 0};
  EXPECT_NEAR(RadiusAlong(a, b).at(0.3), 3.6, 1e-12);
}

TEST(RadiusAlong, ThicknessOfAnEllipseIsItsMinorAxis) {
  const auto object = medial_object(exact_shapes::ellipse(50, 25, {true, radians(7.5), 0.37}));
  ASSERT_TRUE(object);
  ASSERT_EQ(object->edges.size(), 1u);
  EXPECT_NEAR(object->edges[0].thickness.max, 50, 1e-3);
  EXPECT_NEAR(object->edges[0].thickness.min, 25, 1e-9);
}

}  // namespace
}  // namespace beadmesh
