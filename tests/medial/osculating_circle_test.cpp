#include "beadmesh/medial/osculating_circle.h"

#include <gtest/gtest.h>

#include "medial/exact_region.h"
#include "medial/shapes.h"

namespace beadmesh {
namespace {

constexpr double corner_angle = radians(160);

TEST(OsculatingCircle, AtTheVertexOfAnEllipse) {
  const double a = 100, b = 60;
  const BoundaryCurve curve(exact_shapes::ellipse(a, b, {true, radians(5), 0.3}), corner_angle);
  const double length = curve.length(0);
  BoundaryPlace vertex;
  const auto circle = osculating_circle(curve, {0, length - 60, length + 70}, {{62, 1}, 37}, vertex);
  ASSERT_TRUE(circle);
  EXPECT_NEAR(circle->radius, b * b / a, 1e-10);
  EXPECT_LT(distance(curve.point(vertex), {a, 0}), 1e-5);
  EXPECT_LT(distance(circle->centre, {a - b * b / a, 0}), 1e-10);
}

TEST(OsculatingCircle, OfAnArcAnywhere) {
  const BoundaryCurve curve(exact_shapes::stadium(100, 8), corner_angle);
  const double start = 100;  // of the first half circle
  BoundaryPlace vertex;
  const auto circle = osculating_circle(curve, {0, start - 5, start + 28}, {{99, 0.5}, 8.2}, vertex);
  ASSERT_TRUE(circle);
  EXPECT_LT(distance(circle->centre, {100, 0}), 1e-12);
  EXPECT_NEAR(circle->radius, 8, 1e-12);
}

TEST(OsculatingCircle, NothingOnFacetsAndLines) {
  BoundaryPlace vertex;
  const BoundaryCurve facets(shapes::stadium(100, 8), corner_angle);
  EXPECT_FALSE(osculating_circle(facets, {0, 100, 125}, {{100, 0}, 8}, vertex));
  const BoundaryCurve box(shapes::rectangle(100, 20), corner_angle);
  EXPECT_FALSE(osculating_circle(box, {0, 20, 80}, {{50, 10}, 10}, vertex));
}

TEST(OsculatingCircle, NothingWhereTheCurvatureOnlyGrows) {
  const BoundaryCurve curve(exact_shapes::ellipse(100, 60), corner_angle);
  BoundaryPlace vertex;
  EXPECT_FALSE(osculating_circle(curve, {0, 20, 80}, {{62, 1}, 37}, vertex));
}

}  // namespace
}  // namespace beadmesh
