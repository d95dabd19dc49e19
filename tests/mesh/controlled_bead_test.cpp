#include "beadmesh/mesh/controlled_bead.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "bead/studied_bead.h"
#include "examples/skeletons.h"
#include "mesh/bead_checks.h"

namespace beadmesh {
namespace {

using namespace shapes;

BeadMesh meshed(const StudiedBead& bead, BeadKind kind, const BeadMeshControl& control,
                double min_edge = 2.5) {
  BeadMesherOptions options;
  options.min_edge = min_edge;
  options.control = control;
  const auto mesh = mesh_bead_as_asked(*bead.study, bead.medial, kind, options);
  EXPECT_TRUE(mesh) << mesh.error().message;
  if (!mesh) return {};
  expect_sound(*mesh, *bead.study);
  EXPECT_EQ(quality_of(*mesh, *bead.study, min_edge).edges_below_min, 0);
  return *mesh;
}

/// Elements on the line across a bead that runs along x.
int elements_at(const BeadMesh& bead, const FaceStudy& study, double x) {
  const auto nodes = lifted_nodes(bead.mesh, study);
  return int(std::count_if(bead.mesh.elements.begin(), bead.mesh.elements.end(), [&](const MeshElement& e) {
    const auto [low, high] = std::minmax({nodes[e[0]].x, nodes[e[1]].x, nodes[e[2]].x, nodes[e[3]].x});
    return low < x && x < high;
  }));
}

int crest_elements(const BeadMesh& mesh) {
  int count = 0;
  for (const auto& line : mesh.crest_lines) count += int(line.size()) - 1;
  return count;
}

int nodes_on_loop(const BeadMesh& mesh, Index loop) {
  return int(std::count_if(mesh.boundary.begin(), mesh.boundary.end(),
                           [&](const BoundaryNode& node) { return node.at.loop == loop; }));
}

BeadMeshControl counts(std::optional<int> across, std::optional<int> along, std::optional<int> rows) {
  BeadMeshControl control;
  control.elements_across = across;
  control.elements_along = along;
  control.clamp_rows = rows;
  return control;
}

TEST(ControlledBead, HasTheElementsAcrossThatAreAskedFor) {
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 20), 5);
  for (const int m : {2, 4, 6}) {
    const BeadMesh mesh = meshed(bead, BeadKind::I, counts(m, {}, {}), 2);
    EXPECT_EQ(mesh.refusals, std::vector<std::string>{});
    EXPECT_EQ(mesh.elements_across, m);
    for (const double x : {-11.3, 0.4, 12.1}) EXPECT_EQ(elements_at(mesh, *bead.study, x), m);
  }
}

TEST(ControlledBead, CountsAlongAndInTheClampsAddUpOnTheCrest) {
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 20), 5);
  for (const int along : {6, 9, 14})
    for (const int rows : {1, 2}) {
      const BeadMesh mesh = meshed(bead, BeadKind::I, counts(4, along, rows));
      EXPECT_EQ(mesh.refusals, std::vector<std::string>{});
      EXPECT_EQ(crest_elements(mesh), along + 2 * (rows + 1));
    }
}

TEST(ControlledBead, ArmsOfAGenericBeadHaveTheElementsAlong) {
  const StudiedBead bead = studied_bead(t_footprint(), 5);
  const BeadMesh few = meshed(bead, BeadKind::generic, counts(4, 4, 2));
  const BeadMesh more = meshed(bead, BeadKind::generic, counts(4, 5, 2));
  EXPECT_EQ(few.refusals, std::vector<std::string>{});
  EXPECT_EQ(more.refusals, std::vector<std::string>{});
  // Strip and clamp of three arms; a square hub has two more on each.
  const auto expect_along = [](const BeadMesh& mesh, int along) {
    const int square = 3 * (along + 3 + 2), mitred = 3 * (along + 3);
    EXPECT_EQ(crest_elements(mesh), crest_elements(mesh) == square ? square : mitred);
  };
  expect_along(few, 4);
  expect_along(more, 5);
}

TEST(ControlledBead, RingHasTheElementsAround) {
  const StudiedBead bead = studied_bead(examples::circular_ring(44, 14), 5);
  const BeadMesh mesh = meshed(bead, BeadKind::annular, counts({}, 40, 3));
  EXPECT_EQ(mesh.refusals, std::vector<std::string>{}) << "a ring has no clamps";
  EXPECT_EQ(nodes_on_loop(mesh, 0), 40);
  EXPECT_EQ(nodes_on_loop(mesh, 1), 40);
}

TEST(ControlledBead, WhatWouldBreakTheMinimumEdgeIsGivenUpAndNamed) {
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 16), 5);
  const BeadMesh mesh = meshed(bead, BeadKind::I, counts(12, 9, {}));
  EXPECT_EQ(mesh.method, "blocks");
  EXPECT_LT(mesh.elements_across, 12);
  ASSERT_EQ(mesh.refusals.size(), 1);
  EXPECT_EQ(mesh.refusals[0].find("elements across 12 not possible: blocks: "), 0) << mesh.refusals[0];
  EXPECT_NE(mesh.refusals[0].find("edges under the minimum"), std::string::npos) << mesh.refusals[0];
  EXPECT_EQ(mesh.refusals[0].find(';'), std::string::npos) << "one reason will do: " << mesh.refusals[0];
}

TEST(ControlledBead, RingTakesNoOddNumberAndKeepsThatOfItsNeighbour) {
  const StudiedBead bead = studied_bead(examples::circular_ring(44, 14), 5);
  const BeadMesh odd = meshed(bead, BeadKind::annular, counts({}, 41, {}));
  EXPECT_EQ(odd.refusals.size(), 1);
  EXPECT_EQ(nodes_on_loop(odd, 0) % 2, 0);

  BeadMesherOptions options;
  options.control = counts({}, 48, {});
  const BlockLayoutBuilder boundary(bead.study->region);
  options.prescribed.resize(2);
  for (int i = 0; i < 40; ++i) options.prescribed[0].push_back(boundary.loop_length(0) * i / 40);
  const auto mesh = mesh_bead_as_asked(*bead.study, bead.medial, BeadKind::annular, options);
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(nodes_on_loop(*mesh, 0), 40);
  ASSERT_EQ(mesh->refusals.size(), 1);
  EXPECT_NE(mesh->refusals[0].find("neighbour"), std::string::npos) << mesh->refusals[0];
}

TEST(ControlledBead, MethodIsTheOneAskedFor) {
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 16), 5);
  BeadMeshControl control;
  control.method = BeadMethod::ridge;
  const BeadMesh ridge = meshed(bead, BeadKind::I, control);
  EXPECT_EQ(ridge.method, "ridge");
  EXPECT_EQ(ridge.elements_across, 0);
  control.clamp_rows = 2;
  EXPECT_EQ(meshed(bead, BeadKind::I, control).refusals, std::vector<std::string>{})
      << "only blocks have counts";
  control.method = BeadMethod::blocks;
  EXPECT_EQ(meshed(bead, BeadKind::I, control).method, "blocks");
}

TEST(ControlledBead, BlocksAloneMayFail) {
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 16), 5);
  BeadMesherOptions options;
  options.min_edge = options.size = 25;  // not even one element fits across
  options.control.method = BeadMethod::blocks;
  const auto mesh = mesh_bead_as_asked(*bead.study, bead.medial, BeadKind::I, options);
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().message.find("ridge"), std::string::npos) << mesh.error().message;
}

}  // namespace
}  // namespace beadmesh
