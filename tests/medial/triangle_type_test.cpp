#include "beadmesh/medial/triangle_type.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "medial/shapes.h"

namespace beadmesh {
namespace {

TEST(Circumcircle, OfARightTriangle) {
  const Circle circle = circumcircle({0, 0}, {4, 0}, {0, 3});
  EXPECT_LT(distance(circle.centre, {2, 1.5}), 1e-14);
  EXPECT_NEAR(circle.radius, 2.5, 1e-14);
}

TEST(Circumcircle, FarFromTheOriginAndDegenerate) {
  const Circle far = circumcircle({1e6, 1e6}, {1e6 + 4, 1e6}, {1e6, 1e6 + 3});
  EXPECT_LT(distance(far.centre, {1e6 + 2, 1e6 + 1.5}), 1e-8);
  EXPECT_NEAR(circumcircle({0, 0}, {1, 0}, {3, 0}).radius, 1.5, 1e-14);
}

TEST(TriangleTypes, OfAStripAndASingleTriangle) {
  // Four triangles in a row: 0 1 2 | 1 3 2 | 2 3 4 | 3 5 4.
  Triangulation strip;
  strip.points = {{0, 0}, {2, 0}, {0, 2}, {2, 2}, {0, 4}, {2, 4}};
  strip.triangles = {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}};
  strip.neighbours = {{1, no_index, no_index}, {2, 0, no_index}, {3, no_index, 1}, {no_index, 2, no_index}};
  BoundarySamples samples;
  for (const Vec2 p : strip.points) samples.samples.push_back({p});
  samples.samples[0].corner = true;
  const std::vector<TriangleType> types = triangle_types(strip, samples);
  EXPECT_EQ(types, (std::vector{TriangleType::C, TriangleType::N, TriangleType::N, TriangleType::S}));
  EXPECT_EQ(ear_tip(strip, 0), 0);
  EXPECT_EQ(ear_tip(strip, 3), 5);

  Triangulation single;
  single.points = {{0, 0}, {2, 0}, {0, 2}};
  single.triangles = {{0, 1, 2}};
  single.neighbours = {{no_index, no_index, no_index}};
  EXPECT_EQ(triangle_types(single, samples), std::vector{TriangleType::isolated});
}

}  // namespace
}  // namespace beadmesh
