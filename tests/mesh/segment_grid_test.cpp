#include "beadmesh/mesh/segment_grid.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace beadmesh {
namespace {

TEST(SegmentGrid, SegmentsMeet) {
  EXPECT_TRUE(segments_meet({0, 0}, {2, 2}, {0, 2}, {2, 0}));
  EXPECT_TRUE(segments_meet({0, 0}, {2, 0}, {1, 0}, {1, 5}));   // touching
  EXPECT_TRUE(segments_meet({0, 0}, {2, 0}, {1, 0}, {5, 0}));   // overlapping
  EXPECT_FALSE(segments_meet({0, 0}, {2, 0}, {3, 0}, {5, 0}));  // on one line, apart
  EXPECT_FALSE(segments_meet({0, 0}, {2, 0}, {1, 1}, {1, 5}));
}

TEST(SegmentGrid, ClearanceSeesWallsAndNodes) {
  // A wall from (5, -1) to (5, 1) and one from (5, 2) to (5, 9), between 0 and 1; 2 and 3 look over them.
  const std::vector<Vec2> nodes{{0, 0}, {10, 0}, {0, 5},   {10, 1.5}, {5, -1}, {5, 1},
                                {5, 2}, {5, 9},  {0, 1.5}, {0, -3},   {10, -3}};
  const SegmentGrid grid(nodes, {{4, 5}, {5, 4}, {6, 7}, {7, 6}}, 3);
  EXPECT_LT(grid.clearance(0, 1), 0);
  EXPECT_LT(grid.clearance(2, 3), 0);
  EXPECT_NEAR(grid.clearance(8, 3), 0.5, 1e-12);
  EXPECT_NEAR(grid.clearance(9, 10), 2, 1e-12);
}

TEST(SegmentGrid, FirstCrossing) {
  const std::vector<Vec2> nodes{{0, 0}, {4, 0}, {2, 3}, {2, -1}, {9, 9}};
  EXPECT_EQ(SegmentGrid(nodes, {{0, 1}, {1, 2}, {2, 0}}, 0).first_crossing()[0], no_index);
  EXPECT_EQ(SegmentGrid(nodes, {{0, 1}, {4, 1}, {2, 3}}, 0).first_crossing(), (std::array<Index, 2>{0, 2}));
}

RC_GTEST_PROP(SegmentGrid, ClearanceIsThatOfAllPairs, ()) {
  std::vector<Vec2> nodes;
  const auto coordinates = *rc::gen::container<std::vector<int>>(24, rc::gen::inRange(0, 40));
  for (int i = 0; i < 24; i += 2) nodes.push_back({double(coordinates[i]), double(coordinates[i + 1])});
  std::vector<std::array<Index, 2>> edges;
  for (Index i = 2; i < 12; ++i) {
    const Index next = i == 11 ? 2 : i + 1;
    if (distance(nodes[i], nodes[next]) < 15) edges.push_back({i, next}), edges.push_back({next, i});
  }
  RC_PRE(nodes[0] != nodes[1]);
  double expected = 2;
  for (const auto& [a, b] : edges) {
    if (segments_meet(nodes[0], nodes[1], nodes[a], nodes[b])) expected = -1;
    if (expected >= 0) expected = std::min(expected, distance_to_segment(nodes[a], nodes[0], nodes[1]));
  }
  const double found = SegmentGrid(nodes, edges, 2).clearance(0, 1);
  const bool agrees = expected < 0 ? found < 0 : std::abs(found - expected) < 1e-9;
  RC_ASSERT(agrees);
}

}  // namespace
}  // namespace beadmesh
