#include "beadmesh/mesh/mesh_draft.h"

#include <gtest/gtest.h>

#include "mesh/sample_loops.h"

namespace beadmesh {
namespace {

NodeLoops graded_loop() {
  NodeLoops loops;
  // Edges of 0.5 on the left, of 2 on the right.
  test::add_loop(loops, test::polygon({{0, 0}, {20, 0}, {20, 8}, {0, 8}}, {20, 4, 20, 16}));
  return loops;
}

TEST(MeshDraft, LinesAreGradedBetweenTheSpacingsOfTheirEnds) {
  const NodeLoops loops = graded_loop();
  MeshDraft draft(loops, nullptr, 1);
  const Index right = 22, left = 52;  // (20, 4) and (0, 4)
  ASSERT_EQ(draft.at(right), (Vec2{20, 4}));
  ASSERT_EQ(draft.at(left), (Vec2{0, 4}));
  EXPECT_GT(draft.edge_count(left, right), 12);
  EXPECT_LT(draft.edge_count(left, right), 30);
  const auto line = draft.add_line(left, right, 18);
  ASSERT_EQ(line.size(), 19u);
  const double first = distance(draft.at(line[0]), draft.at(line[1]));
  const double last = distance(draft.at(line[17]), draft.at(line[18]));
  EXPECT_GT(last, 2 * first);
  for (std::size_t i = 0; i + 1 < line.size(); ++i) EXPECT_TRUE(draft.has_edge(line[i], line[i + 1]));
}

TEST(MeshDraft, TakesBackAndPutsAgain) {
  const NodeLoops loops = graded_loop();
  MeshDraft draft(loops, nullptr, 1);
  const MeshDraft::Mark mark = draft.mark();
  const Index node = draft.add_node({1, 1});
  draft.add_element({0, 1, node, 59});
  EXPECT_EQ(draft.valence(0), 1);
  const MeshDraft::Piece piece = draft.take_back(mark);
  EXPECT_EQ(draft.nodes().size(), loops.nodes.size());
  EXPECT_EQ(draft.valence(0), 0);
  EXPECT_FALSE(draft.has_edge(1, node));
  EXPECT_TRUE(draft.has_edge(0, 1));  // of the loop: was there before
  draft.put(piece);
  EXPECT_EQ(draft.valence(node), 1);
  EXPECT_TRUE(draft.has_edge(1, node));
  EXPECT_EQ(draft.elements().size(), 1u);
}

TEST(MeshDraft, AnAreaIsADraftOfItsOwn) {
  const NodeLoops loops = graded_loop();
  MeshDraft whole(loops, nullptr, 1);
  const Index first = whole.add_node({1, 1});
  whole.add_element({0, 1, first, 59});
  const std::vector<Index> nodes{0, 1, 2, first};
  MeshDraft area(whole, nodes);
  EXPECT_TRUE(area.has_edge(0, 1)) << "of the loop";
  EXPECT_TRUE(area.has_edge(1, 3)) << "of an element of the whole";
  EXPECT_FALSE(area.has_edge(0, 2));
  EXPECT_EQ(area.valence(3), 1);
  EXPECT_EQ(area.fixed_nodes(), 3) << "the last of the four is not on the whole's loops";
  EXPECT_EQ(area.surface_length(0, 3), whole.surface_length(0, first));

  const MeshDraft::Mark mark = area.mark();
  area.add_element({1, 2, area.add_node({2, 1}), 3});
  const MeshDraft::Piece piece = area.take_back(mark);
  const Index meanwhile = whole.add_node({3, 3});
  whole.put(piece, nodes);
  EXPECT_EQ(whole.elements().back(), (MeshElement{1, 2, meanwhile + 1, first}));
  EXPECT_EQ(whole.at(meanwhile + 1), (Vec2{2, 1}));
  EXPECT_EQ(whole.valence(first), 2);
}

}  // namespace
}  // namespace beadmesh
