#include "beadmesh/blocking/element_counts.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>

#include "blocking/layout_check.h"
#include "medial/shapes.h"

namespace beadmesh {
namespace {

using namespace shapes;

TEST(ElementCounts, AcrossIsEvenAndNearTheSize) {
  const ElementCountOptions options{5, 2.5};
  EXPECT_EQ(elements_across(16, 16, options), 4);
  EXPECT_EQ(elements_across(10, 10, options), 2);
  EXPECT_EQ(elements_across(30, 30, options), 6);
  EXPECT_EQ(elements_across(16, 10, options), 2) << "four do not fit where it is narrowest";
  EXPECT_EQ(elements_across(3, 2, options), 2) << "never less";
}

RC_GTEST_PROP(ElementCounts, AcrossKeepsTheMinimumLength, ()) {
  const double size = *rc::gen::inRange(20, 120) / 10.0, min_edge = size * *rc::gen::inRange(10, 95) / 100;
  const double narrowest = *rc::gen::inRange(10, 1000) / 10.0,
               width = narrowest * *rc::gen::inRange(100, 200) / 100;
  const int m = elements_across(width, narrowest, {size, min_edge});
  RC_ASSERT(m >= 2 && m % 2 == 0);
  RC_ASSERT(m == 2 || narrowest / m >= min_edge);
}

/// A grid of blocks over a rectangle, `heights` times `widths`; all edges straight.
BlockLayout grid(const std::vector<double>& widths, const std::vector<double>& heights) {
  BlockLayout layout;
  const Index columns = Index(widths.size()), rows = Index(heights.size());
  double y = 0;
  for (Index j = 0; j <= rows; ++j) {
    double x = 0;
    for (Index i = 0; i <= columns; ++i) {
      layout.vertices.push_back({{x, y}, false, {}});
      if (i < columns) x += widths[i];
    }
    if (j < rows) y += heights[j];
  }
  const auto vertex = [&](Index i, Index j) { return j * (columns + 1) + i; };
  const auto add_edge = [&](Index a, Index b) {
    VirtualEdge edge;
    edge.start = a, edge.end = b;
    edge.points = {layout.vertices[a].point, layout.vertices[b].point};
    layout.edges.push_back(edge);
  };
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i < columns; ++i) add_edge(vertex(i, j), vertex(i + 1, j));
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i <= columns; ++i) add_edge(vertex(i, j), vertex(i, j + 1));
  const auto across = [&](Index i, Index j) { return j * columns + i; };
  const auto up = [&](Index i, Index j) { return columns * (rows + 1) + j * (columns + 1) + i; };
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i)
      layout.blocks.push_back({{BlockSide{{across(i, j)}, {false}}, BlockSide{{up(i + 1, j)}, {false}},
                                BlockSide{{across(i, j + 1)}, {true}}, BlockSide{{up(i, j)}, {true}}}});
  return layout;
}

TEST(ElementCounts, LengthsByTheSize) {
  BlockLayout layout = grid({20, 52}, {10});
  ASSERT_TRUE(assign_counts(layout, flat_lengths(layout), {5, 2.5}));
  expect_counted(layout);
  EXPECT_EQ(layout.edges[0].count, 4);
  EXPECT_EQ(layout.edges[1].count, 10);
  EXPECT_EQ(layout.edges[4].count, 2);
}

TEST(ElementCounts, SetCountsSpreadThroughTheirGroup) {
  BlockLayout layout = grid({20, 50}, {10, 10, 10});
  layout.edges[0].count = 7;  // lowest row, first column
  ASSERT_TRUE(assign_counts(layout, flat_lengths(layout), {5, 2.5}));
  expect_counted(layout);
  for (int j = 0; j <= 3; ++j) EXPECT_EQ(layout.edges[2 * j].count, 7);
  EXPECT_EQ(layout.edges[1].count, 10) << "the other column is free";
}

TEST(ElementCounts, SizeYieldsToTheMinimumLength) {
  BlockLayout layout = grid({10}, {10});
  ASSERT_TRUE(assign_counts(layout, flat_lengths(layout), {3, 2.9}));
  EXPECT_EQ(layout.edges[0].count, 3);
  BlockLayout short_one = grid({4}, {1});
  ASSERT_TRUE(assign_counts(short_one, flat_lengths(short_one), {5, 2.5}));
  EXPECT_EQ(short_one.edges[2].count, 1) << "shorter than the minimum, and still an element";
}

TEST(ElementCounts, LongSideIsNotOutvotedByTwoShortOnes) {
  BlockLayout layout = grid({20}, {10, 10});
  std::vector<double> lengths = flat_lengths(layout);
  lengths[1] = lengths[2] = 10;  // a crest that runs on into a mitre, and its two feet
  ASSERT_TRUE(assign_counts(layout, lengths, {5, 2.5}));
  EXPECT_EQ(layout.edges[0].count, 3);
}

TEST(ElementCounts, ContradictionIsSaid) {
  BlockLayout layout = grid({20}, {10});
  layout.edges[0].count = 4;
  layout.edges[1].count = 6;
  const auto counted = assign_counts(layout, flat_lengths(layout), {5, 2.5});
  ASSERT_FALSE(counted);
  EXPECT_EQ(counted.error().code, "blocking.counts.contradiction");
}

TEST(ElementCounts, UnequalCompositeSidesAreSaid) {
  // One block whose lower side is two edges with 2 + 3 elements, the upper one an edge with 4.
  BlockLayout layout = grid({20, 20}, {10});
  layout.edges[0].count = 2;
  layout.edges[1].count = 3;
  VirtualEdge top;
  top.start = 3, top.end = 5, top.count = 4;
  top.points = {layout.vertices[3].point, layout.vertices[5].point};
  layout.edges.push_back(top);
  layout.blocks = {{{BlockSide{{0, 1}, {false, false}}, BlockSide{{6}, {false}}, BlockSide{{7}, {true}},
                     BlockSide{{4}, {true}}}}};
  const auto lengths = flat_lengths(layout);
  const auto counted = assign_counts(layout, lengths, {5, 2.5});
  ASSERT_FALSE(counted);
  EXPECT_EQ(counted.error().code, "blocking.counts.unequal");
  layout.edges[7].count = 5;
  EXPECT_TRUE(assign_counts(layout, lengths, {5, 2.5}));
}

RC_GTEST_PROP(ElementCounts, OppositeSidesAreEqualAndNoEdgeIsTooShort, ()) {
  const auto sizes = rc::gen::container<std::vector<double>>(
      rc::gen::map(rc::gen::inRange(10, 600), [](int tenths) { return tenths / 10.0; }));
  const auto widths = *rc::gen::nonEmpty(sizes), heights = *rc::gen::nonEmpty(sizes);
  RC_PRE(widths.size() * heights.size() < 200);
  BlockLayout layout = grid(widths, heights);
  const auto lengths = flat_lengths(layout);
  RC_ASSERT(assign_counts(layout, lengths, {5, 2.5}).has_value());
  for (const Block& block : layout.blocks)
    for (int k = 0; k < 2; ++k)
      RC_ASSERT(count_on(layout, block.sides[k]) == count_on(layout, block.sides[k + 2]));
  for (size_t e = 0; e < lengths.size(); ++e) {
    RC_ASSERT(layout.edges[e].count >= 1);
    RC_ASSERT(layout.edges[e].count == 1 || lengths[e] / layout.edges[e].count >= 2.5);
  }
}

}  // namespace
}  // namespace beadmesh
