#include "beadmesh/mesh/boundary_row.h"

#include <gtest/gtest.h>

#include <cmath>

namespace beadmesh {
namespace {

void add_circle(NodeLoops& loops, Vec2 centre, double radius, int nodes, bool hole = false) {
  loops.loops.emplace_back();
  for (int i = 0; i < nodes; ++i) {
    const double angle = (hole ? -2 : 2) * pi * i / nodes;
    loops.loops.back().push_back(Index(loops.nodes.size()));
    loops.nodes.push_back(centre + Vec2{radius * std::cos(angle), radius * std::sin(angle)});
  }
}

TEST(BoundaryRow, ADiscGetsAConcentricRow) {
  NodeLoops loops;
  add_circle(loops, {3, -2}, 40, 50);
  const auto row = boundary_row(loops, {5, 2.5});
  ASSERT_TRUE(row);
  ASSERT_EQ(row->size(), 50u);
  for (Vec2 p : *row) EXPECT_NEAR(distance(p, Vec2{3, -2}), 40 - 4.5 / std::cos(pi / 50), 0.02);
}

TEST(BoundaryRow, NoEdgeOfItIsUnderTheMinimum) {
  for (int nodes = 14; nodes < 40; ++nodes) {
    NodeLoops loops;
    add_circle(loops, {0, 0}, 14, nodes);
    const auto row = boundary_row(loops, {5, 2.5});
    if (!row) continue;
    for (size_t i = 0; i < row->size(); ++i)
      EXPECT_GE(distance((*row)[i], (*row)[(i + 1) % row->size()]), 2.5);
  }
}

TEST(BoundaryRow, NoneWhereThereIsNoRoom) {
  NodeLoops tight;
  add_circle(tight, {0, 0}, 14, 34);  // 2.6 mm apart: the row would be under the minimum
  EXPECT_FALSE(boundary_row(tight, {5, 2.5}));
  NodeLoops holed;
  add_circle(holed, {0, 0}, 40, 50);
  add_circle(holed, {33, 0}, 4, 8, true);  // the row would run into the hole
  EXPECT_FALSE(boundary_row(holed, {5, 2.5}));
}

TEST(BoundaryRow, NoneAroundACorner) {
  NodeLoops square;
  square.loops.emplace_back();
  for (int side = 0; side < 4; ++side)
    for (int i = 0; i < 10; ++i) {
      const double t = 5.0 * i;
      const Vec2 at[4] = {{t, 0}, {50, t}, {50 - t, 50}, {0, 50 - t}};
      square.loops[0].push_back(Index(square.nodes.size()));
      square.nodes.push_back(at[side]);
    }
  EXPECT_FALSE(boundary_row(square, {5, 2.5}));
}

}  // namespace
}  // namespace beadmesh
