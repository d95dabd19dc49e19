#include "beadmesh/mesh/size_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

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

/// A straight line of 40, then a quarter circle of radius 20 in 30 chords.
TEST(SizeField, ChordLimitShortensEdgesOnCurves) {
  Panel panel;
  Chain chain;
  const auto add = [&](Vec3 p) {
    chain.arc_length.push_back(
        panel.points.empty() ? 0 : chain.arc_length.back() + distance(panel.points.back(), p));
    chain.points.push_back(Index(panel.points.size()));
    panel.points.push_back(p);
  };
  for (int i = 0; i < 8; ++i) add({5.0 * i, 0, 0});
  for (int i = 0; i <= 30; ++i) add({40 + 20 * std::sin(pi / 60 * i), 0, 20 - 20 * std::cos(pi / 60 * i)});
  const SizeField field(5, {}, {0.05, 2});
  const double fine = std::sqrt(8 * 0.05 * 20);
  EXPECT_NEAR(field.size_on_curvature(1 / 20.0), fine, 1e-12);
  EXPECT_EQ(field.size_on_curvature(1), 2) << "not below the finest";
  EXPECT_EQ(SizeField(5, {}).size_on_curvature(1), 1e300);
  const ChainSizing sizing = field.along(panel, chain);
  EXPECT_NEAR(sizing.count(), 40 / 5.0 + 10 * pi / fine, 0.4);
  const auto stations = sizing.stations(int(std::lround(sizing.count())));
  for (size_t i = 1; i < stations.size(); ++i)
    EXPECT_NEAR(stations[i] - stations[i - 1],
                stations[i] < 36       ? 5
                : stations[i - 1] > 43 ? fine
                                       : 4,
                1)
        << stations[i];
}

TEST(SizeField, ChordLimitOfACylinder) {
  Facets facets;
  for (int i = 0; i <= 20; ++i)
    for (const double y : {0.0, 100.0})
      facets.points.push_back({20 * std::sin(0.05 * i), y, 20 * std::cos(0.05 * i)});
  for (Index i = 0; i < 20; ++i) {
    facets.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 1});
    facets.triangles.push_back({2 * i + 1, 2 * i + 2, 2 * i + 3});
  }
  struct Cylinder : SurfaceEvaluator {
    Vec3 point(Vec2 uv) const override { return {20 * std::sin(uv.x), uv.y, 20 * std::cos(uv.x)}; }
    Vec3 normal(Vec2 uv) const override { return {std::sin(uv.x), 0, std::cos(uv.x)}; }
  };
  facets.surfaces = {std::make_shared<Cylinder>()};
  facets.triangle_surface.assign(facets.triangles.size(), 0);
  for (const Triangle& t : facets.triangles) {
    const auto uv = [&](Index n) { return Vec2{0.05 * (n / 2), n % 2 ? 100.0 : 0.0}; };
    facets.triangle_uv.push_back({uv(t[0]), uv(t[1]), uv(t[2])});
  }
  EXPECT_NEAR(SizeField(5, {}, {0.05, 1}).of_face(facets), std::sqrt(8 * 0.05 * 20), 0.05);
  EXPECT_EQ(SizeField(5, {}).of_face(facets), 5);
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
