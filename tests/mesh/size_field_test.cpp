#include "beadmesh/mesh/size_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

/// A square of side 200 about the origin in the plane z = 0, two facets; and a chain along y = 0.
Panel square() {
  Panel panel;
  panel.points = {{-100, 0, 0}, {100, 0, 0}};
  PanelFace face;
  face.facets.points = {{-100, -100, 0}, {100, -100, 0}, {100, 100, 0}, {-100, 100, 0}};
  face.facets.triangles = {{0, 1, 2}, {0, 2, 3}};
  panel.faces.push_back(face);
  return panel;
}

Chain middle_line() {
  Chain chain;
  chain.points = {0, 1};
  chain.arc_length = {0, 200};
  return chain;
}

TEST(SizeField, HoldsInTheBallAndFadesOutAroundIt) {
  const SizeField field(6, {{{0, 0, 0}, 20, 2}});
  EXPECT_EQ(field.at({0, 0, 0}), 2);
  EXPECT_EQ(field.at({0, 12, 16}), 2);
  EXPECT_DOUBLE_EQ(field.at({28, 0, 0}), 4) << "8 mm outside, 0.25 a mm";
  EXPECT_EQ(field.at({36, 0, 0}), 6);
  EXPECT_EQ(field.at({90, 0, 0}), 6);
}

TEST(SizeField, MayBeCoarserAndTheLaterBallWins) {
  const SizeField field(5, {{{0, 0, 0}, 30, 2}, {{0, 0, 0}, 10, 8}});
  EXPECT_EQ(field.at({0, 0, 0}), 8);
  EXPECT_DOUBLE_EQ(field.at({14, 0, 0}), 7);
  EXPECT_EQ(field.at({30, 0, 0}), 3) << "the earlier, pulled up by the later";
}

TEST(SizeField, AFaceHasAsManyElementsAsTheField) {
  const Panel panel = square();
  EXPECT_EQ(SizeField(5, {}).of_face(panel.faces[0].facets), 5);
  EXPECT_NEAR(SizeField(5, {{{0, 0, 0}, 300, 3}}).of_face(panel.faces[0].facets), 3, 1e-12);
  EXPECT_EQ(SizeField(5, {{{500, 0, 0}, 30, 3}}).of_face(panel.faces[0].facets), 5);
  // A disc of size 4 in size 5: its ramp is 4 mm wide.
  const double r = 60, inside = pi * r * r / 16;
  double ramp = 0;
  for (int i = 0; i < 4000; ++i) {
    const double d = (i + 0.5) / 1000, h = 4 + 0.25 * d;
    ramp += 2 * pi * (r + d) / 1000 / (h * h);
  }
  const double elements = inside + ramp + (40000 - pi * 64 * 64) / 25;
  EXPECT_NEAR(SizeField(5, {{{0, 0, 0}, r, 4}}).of_face(panel.faces[0].facets), std::sqrt(40000 / elements),
              0.005);
}

TEST(SizeField, StationsFollowTheSizeAlongAChain) {
  const Panel panel = square();
  const ChainSizing sizing = SizeField(5, {{{0, 0, 0}, 30, 2.5}}).along(panel, middle_line());
  EXPECT_EQ(sizing.finest, 2.5);
  const double ramp = std::log(2.0) / 0.25;
  EXPECT_NEAR(sizing.count(), 60 / 2.5 + 2 * ramp + (200 - 60 - 20) / 5.0, 0.05);
  const int n = int(std::lround(sizing.count()));
  const auto stations = sizing.stations(n);
  ASSERT_EQ(int(stations.size()), n + 1);
  EXPECT_EQ(stations.front(), 0);
  EXPECT_EQ(stations.back(), 200);
  for (int i = 0; i < n; ++i) {
    const double step = stations[i + 1] - stations[i], middle = (stations[i] + stations[i + 1]) / 2;
    const double outside = std::max(0.0, std::abs(middle - 100) - 30);
    EXPECT_NEAR(step, std::min(5.0, 2.5 + 0.25 * outside), 0.2) << "at " << middle;
  }
}

TEST(SizeField, WithoutBallsStationsAreEven) {
  const auto stations = SizeField(5, {}).along(square(), middle_line()).stations(8);
  for (int i = 0; i <= 8; ++i) EXPECT_DOUBLE_EQ(stations[i], 25 * i);
}

TEST(SizeField, LocalSizesThatMakeNoSenseAreRefused) {
  EXPECT_TRUE(check_local_sizes({{{0, 0, 0}, 10, 2.5}}, 2.5));
  for (const LocalSize& bad :
       {LocalSize{{0, 0, 0}, 0, 3}, LocalSize{{0, 0, 0}, 10, -3}, LocalSize{{0, 0, 0}, 10, 2},
        LocalSize{{std::nan(""), 0, 0}, 10, 3}, LocalSize{{0, 0, 0}, HUGE_VAL, 3}}) {
    const auto good = check_local_sizes({bad}, 2.5);
    ASSERT_FALSE(good);
    EXPECT_EQ(good.error().code, "control.local_size");
  }
}

}  // namespace
}  // namespace beadmesh
