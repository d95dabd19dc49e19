#include "beadmesh/blocking/chord.h"

#include <gtest/gtest.h>

#include "blocking/layout_check.h"
#include "medial/shapes.h"

namespace beadmesh {
namespace {

using namespace shapes;

/// A stadium from (0, 0) to (60, 0), half width 8, cut at x = 50 towards its tip at (68, 0).
class EndCapBase : public ::testing::Test {
 protected:
  EndCapBase() : region_(stadium(60, 8, {1, 0.01})), builder_(region_) {
    const double arc = builder_.loop_length(0) / 2 - 60;  // a cap
    chord_.right = builder_.add_boundary_vertex({0, 50});
    chord_.middle = builder_.add_vertex({50, 0});
    chord_.left = builder_.add_boundary_vertex({0, 60 + arc + 10});
    tip_ = builder_.add_boundary_vertex({0, 60 + arc / 2});
  }

  PlanarRegion region_;
  BlockLayoutBuilder builder_;
  Chord chord_;
  Index tip_;
};

class EndCap : public EndCapBase, public ::testing::WithParamInterface<int> {};

TEST_P(EndCap, IsAClampWithTwoIrregularNodesAtMost) {
  const int m = GetParam();
  add_chord_edges(builder_, chord_, m, true);
  EXPECT_EQ(chord_.left_path.size(), m >= 4 ? 3 : 2);
  add_end_cap(builder_, chord_, tip_, {{55, 0}, {62, 0}}, {m, 8, 5, 2.5});
  auto layout = builder_.take();
  ASSERT_TRUE(layout);
  EXPECT_EQ(layout->blocks.size(), m == 2 ? 2 : 6);
  const auto counted = assign_counts(*layout, flat_lengths(*layout), {5, 2.5});
  ASSERT_TRUE(counted) << counted.error().message;
  expect_counted(*layout);
  EXPECT_EQ(boundary_count(*layout) % 2, 0);
  const auto across = [&](const std::vector<Index>& path) {
    int count = 0;
    for (size_t i = 1; i < path.size(); ++i)
      for (const VirtualEdge& e : layout->edges)
        if ((e.start == path[i - 1] && e.end == path[i]) || (e.start == path[i] && e.end == path[i - 1]))
          count += e.count;
    return count;
  };
  EXPECT_EQ(across(chord_.left_path), m / 2);
  EXPECT_EQ(across(chord_.right_path), m / 2);
  double area = 0;
  for (const Block& block : layout->blocks) {
    EXPECT_GT(polygon_area(outline(*layout, block)), 0);
    area += polygon_area(outline(*layout, block));
  }
  EXPECT_NEAR(area, 10 * 16 + 32 * pi, 0.5);
}

TEST_P(EndCap, HasTheCrestAsALineToTheTip) {
  add_chord_edges(builder_, chord_, GetParam(), true);
  add_end_cap(builder_, chord_, tip_, {{55, 0}, {62, 0}}, {GetParam(), 8, 5, 2.5});
  const auto layout = builder_.take();
  ASSERT_TRUE(layout);
  double length = 0;
  for (const VirtualEdge& edge : layout->edges) {
    if (edge.kind != VirtualEdgeKind::ridge) continue;
    for (const Vec2 p : edge.points) EXPECT_NEAR(p.y, 0, 1e-2);
    for (size_t i = 1; i < edge.points.size(); ++i) length += distance(edge.points[i - 1], edge.points[i]);
  }
  EXPECT_NEAR(length, 18, 0.02);
}

TEST_F(EndCapBase, WithoutACoreBendsSixtyDegreesFromTheTip) {
  add_chord_edges(builder_, chord_, 2, true);
  add_end_cap(builder_, chord_, tip_, {{55, 0}, {62, 0}}, {2, 8, 5, 2.5});
  const auto layout = builder_.take();
  ASSERT_TRUE(layout);
  int bends = 0;
  for (const VirtualEdge& edge : layout->edges) {
    if (edge.kind != VirtualEdgeKind::boundary || edge.count != 1) continue;
    EXPECT_NEAR(distance(edge.points.front(), edge.points.back()), 8, 0.2);
    ++bends;
  }
  EXPECT_EQ(bends, 2);
}

TEST_F(EndCapBase, WithoutACoreKeepsTheMinimumAtTheTip) {
  add_chord_edges(builder_, chord_, 2, true);
  add_end_cap(builder_, chord_, tip_, {{55, 0}, {62, 0}}, {2, 8, 12, 9});
  const auto layout = builder_.take();
  ASSERT_TRUE(layout);
  for (const VirtualEdge& edge : layout->edges)
    if (edge.kind == VirtualEdgeKind::boundary && edge.count == 1) {
      EXPECT_GE(distance(edge.points.front(), edge.points.back()), 9);
    }
}

INSTANTIATE_TEST_SUITE_P(Across, EndCap, ::testing::Values(2, 4, 6, 8));

TEST(Chord, TurnedSeesLeftAndRightSwapped) {
  const Chord chord{3, 1, 2, 5, {1, 7, 2}, {2, 8, 5}};
  const Chord turned = chord.turned();
  EXPECT_EQ(turned.left, 5);
  EXPECT_EQ(turned.right, 1);
  EXPECT_EQ(turned.left_path, (std::vector<Index>{5, 8, 2}));
  EXPECT_EQ(turned.right_path, (std::vector<Index>{2, 7, 1}));
  EXPECT_EQ(turned.turned().left_path, chord.left_path);
}

TEST(Chord, WithoutACapIsTwoEdges) {
  const PlanarRegion region = stadium(60, 8);
  BlockLayoutBuilder builder(region);
  Chord chord;
  chord.left = builder.add_boundary_vertex({0, 20});
  chord.middle = builder.add_vertex({20, 0});
  chord.right = builder.add_boundary_vertex({0, 110});
  add_chord_edges(builder, chord, 6, false);
  EXPECT_EQ(builder.layout().edges.size(), 2);
  EXPECT_EQ(builder.layout().edges[0].count, 3);
}

}  // namespace
}  // namespace beadmesh
