#include "beadmesh/mesh/bead_mesher.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "bead/studied_bead.h"
#include "beadmesh/blocking/axis_station.h"
#include "beadmesh/mesh/quality_criteria.h"
#include "examples/skeletons.h"
#include "mesh/bead_checks.h"

namespace beadmesh {
namespace {

using namespace shapes;

/// Meshed by blocks, sound, no edge under the minimum, nothing inverted, at least `jacobian`, crest on top. A
/// junction is irregular where its arms meet in mitres.
void expect_good(const Footprint& footprint, BeadKind kind, double jacobian, int irregular,
                 const Base& base = flat_base, int junctions = 0) {
  const double height = 5;
  const StudiedBead bead = studied_bead(footprint, height, base);
  const auto mesh = mesh_bead(*bead.study, bead.medial, kind);
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->method, "blocks");
  expect_sound(*mesh, *bead.study);
  const QualitySummary quality = quality_of(*mesh, *bead.study);
  EXPECT_EQ(quality.inverted, 0);
  EXPECT_EQ(quality.edges_below_min, 0) << quality.edge_min;
  EXPECT_GE(quality.irregular, irregular);
  EXPECT_LE(quality.irregular, irregular + junctions);
  EXPECT_GE(quality.scaled_jacobian_min, jacobian);
  EXPECT_GE(quality.scaled_jacobian_mean, 0.93);
  const auto nodes = lifted_nodes(mesh->mesh, *bead.study);
  for (const auto& line : mesh->crest_lines)
    for (const Index n : line) {
      const double rise = nodes[n].z - base({nodes[n].x, nodes[n].y});
      // Between a cap's centre and its tip the crest comes down to the sheet.
      const bool in_cap =
          std::any_of(mesh->boundary.begin(), mesh->boundary.end(), [&](const BoundaryNode& b) {
            const bool tip = std::any_of(
                mesh->crest_lines.begin(), mesh->crest_lines.end(),
                [&](const auto& other) { return other.front() == b.node || other.back() == b.node; });
            return tip && distance(nodes[b.node], nodes[n]) < footprint.half_width + 1.5;
          });
      if (!in_cap) {
        EXPECT_NEAR(rise, height, 0.02);
      }
    }
}

TEST(BeadMesher, IBead) {
  expect_good(examples::straight_bead(84, 16), BeadKind::I, 0.8, 4);
}
TEST(BeadMesher, IBeadOnACurvedSheet) {
  expect_good(placed(examples::straight_bead(84, 16), {}, 0.5), BeadKind::I, 0.8, 4, cylinder_base(700));
}
TEST(BeadMesher, ArcBead) {
  expect_good(examples::arc_bead(60, 110, 16), BeadKind::I, 0.75, 4);
}
TEST(BeadMesher, Ring) {
  expect_good(examples::circular_ring(44, 14), BeadKind::annular, 0.93, 0);
}
TEST(BeadMesher, TightRingsKeepTheirShape) {
  expect_good(examples::circular_ring(24, 11), BeadKind::annular, 0.93, 0);
  expect_good(examples::rounded_ring(90, 60, 17, 11), BeadKind::annular, 0.93, 0);
}
TEST(BeadMesher, TBead) {
  expect_good(t_footprint(), BeadKind::generic, 0.65, 6, flat_base, 1);
}
TEST(BeadMesher, XBead) {
  expect_good(star_footprint({0, 90, 180, 270}, 60, 16, 9), BeadKind::generic, 0.65, 8, flat_base, 1);
}
TEST(BeadMesher, YBead) {
  expect_good(star_footprint({90, 210, 330}, 60, 16, 9), BeadKind::generic, 0.65, 7);
}
TEST(BeadMesher, CombBead) {
  expect_good(examples::comb_bead(3, 46, 50, 16, 9), BeadKind::generic, 0.65, 10, flat_base, 3);
}

/// Ends and junctions are where beads fail criteria: warpage, evenness, long sides.
TEST(BeadMesher, FewElementsFailWhereArmsMeet) {
  const QualityCriteria crash = criteria_of_sizes(5, 2.5);
  for (const Footprint& footprint : {t_footprint(), examples::comb_bead(3, 46, 50, 16, 9)}) {
    const StudiedBead bead = studied_bead(footprint, 5);
    const auto mesh = mesh_bead(*bead.study, bead.medial, BeadKind::generic);
    ASSERT_TRUE(mesh);
    const auto nodes = lifted_nodes(mesh->mesh, *bead.study);
    const auto failing = std::count_if(mesh->mesh.elements.begin(), mesh->mesh.elements.end(),
                                       [&](const MeshElement& e) { return fails_any(nodes, e, crash); });
    EXPECT_LE(failing, 3 * std::ssize(mesh->mesh.elements) / 200);
  }
}

TEST(BeadMesher, WindingBeadIsMeshedWithoutAnEdgeUnderTheMinimum) {
  const StudiedBead bead = studied_bead(examples::g_bead(30, 14, 12), 4.5);
  const auto mesh = mesh_bead(*bead.study, bead.medial, BeadKind::I);
  ASSERT_TRUE(mesh) << mesh.error().message;
  expect_sound(*mesh, *bead.study);
  EXPECT_EQ(quality_of(*mesh, *bead.study).edges_below_min, 0);
}

TEST(BeadMesher, RingTakesTheNodesOfItsNeighbour) {
  const StudiedBead bead = studied_bead(examples::circular_ring(44, 14), 5);
  const auto lengths = loop_lengths_of(bead.study->region);
  BeadMesherOptions options;
  options.prescribed.resize(2);
  for (int i = 0; i < 40; ++i) options.prescribed[0].push_back((i + 0.4) * lengths[0] / 40);
  const auto mesh = mesh_bead(*bead.study, bead.medial, BeadKind::annular, options);
  ASSERT_TRUE(mesh) << mesh.error().message;
  std::vector<double> at;
  for (const BoundaryNode& node : mesh->boundary)
    if (node.at.loop == 0) at.push_back(std::fmod(node.at.position + lengths[0], lengths[0]));
  std::sort(at.begin(), at.end());
  ASSERT_EQ(at.size(), 40);
  for (int i = 0; i < 40; ++i) EXPECT_NEAR(at[i], options.prescribed[0][i], 1e-9);
}

TEST(BeadMesher, RingTakesTheNumberAround) {
  const StudiedBead bead = studied_bead(examples::circular_ring(44, 14), 5);
  BeadMesherOptions options;
  options.elements_on_loop = {38, 38};
  const auto mesh = mesh_bead(*bead.study, bead.medial, BeadKind::annular, options);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->boundary.size(), 76);
}

