#include "beadmesh/mesh/loop_connection.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mesh/sample_loops.h"

namespace beadmesh {
namespace {

TEST(LoopConnection, JoinsAHoleByAStraightLineThereAndBack) {
  NodeLoops loops;
  const NodeLoop outer = test::add_loop(loops, test::rectangle(12, 9, 12, 9));
  const NodeLoop hole =
      test::add_loop(loops, {{5, 3}, {5, 4}, {5, 5}, {5, 6}, {6, 6}, {7, 6}, {7, 5}, {7, 4}, {7, 3}, {6, 3}});
  MeshDraft draft(loops, nullptr, 1);
  const NodeLoop joined = connect_loops(draft, {outer, hole});
  // Three edges, as (6, 0) - (6, 3), walked twice.
  EXPECT_EQ(joined.size(), outer.size() + hole.size() + 6);
  EXPECT_EQ(draft.nodes().size(), loops.nodes.size() + 2);
  EXPECT_NEAR(signed_area(draft.nodes(), joined), 12 * 9 - 6, 1e-9);
}

TEST(LoopConnection, SplicesAScarAtACommonNode) {
  NodeLoops loops;
  const NodeLoop outer = test::add_loop(loops, test::rectangle(4, 4, 4, 4));
  loops.nodes.push_back({2, 1});
  loops.nodes.push_back({2, 2});
  const NodeLoop scar{2, 16, 17, 16};
  MeshDraft draft(loops, nullptr, 1);
  const NodeLoop joined = connect_loops(draft, {outer, scar});
  EXPECT_EQ(joined.size(), outer.size() + 4);
  EXPECT_EQ(std::count(joined.begin(), joined.end(), 2), 2);
  EXPECT_EQ(std::count(joined.begin(), joined.end(), 17), 1);
  for (std::size_t i = 0; i < joined.size(); ++i) {
    EXPECT_NEAR(distance(draft.at(joined[i]), draft.at(joined[(i + 1) % joined.size()])), 1, 1e-12);
  }
}

TEST(LoopConnection, OtherParityIsOffered) {
  NodeLoops loops;
  const NodeLoop outer = test::add_loop(loops, test::circle({0, 0}, 10, 40));
  const NodeLoop hole = test::add_loop(loops, test::circle({0, 0}, 6, 24, true));
  MeshDraft draft(loops, nullptr, 1.5), other(loops, nullptr, 1.5);
  EXPECT_NE(connect_loops(draft, {outer, hole}), connect_loops(other, {outer, hole}, true));
}

}  // namespace
}  // namespace beadmesh
