#include "beadmesh/mesh/shell_mesh.h"

#include <gtest/gtest.h>

#include "mesh/sample_quads.h"

namespace beadmesh {
namespace {

bool mentions(const std::vector<std::string>& violations, const std::string& word) {
  return std::any_of(violations.begin(), violations.end(),
                     [&](const std::string& line) { return line.find(word) != std::string::npos; });
}

ShellMesh shell_of(const PlanarMesh& plane) {
  ShellMesh mesh;
  mesh.nodes = sample::lifted(plane);
  for (const MeshElement& element : plane.elements) mesh.elements.push_back({element, 0, 1, 0});
  mesh.parts.push_back({1, "sheet", 1.0});
  return mesh;
}

class ShellMeshCheck : public testing::Test {
 protected:
  /// A third sheet stands on the edge 5-6.
  void add_fin() {
    const Index first = static_cast<Index>(mesh_.nodes.size());
    mesh_.nodes.push_back({5, 5, 5});
    mesh_.nodes.push_back({10, 5, 5});
    mesh_.elements.push_back({{5, 6, first + 1, first}, 0, 2, 0});
  }
  ShellMesh mesh_ = shell_of(sample::grid(3, 3, 5.0));
};

TEST_F(ShellMeshCheck, AcceptsGrid) {
  EXPECT_TRUE(verify_shell_mesh(mesh_).empty());
}

TEST_F(ShellMeshCheck, BoundaryOfSomeElementsIsWhereOnlyOneIs) {
  EXPECT_EQ(boundary_nodes(mesh_, {0, 1}), (std::vector<Index>{0, 1, 2, 4, 5, 6}));
  EXPECT_EQ(boundary_nodes(mesh_, {0, 1, 2, 3, 4, 5, 6, 7, 8}).size(), 12);
  EXPECT_TRUE(boundary_nodes(mesh_, {}).empty());
}

TEST_F(ShellMeshCheck, FindsThirdElementAtEdge) {
  add_fin();
  EXPECT_TRUE(mentions(verify_shell_mesh(mesh_), "edge 5-6 has 3 elements"));
}

TEST_F(ShellMeshCheck, AcceptsThirdElementWhereAllowed) {
  add_fin();
  EXPECT_TRUE(verify_shell_mesh(mesh_, {{6, 5}}).empty());
}

TEST_F(ShellMeshCheck, FindsTurnedElement) {
  std::reverse(mesh_.elements[4].nodes.begin(), mesh_.elements[4].nodes.end());
  EXPECT_TRUE(mentions(verify_shell_mesh(mesh_), "same direction"));
}

TEST_F(ShellMeshCheck, FindsUnusedNode) {
  mesh_.nodes.push_back({});
  EXPECT_TRUE(mentions(verify_shell_mesh(mesh_), "unused"));
}

TEST_F(ShellMeshCheck, FindsRepeatedElement) {
  mesh_.elements.push_back(mesh_.elements[0]);
  EXPECT_TRUE(mentions(verify_shell_mesh(mesh_), "repeats"));
}

TEST_F(ShellMeshCheck, FindsCollapsedElement) {
  mesh_.elements[0].nodes[1] = mesh_.elements[0].nodes[0];
  EXPECT_TRUE(mentions(verify_shell_mesh(mesh_), "collapsed"));
}

TEST_F(ShellMeshCheck, FindsCornerAndPartThatDoNotExist) {
  mesh_.elements[3].part = 1;
  EXPECT_TRUE(mentions(verify_shell_mesh(mesh_), "no part"));
  mesh_.elements[0].nodes[0] = -7;
  EXPECT_TRUE(mentions(verify_shell_mesh(mesh_), "no node"));
}

TEST_F(ShellMeshCheck, FindsEmptyMesh) {
  EXPECT_FALSE(verify_shell_mesh({}).empty());
}

}  // namespace
}  // namespace beadmesh
