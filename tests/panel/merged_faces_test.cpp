#include <gtest/gtest.h>

#include "beadmesh/panel/chain.h"
#include "beadmesh/panel/panel.h"
#include "panel/panel_shapes.h"
#include "panel/split_faces.h"

namespace beadmesh {
namespace {

TEST(MergedFaces, TwoSquaresAreOneFaceWithoutTheEdgeBetween) {
  const Panel merged = with_merged_faces(test::two_squares(0.1), {{0, 1}});
  EXPECT_EQ(verify_panel(merged), std::vector<std::string>{});
  ASSERT_EQ(merged.faces.size(), 1u);
  EXPECT_EQ(merged.edges.size(), 6u);
  EXPECT_EQ(merged.faces[0].number, 1);
  EXPECT_EQ(input_numbers(merged, {0}), (std::vector<Index>{1, 2}));
  EXPECT_EQ(input_face_count(merged), 2u);
  ASSERT_EQ(merged.faces[0].loops.size(), 1u);
  EXPECT_EQ(merged.faces[0].loops[0].size(), 6u);
}

TEST(MergedFaces, DiscAndRingLoseTheCircleBetween) {
  const Panel panel = test::disc_in_ring(24);
  const Panel merged = with_merged_faces(panel, {{0, 1}});
  EXPECT_EQ(verify_panel(merged), std::vector<std::string>{});
  ASSERT_EQ(merged.faces.size(), 1u);
  ASSERT_EQ(merged.faces[0].loops.size(), 1u);
  EXPECT_EQ(merged.faces[0].facets.triangles.size(),
            panel.faces[0].facets.triangles.size() + panel.faces[1].facets.triangles.size());
}

TEST(MergedFaces, SplitAndMergedIsTheFaceAgain) {
  Panel panel = test::with_segment_edges(test::disc_in_ring(24));
  test::FaceSplitter(panel, 1).split([](Vec3 p) { return (p.x > 0) + 2 * (p.y > 0); });
  ASSERT_EQ(panel.faces.size(), 5u);
  ASSERT_EQ(verify_panel(panel), std::vector<std::string>{});
  const Panel merged = with_merged_faces(panel, {{1, 2, 3, 4}});
  EXPECT_EQ(verify_panel(merged), std::vector<std::string>{});
  ASSERT_EQ(merged.faces.size(), 2u);
  EXPECT_EQ(merged.faces[1].loops.size(), 2u);
  EXPECT_EQ(input_numbers(merged, {1}), (std::vector<Index>{2, 3, 4, 5}));
  EXPECT_EQ(chains_of(merged).chains.size(), 2u) << "both circles are smooth and closed";
}

TEST(MergedFaces, OthersStayAsTheyAre) {
  const Panel panel = test::disc_in_ring(24);
  const Panel same = with_merged_faces(panel, {{0}});
  EXPECT_EQ(same.edges.size(), panel.edges.size());
  EXPECT_EQ(same.faces[1].facets.triangles, panel.faces[1].facets.triangles);
  EXPECT_TRUE(same.faces[0].numbers.empty());
}

}  // namespace
}  // namespace beadmesh
