#include "beadmesh/panel/chain.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "panel/panel_shapes.h"

namespace beadmesh {
namespace {

std::vector<Index> points_along(const ChainSet& set, const std::vector<ChainUse>& loop) {
  std::vector<Index> result;
  for (const ChainUse use : loop) {
    std::vector<Index> points = set.chains[use.chain].points;
    if (use.reversed) std::reverse(points.begin(), points.end());
    EXPECT_TRUE(result.empty() || result.back() == points.front());
    result.insert(result.end(), points.begin() + (result.empty() ? 0 : 1), points.end());
  }
  return result;
}

TEST(ChainsOf, CornersOfSquaresEndChains) {
  const ChainSet set = chains_of(test::two_squares());
  EXPECT_EQ(set.chains.size(), 7u);
  for (const Chain& chain : set.chains) EXPECT_EQ(chain.edges.size(), 1u);
}

TEST(ChainsOf, AVertexOfThreeFacesLinesEndsAChainThoughItIsStraight) {
  // (1, 0) is straight for the border, but the inner edge starts there.
  const ChainSet set = chains_of(test::two_squares());
  for (const Chain& chain : set.chains) EXPECT_LE(chain.points.size(), 2u);
}

TEST(ChainsOf, HalfCirclesBecomeOneClosedChain) {
  const ChainSet set = chains_of(test::disc_in_ring(24));
  ASSERT_EQ(set.chains.size(), 2u);
  const Chain& inner = set.chains[0];
  EXPECT_TRUE(inner.closed);
  EXPECT_EQ(inner.edges.size(), 2u);
  EXPECT_EQ(inner.points.front(), inner.points.back());
  EXPECT_EQ(inner.faces, (std::array<Index, 2>{0, 1}));
  EXPECT_EQ(set.chains[1].faces, (std::array<Index, 2>{1, no_index}));
  ASSERT_EQ(set.loops[1].size(), 2u);
  ASSERT_EQ(set.loops[1][1].size(), 1u);
  EXPECT_TRUE(set.loops[1][1][0].reversed);
}

TEST(ChainsOf, CornersAppearWhereTheAngleIsSmallEnough) {
  EXPECT_EQ(chains_of(test::disc_in_ring(24), radians(10)).chains.size(), 3u);
}

TEST(ChainsOf, AFreeEdgeUsedBackwardsStillHasItsFaceOnTheLeft) {
  Panel panel = test::two_squares();
  std::swap(panel.edges[5].points[0], panel.edges[5].points[1]);
  panel.faces[1].loops[0][1].reversed = true;
  const ChainSet set = chains_of(panel);
  for (const Chain& chain : set.chains) EXPECT_NE(chain.faces[0], no_index);
}

TEST(ChainsOf, ASeamHasItsFaceOnBothSides) {
  // A tube slit open along edge 0; the circles are edges 1 and 2.
  const int n = 8;
  Panel panel;
  for (int k = 0; k < 2; ++k)
    for (int i = 0; i < n; ++i)
      panel.points.push_back({std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), 1.0 * k});
  std::vector<Index> low, high;
  for (int i = 0; i <= n; ++i) low.push_back(i % n), high.push_back(n + i % n);
  test::add_edge(panel, {0, n});
  test::add_edge(panel, low);
  test::add_edge(panel, high);
  PanelFace face;
  face.loops = {{{1, false}, {0, false}, {2, true}, {0, true}}};
  panel.faces.push_back(face);
  const ChainSet set = chains_of(panel, radians(60));
  ASSERT_EQ(set.chains.size(), 3u);
  EXPECT_EQ(set.chains[0].faces, (std::array<Index, 2>{0, 0}));
  EXPECT_FALSE(set.chains[0].closed);
  EXPECT_TRUE(set.chains[1].closed);
  EXPECT_EQ(set.loops[0][0].size(), 4u);
}

TEST(ChainsOf, LoopsRunThroughTheSamePointsAsTheFacets) {
  for (const Panel& panel : {test::two_squares(), test::disc_in_ring(12)}) {
    const ChainSet set = chains_of(panel);
    for (std::size_t f = 0; f < panel.faces.size(); ++f)
      for (std::size_t l = 0; l < set.loops[f].size(); ++l) {
        const std::vector<Index> points = points_along(set, set.loops[f][l]);
        EXPECT_EQ(points.front(), points.back());
        std::set<Index> along(points.begin(), points.end()), facets;
        for (const Index v : panel.faces[f].facets.loops[l])
          facets.insert(panel.faces[f].facets.panel_points[v]);
        EXPECT_EQ(along, facets);
      }
  }
}

TEST(PositionAt, WrapsOnClosedChainsAndClampsOnOpenOnes) {
  const ChainSet ring = chains_of(test::disc_in_ring(24));
  const Chain& closed = ring.chains[0];
  const ChainPosition wrapped = position_at(closed, closed.length() * 1.25);
  EXPECT_EQ(wrapped.segment, position_at(closed, closed.length() * 0.25).segment);
  const ChainSet squares = chains_of(test::two_squares());
  EXPECT_EQ(position_at(squares.chains[0], 7).fraction, 1);
  EXPECT_EQ(position_at(squares.chains[0], -7).fraction, 0);
}

RC_GTEST_PROP(PositionAt, InvertsTheArcLength, ()) {
  static const Panel panel = test::disc_in_ring(24);
  static const ChainSet set = chains_of(panel);
  const Chain& chain = set.chains[1];
  const double s = *rc::gen::inRange(0, 1'000'000) * 1e-6 * chain.length();
  const ChainPosition at = position_at(chain, s);
  const double back = std::lerp(chain.arc_length[at.segment], chain.arc_length[at.segment + 1], at.fraction);
  RC_ASSERT(std::abs(back - s) < 1e-9);
}

class Circle : public CurveEvaluator {
 public:
  Vec3 point(double t) const override { return {std::cos(t), std::sin(t), 0}; }
  SpaceCurvePoint at(double t) const override {
    return {point(t), {-std::sin(t), std::cos(t), 0}, -point(t)};
  }
};

TEST(PointAt, IsOnTheCurveWhereThereIsOne) {
  Panel panel = test::disc_in_ring(24);
  for (int e = 0; e < 2; ++e) {
    panel.edges[e].curve = std::make_shared<Circle>();
    for (int i = 0; i <= 12; ++i) panel.edges[e].parameters.push_back(pi * e + pi * i / 12);
  }
  ASSERT_EQ(verify_panel(panel), std::vector<std::string>{});
  const ChainSet set = chains_of(panel);
  for (Index s = 0; s < 24; ++s) {
    EXPECT_NEAR(norm(point_at(panel, set.chains[0], {s, 0.5})), 1, 1e-12);
    EXPECT_NEAR(norm(point_at(panel, set.chains[1], {s, 0.5})), 2 * std::cos(pi / 24), 1e-12);
  }
}

}  // namespace
}  // namespace beadmesh
