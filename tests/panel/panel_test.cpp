#include "beadmesh/panel/panel.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "panel/panel_shapes.h"

namespace beadmesh {
namespace {

TEST(VerifyPanel, AcceptsSoundPanels) {
  EXPECT_EQ(verify_panel(test::two_squares()), std::vector<std::string>{});
  EXPECT_EQ(verify_panel(test::disc_in_ring()), std::vector<std::string>{});
}

TEST(VerifyPanel, FindsWhatIsBroken) {
  const auto breaks = [](auto change) {
    Panel panel = test::two_squares();
    change(panel);
    return !verify_panel(panel).empty();
  };
  EXPECT_TRUE(breaks([](Panel& p) { p.edges[0].points[1] = 99; }));
  EXPECT_TRUE(breaks([](Panel& p) { p.edges[0].faces.pop_back(); }));
  EXPECT_TRUE(breaks([](Panel& p) { p.faces[0].facets.triangles.pop_back(); }));
  EXPECT_TRUE(breaks(
      [](Panel& p) { std::swap(p.faces[0].facets.triangles[0][1], p.faces[0].facets.triangles[0][2]); }));
  EXPECT_TRUE(breaks([](Panel& p) { std::swap(p.faces[0].loops[0][0], p.faces[0].loops[0][1]); }));
  EXPECT_TRUE(breaks([](Panel& p) { p.points[0].x += 1; }));
  EXPECT_TRUE(breaks([](Panel& p) { p.faces[1].facets.triangle_surface[0] = 1; }));
}

TEST(VerifyPanel, FindsFacesThatDisagreeInOrientation) {
  Panel panel = test::two_squares();
  PanelFace& face = panel.faces[1];
  for (Triangle& t : face.facets.triangles) std::swap(t[1], t[2]);
  std::reverse(face.facets.loops[0].begin() + 1, face.facets.loops[0].end());
  std::reverse(face.loops[0].begin(), face.loops[0].end());
  for (EdgeUse& use : face.loops[0]) use.reversed = !use.reversed;
  EXPECT_EQ(verify_panel(panel).size(), 1u);
}

TEST(FacetsOf, OneFaceIsAsItIs) {
  const Panel panel = test::two_squares();
  EXPECT_EQ(facets_of(panel, {1}).triangles, panel.faces[1].facets.triangles);
}

TEST(FacetsOf, TwoSquaresAreOnePieceWithOneLoop) {
  const Facets joined = facets_of(test::two_squares(), {0, 1});
  EXPECT_EQ(joined.points.size(), 6u);
  ASSERT_EQ(joined.loops.size(), 1u);
  EXPECT_EQ(joined.loops[0].size(), 6u);
  EXPECT_EQ(joined.triangle_surface, (std::vector<Index>{0, 0, 1, 1}));
}

TEST(FacetsOf, DiscAndRingAreADisc) {
  const Facets joined = facets_of(test::disc_in_ring(24), {1, 0});
  ASSERT_EQ(joined.loops.size(), 1u);
  EXPECT_EQ(joined.loops[0].size(), 24u);
  EXPECT_NEAR(area(joined), 24 * 2 * std::sin(2 * pi / 24), 1e-12);
}

TEST(Diagonal, IsThatOfTheBox) {
  EXPECT_DOUBLE_EQ(diagonal(test::two_squares(2)), 3);
}

TEST(Diagonal, OfNothingIsZero) {
  EXPECT_EQ(diagonal(Panel{}), 0);
}

}  // namespace
}  // namespace beadmesh
