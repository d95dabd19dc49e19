#include "beadmesh/mesh/ridge_insertion.h"

#include <gtest/gtest.h>

#include "bead/studied_bead.h"
#include "examples/skeletons.h"
#include "mesh/bead_checks.h"

namespace beadmesh {
namespace {

using namespace shapes;

Result<BeadMesh> inserted(const StudiedBead& bead) {
  return mesh_by_ridge_insertion(ridge_of(bead.skeleton(), bead.study->region, &bead.map()),
                                 bead.study->region, bead.map());
}

void expect_inserted(const Footprint& footprint, size_t curves) {
  const StudiedBead bead = studied_bead(footprint, 5);
  const auto mesh = inserted(bead);
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(mesh->method, "ridge");
  EXPECT_EQ(mesh->crest_lines.size(), curves);
  expect_sound(*mesh, *bead.study);
}

TEST(RidgeInsertion, IBead) {
  expect_inserted(examples::straight_bead(84, 16), 1);
}
TEST(RidgeInsertion, TBead) {
  expect_inserted(t_footprint(), 3);
}
TEST(RidgeInsertion, YBead) {
  expect_inserted(star_footprint({90, 210, 330}, 60, 16, 9), 3);
}
TEST(RidgeInsertion, XBead) {
  expect_inserted(star_footprint({0, 90, 180, 270}, 60, 16, 9), 4);
}
TEST(RidgeInsertion, CombBead) {
  expect_inserted(examples::comb_bead(3, 40, 50, 15, 8), 7);
}
TEST(RidgeInsertion, LadderBead) {
  expect_inserted(examples::ladder_bead(2, 46, 50, 14, 8), 8);
}
TEST(RidgeInsertion, RingBead) {
  expect_inserted(examples::circular_ring(44, 16), 1);
}

TEST(RidgeInsertion, CrestRunsFromTipToTip) {
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 16), 5);
  const auto mesh = inserted(bead);
  ASSERT_TRUE(mesh);
  const auto nodes = lifted_nodes(mesh->mesh, *bead.study);
  const auto& crest = mesh->crest_lines[0];
  EXPECT_NEAR(distance(nodes[crest.front()], nodes[crest.back()]), 100, 0.3);
  for (const Index n : crest) EXPECT_NEAR(nodes[n].y, 0, 0.1);
  for (size_t i = 1; i + 1 < crest.size(); ++i) EXPECT_EQ(mesh->mesh.freedom[crest[i]], NodeFreedom::sliding);
}

TEST(RidgeInsertion, SidesAreEvenForAnySize) {
  const StudiedBead bead = studied_bead(t_footprint(16, 90, 55), 4);
  const RidgeGraph ridge = ridge_of(bead.skeleton(), bead.study->region, &bead.map());
  for (double size = 3; size < 9; size += 0.37) {
    const auto mesh = mesh_by_ridge_insertion(ridge, bead.study->region, bead.map(), {size, size / 2});
    ASSERT_TRUE(mesh) << size << ": " << mesh.error().message;
    expect_sound(*mesh, *bead.study);
  }
}

TEST(RidgeInsertion, RidgeWithoutALengthIsRefused) {
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 16), 5);
  RidgeGraph ridge = ridge_of(bead.skeleton(), bead.study->region, &bead.map());
  ridge.arms[0].points.resize(1);
  const auto mesh = mesh_by_ridge_insertion(ridge, bead.study->region, bead.map());
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().code, "mesh.ridge.arm");
}

}  // namespace
}  // namespace beadmesh
