#include "beadmesh/medial/axis_smoothing.h"

#include <gtest/gtest.h>

namespace beadmesh {
namespace {

std::vector<Vec2> zigzag(int n, double amplitude) {
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i) points.push_back({1.0 * i, (i % 2 ? 1 : -1) * amplitude});
  points.front().y = points.back().y = 0;
  return points;
}

double mean_square(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value / static_cast<double>(values.size());
  return sum;
}

double roughness(const std::vector<Vec2>& points) {
  std::vector<double> heights;
  for (const Vec2 p : points) heights.push_back(p.y);
  return std::sqrt(mean_square(heights));
}

TEST(CubicSmoothing, DampsAZigzagEachPass) {
  std::vector<Vec2> points = zigzag(41, 0.1);
  double before = roughness(points);
  for (int pass = 0; pass < 4; ++pass) {
    smooth_cubic(points, false);
    EXPECT_LT(roughness(points), (pass < 2 ? 0.85 : 1.0) * before) << "pass " << pass;
    before = roughness(points);
  }
}

TEST(CubicSmoothing, KeepsEndsAndStraightLinesAndParabolas) {
  std::vector<Vec2> line, parabola;
  for (int i = 0; i < 12; ++i) {
    line.push_back({0.5 * i, 0.25 * i});
    parabola.push_back({1.0 * i - 5.5, 0.01 * (i - 5.5) * (i - 5.5)});
  }
  const std::vector<Vec2> straight = line, curved = parabola;
  smooth_cubic(line, false);
  smooth_cubic(parabola, false);
  EXPECT_EQ(line.front(), straight.front());
  EXPECT_EQ(line.back(), straight.back());
  for (std::size_t i = 0; i < line.size(); ++i) {
    EXPECT_LT(distance(line[i], straight[i]), 1e-12);
    EXPECT_LT(distance(parabola[i], curved[i]), 5e-3);
  }
}

TEST(CubicSmoothing, WrapsAroundAClosedLine) {
  std::vector<Vec2> ring;
  for (int i = 0; i < 60; ++i) {
    const double t = 2 * pi * i / 60, r = 10 + (i % 2 ? 0.05 : -0.05);
    ring.push_back({r * std::cos(t), r * std::sin(t)});
  }
  for (int pass = 0; pass < 3; ++pass) smooth_cubic(ring, true);
  std::vector<double> off;
  for (const Vec2 p : ring) off.push_back(norm(p) - 10);
  EXPECT_LT(std::sqrt(mean_square(off)), 0.025);
}

TEST(CubicSmoothing, LeavesShortAndCoincidentLinesAlone) {
  std::vector<Vec2> two{{0, 0}, {1, 1}}, same(6, Vec2{1, 2});
  const std::vector<Vec2> two_before = two, same_before = same;
  smooth_cubic(two, false);
  smooth_cubic(same, true);
  EXPECT_EQ(two, two_before);
  EXPECT_EQ(same, same_before);
}

}  // namespace
}  // namespace beadmesh
