#include "beadmesh/blocking/annular_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "bead/studied_bead.h"
#include "beadmesh/blocking/axis_station.h"
#include "blocking/layout_check.h"
#include "medial/shapes.h"

namespace beadmesh {
namespace {

using namespace shapes;

struct Ring {
  PlanarRegion region;
  Skeleton skeleton;
  std::vector<double> lengths;
};

Ring ring_of(const PlanarRegion& drawn) {
  PlanarRegion region = checked_region(drawn).value();
  Skeleton skeleton = skeleton_of(medial_of(region));
  auto lengths = loop_lengths_of(region);
  return {std::move(region), std::move(skeleton), std::move(lengths)};
}

AnnularBlockOptions around(int n, int across = 4) {
  AnnularBlockOptions options;
  options.elements_across = across;
  options.elements_on_loop = {n, n};
  return options;
}

std::vector<double> even_nodes(double length, int n, double shift = 0) {
  std::vector<double> nodes;
  for (int i = 0; i < n; ++i) nodes.push_back(std::fmod((i + shift) * length / n, length));
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

/// Arc lengths of all nodes that the layout puts on prescribed stretches of a loop, ascending.
std::vector<double> nodes_on(const BlockLayout& layout, Index loop, double length) {
  std::vector<double> nodes;
  const auto add = [&](double at) { nodes.push_back(std::fmod(std::fmod(at, length) + length, length)); };
  for (const VirtualEdge& edge : layout.edges) {
    if (edge.kind != VirtualEdgeKind::boundary || edge.loop != loop) continue;
    add(edge.from);
    for (double at : edge.prescribed) add(at);
  }
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

TEST(AnnularBlocks, FourToSixCutsByTheLength) {
  const Ring ring = ring_of(annulus(60, 44));
  for (const auto& [n, cuts] : {std::pair{8, 4}, {48, 4}, {50, 5}, {72, 5}, {74, 6}}) {
    const auto layout = blocks_of_annular_bead(ring.skeleton, ring.region, around(n));
    ASSERT_TRUE(layout) << layout.error().message;
    EXPECT_EQ(layout->blocks.size(), 2 * cuts) << n << " around, a block on either side of the crest";
    expect_sound(*layout, ring.region);
    EXPECT_EQ(irregular_vertices(*layout), 0);
  }
}

TEST(AnnularBlocks, SameEvenNumberOnBothLoopsAndTheCrest) {
  const Ring ring = ring_of(annulus(44, 30, {3, 1}));
  for (const int n : {8, 34, 52}) {
    auto layout = blocks_of_annular_bead(ring.skeleton, ring.region, around(n, 2));
    ASSERT_TRUE(layout);
    ASSERT_TRUE(assign_counts(*layout, flat_lengths(*layout), {5, 2.5}));
    expect_counted(*layout);
    EXPECT_EQ(boundary_count(*layout), 2 * n);
    int crest = 0;
    for (const VirtualEdge& edge : layout->edges)
      if (edge.kind == VirtualEdgeKind::ridge) crest += edge.count;
    EXPECT_EQ(crest, n);
  }
}

TEST(AnnularBlocks, PrescribedNodesOfOneLoopAreKept) {
  const Ring ring = ring_of(annulus(44, 30));
  for (const int loop : {0, 1}) {
    AnnularBlockOptions options = around(0);
    options.prescribed.resize(2);
    options.prescribed[loop] = even_nodes(ring.lengths[loop], 26, 0.37);
    auto layout = blocks_of_annular_bead(ring.skeleton, ring.region, options);
    ASSERT_TRUE(layout) << layout.error().message;
    expect_sound(*layout, ring.region);
    const auto nodes = nodes_on(*layout, loop, ring.lengths[loop]);
    ASSERT_EQ(nodes.size(), 26);
    for (size_t i = 0; i < nodes.size(); ++i) EXPECT_NEAR(nodes[i], options.prescribed[loop][i], 1e-9);
    ASSERT_TRUE(assign_counts(*layout, flat_lengths(*layout), {5, 2.5}));
    EXPECT_EQ(boundary_count(*layout), 52) << "the other loop follows";
  }
}

TEST(AnnularBlocks, PrescribedNodesOfBothLoopsAreKept) {
  const Ring ring = ring_of(annulus(44, 30));
  AnnularBlockOptions options = around(0);
  options.prescribed = {even_nodes(ring.lengths[0], 32, 0.2), even_nodes(ring.lengths[1], 32, 0.7)};
  const auto layout = blocks_of_annular_bead(ring.skeleton, ring.region, options);
  ASSERT_TRUE(layout) << layout.error().message;
  expect_sound(*layout, ring.region);
  for (const int loop : {0, 1}) {
    const auto nodes = nodes_on(*layout, loop, ring.lengths[loop]);
    ASSERT_EQ(nodes.size(), 32);
    for (size_t i = 0; i < nodes.size(); ++i) EXPECT_NEAR(nodes[i], options.prescribed[loop][i], 1e-9);
  }
}

TEST(AnnularBlocks, DifferentCountsGiveGradedBlocksWithTheMeanOnTheCrest) {
  const Ring ring = ring_of(annulus(60, 30));
  for (const bool prescribed : {false, true})
    for (const auto& [outer, inner] : {std::pair{64, 32}, {40, 38}, {30, 32}, {90, 20}}) {
      AnnularBlockOptions options = around(0);
      options.elements_on_loop = {outer, inner};
      if (prescribed)
        options.prescribed = {even_nodes(ring.lengths[0], outer, 0.3),
                              even_nodes(ring.lengths[1], inner, 0.8)};
      auto layout = blocks_of_annular_bead(ring.skeleton, ring.region, options);
      ASSERT_TRUE(layout) << layout.error().message;
      expect_sound(*layout, ring.region);
      ASSERT_TRUE(assign_counts(*layout, flat_lengths(*layout), {5, 2.5}));
      EXPECT_EQ(boundary_count(*layout), outer + inner);
      int crest = 0;
      for (const VirtualEdge& edge : layout->edges)
        if (edge.kind == VirtualEdgeKind::ridge) crest += edge.count;
      EXPECT_LE(std::abs(crest - (outer + inner) / 2), 1);
      EXPECT_EQ(crest % 2, 0);
    }
}

TEST(AnnularBlocks, CountsThatGradedRowsCannotMakeUpForAreRefused) {
  const Ring ring = ring_of(annulus(44, 30));
  for (const auto& [outer, inner, across] : {std::array{80, 12, 4}, {32, 30, 1}}) {
    AnnularBlockOptions options = around(0, across);
    options.elements_on_loop = {outer, inner};
    const auto layout = blocks_of_annular_bead(ring.skeleton, ring.region, options);
    ASSERT_FALSE(layout);
    EXPECT_EQ(layout.error().code, "blocking.annular.prescribed");
  }
  EXPECT_FALSE(blocks_of_annular_bead(ring.skeleton, ring.region, around(31))) << "odd";
}

TEST(AnnularBlocks, TooFewElementsAreRefused) {
  const Ring ring = ring_of(annulus(44, 30));
  EXPECT_FALSE(blocks_of_annular_bead(ring.skeleton, ring.region, around(6)));
}

TEST(AnnularBlocks, OtherBeadsAreRefused) {
  const PlanarRegion region = stadium(80, 8);
  const auto layout = blocks_of_annular_bead(skeleton_of(medial_of(region)), region, around(20));
  ASSERT_FALSE(layout);
  EXPECT_EQ(layout.error().code, "blocking.annular.axis");
}

}  // namespace
}  // namespace beadmesh
