#include "beadmesh/blocking/bead_blocks.h"

#include <gtest/gtest.h>

#include "bead/studied_bead.h"
#include "blocking/layout_check.h"
#include "examples/skeletons.h"
#include "medial/shapes.h"

namespace beadmesh {
namespace {

using namespace shapes;

struct Blocked {
  PlanarRegion region;
  Result<BlockLayout> layout;
};

Blocked blocked(const PlanarRegion& drawn, int across, int bands = 1, HubForm hub = HubForm::square) {
  PlanarRegion region = checked_region(drawn).value();
  const Skeleton skeleton = skeleton_of(medial_of(region));
  auto layout =
      blocks_of_bead(skeleton, ridge_of(skeleton, region), region, {5, 2.5, across, 0, 0, 0, bands, hub});
  return {std::move(region), std::move(layout)};
}

/// Sound, with counts, an even boundary, and no irregular node but `irregular` (m >= 4) or `hub` (m = 2).
void expect_blocks(const std::string& what, const PlanarRegion& region, int irregular, int hub = 0,
                   HubForm form = HubForm::square) {
  struct Variant {
    int across, bands;
  };
  for (const auto& [m, bands] : {Variant{2, 1}, {4, 1}, {4, 2}, {6, 1}, {6, 2}, {8, 3}}) {
    Blocked bead = blocked(region, m, bands, form);
    ASSERT_TRUE(bead.layout) << what << ": " << bead.layout.error().message;
    SCOPED_TRACE(what + ", " + std::to_string(m) + " across, " + std::to_string(bands) + " bands");
    expect_sound(*bead.layout, bead.region);
    EXPECT_EQ(irregular_vertices(*bead.layout), m == 2 ? hub : irregular);
    const auto counted = assign_counts(*bead.layout, flat_lengths(*bead.layout), {5, 2.5});
    ASSERT_TRUE(counted) << counted.error().message;
    expect_counted(*bead.layout);
    EXPECT_EQ(boundary_count(*bead.layout) % 2, 0);
  }
}

TEST(BeadBlocks, IBeadHasFourIrregularNodes) {
  expect_blocks("stadium", stadium(80, 8), 4);
  expect_blocks("taper", tapered_stadium(80, 11, 6), 4);
  expect_blocks("arc", region_of(examples::arc_bead(60, 120, 16)), 4);
  expect_blocks("S", region_of(examples::s_bead(50, 70, 16)), 4);
}

TEST(BeadBlocks, BandsRunAroundTheCores) {
  for (const int bands : {1, 2}) {
    Blocked bead = blocked(stadium(80, 8), 6, bands);
    ASSERT_TRUE(bead.layout);
    ASSERT_TRUE(assign_counts(*bead.layout, flat_lengths(*bead.layout), {5, 2.5}));
    // At the corners of a core one edge leads to the foot, as many elements long as there are bands.
    int corners = 0;
    const auto& vertices = bead.layout->vertices;
    for (Index v = 0; v < Index(vertices.size()); ++v) {
      if (vertices[v].on_boundary) continue;
      int edges = 0, shortest_to_foot = 100;
      for (const VirtualEdge& edge : bead.layout->edges) {
        if (edge.start != v && edge.end != v) continue;
        ++edges;
        const Index other = edge.start == v ? edge.end : edge.start;
        if (vertices[other].on_boundary) shortest_to_foot = std::min(shortest_to_foot, edge.count);
      }
      if (edges != 3) continue;
      ++corners;
      EXPECT_EQ(shortest_to_foot, bands);
    }
    EXPECT_EQ(corners, 8) << "two of a core and two where its sides begin, at each end";
  }
}

TEST(BeadBlocks, ShortIBeadIsTwoCapsOnOneCut) {
  expect_blocks("short", stadium(12, 8), 4);
}

TEST(BeadBlocks, TBarRunsThrough) {
  expect_blocks("T", letter_t(16, 9), 6);
}

TEST(BeadBlocks, YHubIsTheOnlyIrregularNodeBesidesTheCaps) {
  expect_blocks("Y", region_of(star_footprint({90, 210, 330}, 60, 16, 8)), 7, 1);
}

TEST(BeadBlocks, XHubIsRegular) {
  expect_blocks("X", letter_x(16, pi / 2, 8), 8);
  expect_blocks("oblique X", letter_x(16, radians(70), 8), 8);
}

TEST(BeadBlocks, HCombAndLadder) {
  expect_blocks("H", letter_h(16, 8), 8);
  expect_blocks("comb", region_of(examples::comb_bead(3, 46, 50, 16, 8)), 10);
  expect_blocks("ladder", region_of(examples::ladder_bead(2, 52, 56, 16, 8)), 8);
}

TEST(BeadBlocks, ArmsMeetInMitresAtOneIrregularNode) {
  const auto expect_mitres = [](const std::string& what, const PlanarRegion& region, int ends,
                                int junctions) {
    for (const HubForm form : {HubForm::mitre, HubForm::fan})
      expect_blocks(what, region, 2 * ends + junctions, junctions, form);
  };
  expect_mitres("T", letter_t(16, 9), 3, 1);
  expect_mitres("Y", region_of(star_footprint({90, 210, 330}, 60, 16, 8)), 3, 1);
  expect_mitres("X", letter_x(16, pi / 2, 8), 4, 1);
  expect_mitres("H", letter_h(16, 8), 4, 2);
  expect_mitres("comb", region_of(examples::comb_bead(3, 46, 50, 16, 8)), 5, 3);
}

TEST(BeadBlocks, MitresLeadFromTheJunctionToEveryFoot) {
  const Blocked bead = blocked(letter_t(16, 9), 6, 1, HubForm::mitre);
  ASSERT_TRUE(bead.layout) << bead.layout.error().message;
  const auto& layout = *bead.layout;
  Index junction = no_index;
  for (Index v = 0; v < Index(layout.vertices.size()); ++v) {
    int crests = 0;
    for (const VirtualEdge& edge : layout.edges)
      if (edge.kind == VirtualEdgeKind::ridge) crests += (edge.start == v) + (edge.end == v);
    if (crests == 3) junction = v;
  }
  ASSERT_NE(junction, no_index);
  int mitres = 0;
  for (const VirtualEdge& edge : layout.edges) {
    if (edge.kind == VirtualEdgeKind::ridge || (edge.start != junction && edge.end != junction)) continue;
    ++mitres;
    EXPECT_EQ(edge.count, 3) << "half of the elements across";
    EXPECT_TRUE(layout.vertices[edge.start == junction ? edge.end : edge.start].on_boundary);
  }
  EXPECT_EQ(mitres, 3) << "two concave feet and the far side of the bar";
}

/// The longest stretch of crest between a junction and the node next to it.
double longest_beside_junction(const BlockLayout& layout) {
  double longest = 0;
  for (const VirtualEdge& edge : layout.edges) {
    if (edge.kind != VirtualEdgeKind::ridge) continue;
    double length = 0;
    for (size_t i = 1; i < edge.points.size(); ++i) length += distance(edge.points[i - 1], edge.points[i]);
    for (const Index v : {edge.start, edge.end}) {
      int crests = 0;
      for (const VirtualEdge& other : layout.edges)
        if (other.kind == VirtualEdgeKind::ridge) crests += (other.start == v) + (other.end == v);
      if (crests == 3) longest = std::max(longest, length / edge.count);
    }
  }
  return longest;
}

TEST(BeadBlocks, FansGiveLongCrestsBesideWideFilletsMoreRows) {
  const PlanarRegion region = letter_t(16, 16);
  const Blocked mitre = blocked(region, 6, 1, HubForm::mitre), fan = blocked(region, 6, 1, HubForm::fan);
  ASSERT_TRUE(mitre.layout && fan.layout);
  EXPECT_GT(longest_beside_junction(*mitre.layout), 7.5);
  EXPECT_LT(longest_beside_junction(*fan.layout), 6.5);
}

TEST(BeadBlocks, ArmTooShortForAStripBehindItsMitreIsRefused) {
  const PlanarRegion region = region_of(star_footprint({0, 120, 240}, 22, 16, 8));
  const Skeleton skeleton = skeleton_of(medial_of(region));
  const RidgeGraph ridge = ridge_of(skeleton, region);
  BeadBlockOptions options{12, 6, 4};
  options.hub = HubForm::mitre;
  const auto mitre = blocks_of_bead(skeleton, ridge, region, options);
  ASSERT_FALSE(mitre);
  EXPECT_EQ(mitre.error().code, "blocking.short_arm");
}

TEST(BeadBlocks, TurnedAndMirroredShapesAreTheSame) {
  for (const double angle : {0.3, 1.9, 4.0})
    for (const bool mirrored : {false, true})
      expect_blocks("T", region_of(placed(t_footprint(), {5, 7}, angle, mirrored)), 6);
}

TEST(BeadBlocks, CrestRunsFromTipToTip) {
  const Blocked bead = blocked(stadium(80, 8), 4);
  ASSERT_TRUE(bead.layout);
  double length = 0;
  for (const VirtualEdge& edge : bead.layout->edges) {
    if (edge.kind != VirtualEdgeKind::ridge) continue;
    for (const Vec2 p : edge.points) EXPECT_NEAR(p.y, 0, 1e-2);
    for (size_t i = 1; i < edge.points.size(); ++i) length += distance(edge.points[i - 1], edge.points[i]);
  }
  EXPECT_NEAR(length, 96, 0.1);
}

TEST(BeadBlocks, ClosedAxisIsRefused) {
  const Blocked ring = blocked(annulus(40, 26), 4);
  ASSERT_FALSE(ring.layout);
  EXPECT_EQ(ring.layout.error().code, "blocking.arm");
}

TEST(BeadBlocks, ArmWithoutATipIsRefused) {
  const PlanarRegion region = stadium(80, 8);
  const Skeleton skeleton = skeleton_of(medial_of(region));
  RidgeGraph ridge = ridge_of(skeleton, region);
  for (RidgeNode& node : ridge.nodes) node.tip = false;
  const auto layout = blocks_of_bead(skeleton, ridge, region, {});
  ASSERT_FALSE(layout);
  EXPECT_EQ(layout.error().code, "blocking.tip");
}

TEST(BeadBlocks, JunctionsTooNearForABlockAreRefused) {
  // Between teeth 16 mm apart and 12 mm wide less than 4 mm of the spine are left.
  const PlanarRegion region = region_of(examples::comb_bead(3, 16, 46, 12, 1.8));
  const Blocked fine = blocked(region, 4);
  ASSERT_TRUE(fine.layout) << fine.layout.error().message;
  expect_sound(*fine.layout, fine.region);
  const Skeleton skeleton = skeleton_of(medial_of(region));
  const auto coarse = blocks_of_bead(skeleton, ridge_of(skeleton, region), region, {12, 6, 4});
  ASSERT_FALSE(coarse);
  EXPECT_EQ(coarse.error().code, "blocking.short_arm");
}

}  // namespace
}  // namespace beadmesh
