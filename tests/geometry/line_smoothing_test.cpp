#include "beadmesh/geometry/line_smoothing.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace beadmesh {
namespace {

constexpr int sample_count = 400;
constexpr double circle_radius = 10, sample_step = 2 * pi * circle_radius / sample_count;

Vec3 on_circle(int i, double r = circle_radius) {
  return {r * std::cos(2 * pi * i / sample_count), r * std::sin(2 * pi * i / sample_count), 3};
}

double farthest_from_circle(const std::vector<Vec3>& line) {
  double most = 0;
  for (const Vec3 p : line) most = std::max(most, std::abs(std::hypot(p.x, p.y) - circle_radius));
  return most;
}

TEST(LineSmoothing, LeavesACircleAlone) {
  std::vector<Vec3> points;
  for (int i = 0; i < sample_count; ++i) points.push_back(on_circle(i));
  EXPECT_LT(farthest_from_circle(smoothed_line(points, sample_step, std::vector<bool>(sample_count, false))),
            0.005);
}

TEST(LineSmoothing, ToothDoesNotDrawTheLine) {
  std::vector<Vec3> points;
  for (int i = 0; i < sample_count; ++i)
    points.push_back(on_circle(i, i >= 100 && i < 108 ? circle_radius + 0.6 : circle_radius));
  EXPECT_LT(farthest_from_circle(smoothed_line(points, sample_step, std::vector<bool>(sample_count, false))),
            0.05);
}

TEST(LineSmoothing, ZigzagBecomesItsMiddle) {
  std::vector<Vec3> points;
  for (int i = 0; i < sample_count; ++i)
    points.push_back(on_circle(i, i % 8 < 4 ? circle_radius + 0.5 : circle_radius - 0.5));
  LineSmoothingOptions options;
  options.wavelength = 8;
  EXPECT_LT(farthest_from_circle(
                smoothed_line(points, sample_step, std::vector<bool>(sample_count, false), options)),
            0.05);
}

TEST(LineSmoothing, CornersStay) {
  std::vector<Vec3> points;
  std::vector<bool> corners;
  const std::vector<Vec3> square{{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0}};
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < 100; ++i) {
      points.push_back(lerp(square[side], square[(side + 1) % 4], i / 100.0));
      corners.push_back(i == 0);
    }
  const std::vector<Vec3> line = smoothed_line(points, 0.2, corners);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LT(distance(points[i], line[i]), 0.01);
}

}  // namespace
}  // namespace beadmesh
