#include "beadmesh/mesh/block_mesher.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "bead/studied_bead.h"
#include "beadmesh/blocking/annular_blocks.h"
#include "beadmesh/blocking/axis_station.h"
#include "beadmesh/blocking/bead_blocks.h"
#include "beadmesh/blocking/element_counts.h"
#include "examples/skeletons.h"
#include "mesh/bead_checks.h"

namespace beadmesh {
namespace {

using namespace shapes;

BlockLayout counted(Result<BlockLayout> layout, const SurfaceMap& map) {
  EXPECT_TRUE(layout) << layout.error().message;
  const auto done = assign_counts(*layout, edge_lengths(*layout, map), {5, 2.5});
  EXPECT_TRUE(done) << done.error().message;
  return std::move(*layout);
}

BeadMesh mapped(const StudiedBead& bead, int across) {
  const Skeleton skeleton = bead.skeleton();
  const RidgeGraph ridge = ridge_of(skeleton, bead.study->region, &bead.map());
  return map_blocks(
      counted(blocks_of_bead(skeleton, ridge, bead.study->region, {5, 2.5, across}), bead.map()), bead.map());
}

int irregular(const BeadMesh& bead, const FaceStudy& study) {
  return quality_of(bead, study).irregular;
}

TEST(BlockMesher, IBeadIsValidWithFourIrregularNodes) {
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 16), 5);
  for (const int m : {2, 4, 6}) {
    const BeadMesh mesh = mapped(bead, m);
    expect_sound(mesh, *bead.study);
    EXPECT_EQ(irregular(mesh, *bead.study), m == 2 ? 0 : 4);
    ASSERT_EQ(mesh.crest_lines.size(), 1);
    const auto& crest = mesh.crest_lines[0];
    EXPECT_EQ(mesh.mesh.freedom[crest.front()], NodeFreedom::fixed);
    EXPECT_EQ(mesh.mesh.freedom[crest.back()], NodeFreedom::fixed);
    for (size_t i = 1; i + 1 < crest.size(); ++i)
      EXPECT_EQ(mesh.mesh.freedom[crest[i]], NodeFreedom::sliding);
    EXPECT_NEAR(crest_length(mesh, lifted_nodes(mesh.mesh, *bead.study)), 100, 3);
  }
}

TEST(BlockMesher, TBeadHasThreeCrestLinesThatMeet) {
  const StudiedBead bead = studied_bead(t_footprint(), 5);
  const BeadMesh mesh = mapped(bead, 4);
  expect_sound(mesh, *bead.study);
  EXPECT_EQ(irregular(mesh, *bead.study), 6);
  ASSERT_EQ(mesh.crest_lines.size(), 3);
  std::map<Index, int> ends;
  for (const auto& line : mesh.crest_lines) ++ends[line.front()], ++ends[line.back()];
  EXPECT_EQ(std::count_if(ends.begin(), ends.end(), [](const auto& e) { return e.second == 3; }), 1);
  for (const auto& [node, lines] : ends) EXPECT_EQ(mesh.mesh.freedom[node], NodeFreedom::fixed);
}

TEST(BlockMesher, GradedRingChangesItsCountByTwoPerTemplate) {
  const StudiedBead bead = studied_bead(examples::circular_ring(44, 20), 5);
  for (const int across : {2, 4})
    for (const auto& [outer, inner] : {std::pair{64, 32}, {50, 46}, {34, 40}}) {
      AnnularBlockOptions options;
      options.elements_across = across;
      options.elements_on_loop = {outer, inner};
      const BlockLayout layout =
          counted(blocks_of_annular_bead(bead.skeleton(), bead.study->region, options), bead.map());
      const BeadMesh mesh = map_blocks(layout, bead.map());
      expect_sound(mesh, *bead.study);
      EXPECT_EQ(mesh.boundary.size(), outer + inner);
      // A template has a node with three elements at either end of its middle row, and one with five beside
      // it, or one with three on the boundary.
      EXPECT_GE(irregular(mesh, *bead.study), std::abs(outer - inner));
      EXPECT_LE(irregular(mesh, *bead.study), 2 * std::abs(outer - inner));
      ASSERT_EQ(mesh.crest_lines.size(), 1);
      EXPECT_EQ(mesh.crest_lines[0].front(), mesh.crest_lines[0].back());
    }
}

TEST(BlockMesher, RingIsRegularWithAClosedCrest) {
  const StudiedBead bead = studied_bead(examples::circular_ring(44, 14), 5);
  AnnularBlockOptions options;
  options.elements_on_loop = {46, 46};
  const BlockLayout layout =
      counted(blocks_of_annular_bead(bead.skeleton(), bead.study->region, options), bead.map());
  const BeadMesh mesh = map_blocks(layout, bead.map());
  expect_sound(mesh, *bead.study);
  EXPECT_EQ(mesh.mesh.elements.size(), 46 * 4);
  EXPECT_EQ(mesh.boundary.size(), 92);
  EXPECT_EQ(irregular(mesh, *bead.study), 0);
  ASSERT_EQ(mesh.crest_lines.size(), 1);
  EXPECT_EQ(mesh.crest_lines[0].front(), mesh.crest_lines[0].back());
  EXPECT_EQ(mesh.crest_lines[0].size(), 47);
}

TEST(BlockMesher, PrescribedNodesKeepTheirPlaces) {
  const StudiedBead bead = studied_bead(examples::circular_ring(44, 14), 5);
  const auto lengths = loop_lengths_of(bead.study->region);
  AnnularBlockOptions options;
  options.prescribed.resize(2);
  for (int i = 0; i < 44; ++i) options.prescribed[1].push_back((i + 0.3 + 0.2 * (i % 2)) * lengths[1] / 44);
  const BlockLayout layout =
      counted(blocks_of_annular_bead(bead.skeleton(), bead.study->region, options), bead.map());
  const BeadMesh mesh = map_blocks(layout, bead.map());
  expect_sound(mesh, *bead.study);
  std::vector<double> at;
  for (const BoundaryNode& node : mesh.boundary)
    if (node.at.loop == 1) at.push_back(std::fmod(node.at.position + lengths[1], lengths[1]));
  std::sort(at.begin(), at.end());
  ASSERT_EQ(at.size(), 44);
  for (int i = 0; i < 44; ++i) EXPECT_NEAR(at[i], options.prescribed[1][i], 1e-9);
}

TEST(BlockMesher, EdgesAreMeasuredAndDividedOnTheSurface) {
  // A cut across the bead is longer than its chord, and its elements are equal on the surface.
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 20), 8, flat_base, {}, 1.3);
  const Skeleton skeleton = bead.skeleton();
  const RidgeGraph ridge = ridge_of(skeleton, bead.study->region, &bead.map());
  const BlockLayout layout =
      counted(blocks_of_bead(skeleton, ridge, bead.study->region, {5, 2.5, 6}), bead.map());
  const auto lengths = edge_lengths(layout, bead.map());
  double arc = 0;
  const auto height = [](double y) { return 8 * std::pow(std::sin((10 - y) / 10 * pi / 2), 2); };
  for (int i = 0; i < 1000; ++i) arc += std::hypot(0.01, height((i + 1) * 0.01) - height(i * 0.01));
  bool found = false;
  for (size_t e = 0; e < layout.edges.size(); ++e) {
    if (layout.edges[e].kind != VirtualEdgeKind::split || layout.edges[e].count != 3) continue;
    found = true;
    EXPECT_NEAR(lengths[e], arc, 0.15);
  }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace beadmesh
