#include "beadmesh/mesh/node_loop.h"

#include <gtest/gtest.h>

#include "mesh/sample_loops.h"

namespace beadmesh {
namespace {

NodeLoop numbers(std::size_t count) {
  NodeLoop loop;
  for (std::size_t i = 0; i < count; ++i) loop.push_back(static_cast<Index>(i));
  return loop;
}

TEST(NodeLoop, AreaAndInsideOfASquare) {
  const auto points = test::rectangle(4, 2, 4, 2);
  const NodeLoop loop = numbers(points.size());
  EXPECT_DOUBLE_EQ(signed_area(points, loop), 8);
  EXPECT_DOUBLE_EQ(signed_area(points, NodeLoop(loop.rbegin(), loop.rend())), -8);
  EXPECT_TRUE(is_inside(points, loop, {1, 1}));
  EXPECT_FALSE(is_inside(points, loop, {5, 1}));
}

TEST(NodeLoop, AnglesOfCornersSidesAndScarTips) {
  const std::vector<Vec2> points{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}, {1, 1}};
  // Around the square, with a scar from the middle of the left side to its centre.
  const auto angles = interior_angles(points, {0, 1, 2, 3, 4, 5, 4});
  const std::vector<double> expected{90, 90, 90, 90, 90, 360, 90};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(degrees(angles[i]), expected[i], 1e-9);
}

TEST(NodeLoop, QuadsInAnAngle) {
  EXPECT_EQ(quads_in_angle(radians(20)), 1);
  EXPECT_EQ(quads_in_angle(radians(134)), 1);
  EXPECT_EQ(quads_in_angle(radians(136)), 2);
  EXPECT_EQ(quads_in_angle(2 * pi), 4);
}

TEST(LatticeWalk, RectangleIsCutIntoRectanglesWithoutDefect) {
  const auto points = test::rectangle(6, 4, 6, 4);
  const LatticeWalk walk(interior_angles(points, numbers(points.size())));
  EXPECT_EQ(walk.net_singularity(), 0);
  // From (2, 0) straight up to (2, 4): positions 2 and 14.
  EXPECT_EQ(walk.defect(2, 14, 4, 1, 1), (std::array<int, 2>{0, 0}));
  EXPECT_EQ(walk.defect(14, 2, 4, 1, 1), (std::array<int, 2>{0, 0}));
  // Two edges too many, and a line to the neighbour of the node opposite.
  EXPECT_EQ(walk.defect(2, 14, 6, 1, 1), (std::array<int, 2>{0, 2}));
  EXPECT_EQ(walk.defect(2, 15, 5, 1, 1), (std::array<int, 2>{0, 2}));
}

TEST(LatticeWalk, SmoothDiscNeedsFourIrregularNodes) {
  const auto points = test::circle({0, 0}, 10, 16);
  EXPECT_EQ(LatticeWalk(interior_angles(points, numbers(16))).net_singularity(), 4);
}

}  // namespace
}  // namespace beadmesh