TEST(BeadMesher, LadderOfTwoWindowsIsMeshedByBlocks) {
  const StudiedBead bead = studied_bead(examples::ladder_bead(3, 42, 46, 13, 8), 4.5);
  const auto mesh = mesh_bead(*bead.study, bead.medial, BeadKind::generic, {});
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->method, "blocks");
}

TEST(BeadMesher, BeadWithSetNodesIsRefusedUnlessARing) {
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 16), 5);
  BeadMesherOptions options;
  options.prescribed = {{0, 5, 10, 15}};
  const auto mesh = mesh_bead(*bead.study, bead.medial, BeadKind::I, options);
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().code, "mesh.bead.prescribed");
}

/// Boundary nodes slide: no edge between them may fall under the minimum either.
TEST(BeadMesher, TwoElementsAcrossKeepTheMinimumRoundTheirEnds) {
  const StudiedBead bead = studied_bead(examples::straight_bead(54, 9), 2.8, flat_base, {}, 1);
  BeadMesherOptions options;
  options.size = 8;
  options.min_edge = 4;
  const auto mesh = mesh_bead(*bead.study, bead.medial, BeadKind::I, options);
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->elements_across, 2);
  EXPECT_EQ(quality_of(*mesh, *bead.study).edges_below_min, 0);
}

TEST(BeadMesher, NarrowBeadIsOneElementWideAndSaysSo) {
  const StudiedBead bead = studied_bead(examples::straight_bead(60, 4.4), 0.8, flat_base, {}, 0.7);
  const auto mesh = mesh_bead(*bead.study, bead.medial, BeadKind::I);
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->method, "blocks");
  EXPECT_EQ(mesh->elements_across, 1);
  ASSERT_EQ(mesh->notes.size(), 1);
  EXPECT_NE(mesh->notes[0].find("one element across"), std::string::npos);
  EXPECT_TRUE(mesh->crest_lines.empty());
  expect_sound(*mesh, *bead.study);
  EXPECT_EQ(quality_of(*mesh, *bead.study).edges_below_min, 0);
}

TEST(BeadMesher, NarrowRingIsOneElementWide) {
  const StudiedBead bead = studied_bead(examples::circular_ring(44, 4.4), 0.6, flat_base, {}, 0.7);
  const auto mesh = mesh_bead(*bead.study, bead.medial, BeadKind::annular);
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->elements_across, 1);
  expect_sound(*mesh, *bead.study);
  EXPECT_EQ(quality_of(*mesh, *bead.study).edges_below_min, 0);
}

TEST(BeadMesher, ElementsLieNearTheSurface) {
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 16), 5);
  const auto mesh = mesh_bead(*bead.study, bead.medial, BeadKind::I);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(mesh->elements_across, 6) << "four follow the section no nearer than half a millimetre";
  const auto nodes = lifted_nodes(mesh->mesh, *bead.study);
  for (const auto& line : mesh->crest_lines)
    for (size_t i = 1; i < line.size(); ++i) {
      const Vec3 on_surface =
          bead.study->lift(lerp(mesh->mesh.nodes[line[i - 1]], mesh->mesh.nodes[line[i]], 0.5));
      EXPECT_LT(distance(on_surface, (nodes[line[i - 1]] + nodes[line[i]]) / 2), 0.5);
    }
}

TEST(BeadMesher, BeadTooNarrowForTheMinimumNamesEveryReason) {
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 2.2), 0.6, flat_base, {}, 0.7);
  const auto mesh = mesh_bead(*bead.study, bead.medial, BeadKind::I);
  ASSERT_FALSE(mesh) << "two elements of 2.5 mm do not fit 2.2 mm";
  EXPECT_EQ(mesh.error().code, "mesh.bead.failed");
  EXPECT_NE(mesh.error().message.find("blocks: "), std::string::npos) << mesh.error().message;
  EXPECT_NE(mesh.error().message.find("ridge: "), std::string::npos) << mesh.error().message;
}

TEST(BeadMesher, IsDeterministic) {
  const StudiedBead bead = studied_bead(t_footprint(), 5);
  const auto a = mesh_bead(*bead.study, bead.medial, BeadKind::generic);
  const auto b = mesh_bead(*bead.study, bead.medial, BeadKind::generic);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->mesh.nodes, b->mesh.nodes);
  EXPECT_EQ(a->mesh.elements, b->mesh.elements);
}

}  // namespace
}  // namespace beadmesh
