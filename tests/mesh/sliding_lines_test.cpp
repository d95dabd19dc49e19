#include "beadmesh/mesh/sliding_lines.h"

#include <gtest/gtest.h>

namespace beadmesh {
namespace {

const std::vector<Vec2> row{{0, 0}, {4, 0}, {8, 0}, {8, 6}, {8, 12}};
const std::vector<NodeFreedom> all_sliding(5, NodeFreedom::sliding);

TEST(SlidingLines, EndsOfAnOpenLineStay) {
  const SlidingLines lines({line_through({0, 1, 2, 3, 4}, row)}, all_sliding);
  EXPECT_FALSE(lines.slides(0));
  EXPECT_FALSE(lines.slides(4));
  for (const Index n : {1, 2, 3}) EXPECT_TRUE(lines.slides(n));
  EXPECT_FALSE(lines.slides(17)) << "no node of the line";
}

TEST(SlidingLines, NodesFollowTheLineRoundItsBend) {
  SlidingLines lines({line_through({0, 1, 2, 3, 4}, row)}, all_sliding);
  EXPECT_LT(distance(lines.shifted(1, 2), {6, 0}), 1e-12);
  EXPECT_LT(distance(lines.shifted(2, 3), {8, 3}), 1e-12);
  lines.slide(2, 3);
  EXPECT_DOUBLE_EQ(lines.lines()[0].at[2], 11);
  EXPECT_DOUBLE_EQ(lines.shift_to_middle(1), 1.5);
}

TEST(SlidingLines, NodesStayBetweenTheirNeighbours) {
  SlidingLines lines({line_through({0, 1, 2, 3, 4}, row)}, all_sliding);
  lines.slide(1, 100);
  EXPECT_LT(lines.lines()[0].at[1], lines.lines()[0].at[2]);
  lines.slide(2, -100);
  EXPECT_GT(lines.lines()[0].at[2], lines.lines()[0].at[1]);
}

TEST(SlidingLines, EveryNodeOfAClosedLineSlidesOverItsStart) {
  const std::vector<Vec2> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  SlidingLines lines({line_through({0, 1, 2, 3, 0}, square)},
                     std::vector<NodeFreedom>(4, NodeFreedom::sliding));
  for (Index n = 0; n < 4; ++n) EXPECT_TRUE(lines.slides(n));
  EXPECT_LT(distance(lines.shifted(0, -2), {0, 2}), 1e-12);
  EXPECT_LT(distance(lines.shifted(3, 5), {0, 5}), 1e-12);
  lines.slide(0, -2);
  EXPECT_DOUBLE_EQ(lines.shift_to_middle(3), -1) << "between 20 and 38";
}

TEST(SlidingLines, WhatIsNotFreeToSlideStays) {
  std::vector<NodeFreedom> freedom = all_sliding;
  freedom[2] = NodeFreedom::fixed;
  freedom[3] = NodeFreedom::free;
  const SlidingLines lines({line_through({0, 1, 2, 3, 4}, row)}, freedom);
  EXPECT_TRUE(lines.slides(1));
  EXPECT_FALSE(lines.slides(2));
  EXPECT_FALSE(lines.slides(3));
}

TEST(SlidingLines, NodeOfTwoLinesStays) {
  const SlidingLines lines({line_through({0, 1, 2}, row), line_through({3, 1, 4}, row)}, all_sliding);
  EXPECT_FALSE(lines.slides(1));
}

TEST(SlidingLines, KnowsTheNodesOfCrests) {
  SlidingLine boundary = line_through({3, 4}, row);
  boundary.is_crest = false;
  const SlidingLines lines({line_through({0, 1, 2}, row), boundary}, all_sliding);
  for (const Index n : {0, 1, 2}) EXPECT_TRUE(lines.on_crest(n));
  EXPECT_FALSE(lines.on_crest(3));
}

TEST(SlidingLines, KnowsTheNeighboursOfTips) {
  const SlidingLines crest({line_through({0, 1, 2, 3, 4}, row)}, all_sliding);
  EXPECT_TRUE(crest.next_to_tip(1));
  EXPECT_TRUE(crest.next_to_tip(3));
  for (const Index n : {0, 2, 4}) EXPECT_FALSE(crest.next_to_tip(n));
  SlidingLine boundary = line_through({0, 1, 2}, row);
  boundary.is_crest = false;
  EXPECT_FALSE(SlidingLines({boundary}, all_sliding).next_to_tip(1));
}

}  // namespace
}  // namespace beadmesh
