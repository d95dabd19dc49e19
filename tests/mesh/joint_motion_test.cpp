#include "beadmesh/mesh/joint_motion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "beadmesh/mesh/quality_criteria.h"
#include "mesh/sample_quads.h"

namespace beadmesh {
namespace {

const QualityCriteria crash = criteria_of_sizes(5, 2.5);

int failing(const std::vector<Vec3>& nodes, const PlanarMesh& mesh) {
  return int(std::count_if(mesh.elements.begin(), mesh.elements.end(),
                           [&](const MeshElement& e) { return fails_any(nodes, e, crash); }));
}

TEST(JointMotion, LeavesAGoodMeshAlone) {
  PlanarMesh mesh = sample::grid(6, 6, 5.0);
  const auto before = mesh.nodes;
  EXPECT_EQ(move_jointly(mesh, nullptr), 0);
  EXPECT_EQ(mesh.nodes, before);
}

TEST(JointMotion, MendsUnevenElements) {
  PlanarMesh mesh = sample::grid(6, 6, 5.0);
  mesh.nodes[24] += Vec2{1.9, 1.9};
  ASSERT_GT(failing(sample::lifted(mesh), mesh), 0);
  EXPECT_GT(move_jointly(mesh, nullptr), 0);
  EXPECT_EQ(failing(sample::lifted(mesh), mesh), 0);
  EXPECT_GE(sample::worst_jacobian(mesh), 0.7);
}

/// Guards: never more failing elements, no shorter edge, no worse shape than what may be given up.
TEST(JointMotion, GivesUpNoMoreThanItMay) {
  int before_all = 0, after_all = 0;
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    PlanarMesh mesh = sample::grid(8, 8, 5.0);
    sample::shake(mesh, 1.6, seed);
    const QualitySummary was = summarise(sample::lifted(mesh), mesh.elements, 2.5);
    const int before = failing(sample::lifted(mesh), mesh);
    move_jointly(mesh, nullptr);
    const QualitySummary is = summarise(sample::lifted(mesh), mesh.elements, 2.5);
    const int after = failing(sample::lifted(mesh), mesh);
    EXPECT_LE(after, before);
    EXPECT_GE(is.scaled_jacobian_min, std::min(was.scaled_jacobian_min, 0.7) - 1e-9);
    EXPECT_GE(is.edge_min, std::min(was.edge_min, 2.5) - 1e-9);
    before_all += before, after_all += after;
  }
  EXPECT_GT(before_all, 50);
  EXPECT_LE(after_all, before_all / 10);
}

TEST(JointMotion, FixedNodesStay) {
  PlanarMesh mesh = sample::grid(6, 6, 5.0);
  mesh.nodes[24] += Vec2{1.9, 1.9};
  std::fill(mesh.freedom.begin(), mesh.freedom.end(), NodeFreedom::fixed);
  const auto before = mesh.nodes;
  EXPECT_EQ(move_jointly(mesh, nullptr), 0);
  EXPECT_EQ(mesh.nodes, before);
}

/// A crest across a bent sheet: its nodes slide along it and do not leave it.
TEST(JointMotion, NodesOfLinesStayOnThem) {
  PlanarMesh mesh = sample::grid(6, 6, 5.0);
  std::vector<Index> line;
  for (Index j = 0; j <= 6; ++j) line.push_back(7 * j + 3);
  for (Index j = 1; j < 6; ++j) mesh.freedom[7 * j + 3] = NodeFreedom::sliding;
  mesh.nodes[24].y += 2.3;  // on the line
  mesh.nodes[25] += Vec2{-1.0, -1.5};
  ASSERT_GT(failing(sample::lifted(mesh), mesh), 0);
  SlidingLines lines({line_through(line, mesh.nodes)}, mesh.freedom);
  SurfaceNodes nodes(mesh.nodes, nullptr);
  EXPECT_GT(move_jointly(nodes, QuadConnectivity(mesh), mesh.freedom, lines), 0);
  for (const Index n : line) EXPECT_NEAR(nodes.flat(n).x, 15, 1e-9);
  for (size_t i = 1; i < line.size(); ++i) EXPECT_GT(nodes.flat(line[i]).y, nodes.flat(line[i - 1]).y);
}

}  // namespace
}  // namespace beadmesh
