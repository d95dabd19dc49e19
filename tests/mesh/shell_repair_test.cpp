#include "beadmesh/mesh/shell_repair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/sample_quads.h"

namespace beadmesh {
namespace {

/// A grid of 5 mm on a cylinder of this radius about y.
std::vector<Vec3> bent(const PlanarMesh& mesh, double radius) {
  std::vector<Vec3> nodes;
  for (const Vec2 p : mesh.nodes)
    nodes.push_back({radius * std::sin(p.x / radius), p.y, radius * std::cos(p.x / radius)});
  return nodes;
}

int failing(const std::vector<Vec3>& nodes, const std::vector<MeshElement>& elements) {
  return judge(nodes, elements, *criteria_of_preset("crash")).parts[0].findings.failing;
}

TEST(ShellRepair, ShiftedNodesComeBackOntoTheSurface) {
  PlanarMesh mesh = sample::grid(12, 10, 5);
  const PlanarMesh perfect = mesh;
  mesh.nodes[5 * 13 + 4] += Vec2{3.4, 1.5};
  mesh.nodes[3 * 13 + 9] += Vec2{-3, -3};
  auto nodes = bent(mesh, 80);
  ASSERT_GT(failing(nodes, mesh.elements), 3);
  const auto before = nodes;
  const auto report = repair_by_moving(nodes, mesh.elements, *criteria_of_preset("crash"));
  EXPECT_EQ(failing(nodes, mesh.elements), 0);
  EXPECT_GE(report.zones, 2);
  for (size_t n = 0; n < nodes.size(); ++n) {
    EXPECT_NEAR(std::hypot(nodes[n].x, nodes[n].z), 80, 0.2);
    const bool moved = std::binary_search(report.moved.begin(), report.moved.end(), Index(n));
    EXPECT_EQ(moved, nodes[n] != before[n]);
    if (mesh.freedom[n] == NodeFreedom::fixed) {
      EXPECT_EQ(nodes[n], before[n]) << "free edge";
    }
  }
  EXPECT_LT(report.moved.size(), 60u) << "only what is near";
}

TEST(ShellRepair, AGoodMeshStays) {
  const PlanarMesh mesh = sample::grid(6, 6, 5);
  auto nodes = bent(mesh, 100);
  const auto before = nodes;
  const auto report = repair_by_moving(nodes, mesh.elements, *criteria_of_preset("crash"));
  EXPECT_EQ(report.zones, 0);
  EXPECT_EQ(nodes, before);
}

/// The same grid with a right-angled bend along x = 30, and its middle node of the bend pushed along it.
TEST(ShellRepair, SharpEdgesBordersAndKeptNodesStay) {
  const PlanarMesh mesh = sample::grid(12, 10, 5);
  const auto shape = [&](bool sharp) {
    std::vector<Vec3> nodes;
    for (const Vec2 p : mesh.nodes)
      nodes.push_back(sharp && p.x > 30 ? Vec3{30, p.y, 30 - p.x} : Vec3{p.x, p.y, 0});
    return nodes;
  };
  const Index pushed = 5 * 13 + 6;
  const auto stays = [&](bool sharp, const ShellRepairOptions& options) {
    auto nodes = shape(sharp);
    nodes[pushed].y += 3;
    EXPECT_GT(failing(nodes, mesh.elements), 0);
    const Vec3 place = nodes[pushed];
    repair_by_moving(nodes, mesh.elements, *criteria_of_preset("crash"), options);
    return nodes[pushed] == place;
  };
  EXPECT_FALSE(stays(false, {}));
  EXPECT_TRUE(stays(true, {}));
  ShellRepairOptions kept;
  kept.kept = {pushed};
  EXPECT_TRUE(stays(false, kept));
  ShellRepairOptions groups;
  for (const MeshElement& e : mesh.elements) groups.groups.push_back(mesh.nodes[e[0]].x < 30);
  EXPECT_TRUE(stays(false, groups));
}

TEST(ShellRepair, NonManifoldAndCollapsedElementsDoNoHarm) {
  PlanarMesh mesh = sample::grid(6, 6, 5);
  auto nodes = bent(mesh, 100);
  nodes[24] += Vec3{3, 3, 0};
  auto elements = mesh.elements;
  elements.push_back(elements[10]);                                                     // twice
  elements[20] = {elements[20][0], elements[20][1], elements[20][2], elements[20][2]};  // collapsed
  const auto before = failing(nodes, elements);
  repair_by_moving(nodes, elements, *criteria_of_preset("crash"));
  EXPECT_LE(failing(nodes, elements), before);
}

}  // namespace
}  // namespace beadmesh
