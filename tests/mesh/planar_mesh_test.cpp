#include "beadmesh/mesh/planar_mesh.h"

#include <gtest/gtest.h>

#include "mesh/sample_quads.h"

namespace beadmesh {
namespace {

bool mentions(const std::vector<std::string>& violations, const std::string& word) {
  return std::any_of(violations.begin(), violations.end(),
                     [&](const std::string& line) { return line.find(word) != std::string::npos; });
}

class PlanarMeshCheck : public testing::Test {
 protected:
  PlanarMesh mesh_ = sample::grid(3, 3, 5.0);
  NodeLoops loops_ = sample::loops_of(mesh_);
};

TEST_F(PlanarMeshCheck, AcceptsGrid) {
  EXPECT_TRUE(verify_planar_mesh(mesh_, loops_).empty());
}

TEST_F(PlanarMeshCheck, AcceptsHole) {
  mesh_.elements.erase(mesh_.elements.begin() + 4);
  EXPECT_TRUE(verify_planar_mesh(mesh_, sample::loops_of(mesh_)).empty());
}

TEST_F(PlanarMeshCheck, AcceptsTriangles) {
  const MeshElement quad = mesh_.elements[4];
  mesh_.elements[4] = {quad[0], quad[1], quad[2], no_index};
  mesh_.elements.push_back({quad[0], quad[2], quad[3], no_index});
  EXPECT_TRUE(verify_planar_mesh(mesh_, loops_).empty());
}

TEST_F(PlanarMeshCheck, AcceptsScarThatMeshHasAsEdges) {
  loops_.loops.push_back({5, 6});
  EXPECT_TRUE(verify_planar_mesh(mesh_, loops_).empty());
}

TEST_F(PlanarMeshCheck, FindsScarAcrossElement) {
  loops_.loops.push_back({5, 10});
  EXPECT_TRUE(mentions(verify_planar_mesh(mesh_, loops_), "does not have"));
}

TEST_F(PlanarMeshCheck, FindsMissingElement) {
  mesh_.elements.erase(mesh_.elements.begin() + 4);
  EXPECT_TRUE(mentions(verify_planar_mesh(mesh_, loops_), "boundary edge that is in no loop"));
  EXPECT_TRUE(mentions(verify_planar_mesh(mesh_, loops_), "Euler"));
}

TEST_F(PlanarMeshCheck, FindsTurnedElement) {
  std::reverse(mesh_.elements[0].begin(), mesh_.elements[0].end());
  EXPECT_TRUE(mentions(verify_planar_mesh(mesh_, loops_), "used twice in one direction"));
}

TEST_F(PlanarMeshCheck, FindsRepeatedElement) {
  mesh_.elements.push_back(mesh_.elements[2]);
  EXPECT_TRUE(mentions(verify_planar_mesh(mesh_, loops_), "repeated element"));
}

TEST_F(PlanarMeshCheck, FindsCollapsedElement) {
  mesh_.elements[4][1] = mesh_.elements[4][0];
  EXPECT_TRUE(mentions(verify_planar_mesh(mesh_, loops_), "collapsed element"));
}

TEST_F(PlanarMeshCheck, FindsUnusedNode) {
  mesh_.nodes.push_back({1, 1});
  mesh_.freedom.push_back(NodeFreedom::free);
  EXPECT_TRUE(mentions(verify_planar_mesh(mesh_, loops_), "unused node: node 16"));
}

TEST_F(PlanarMeshCheck, FindsCornerThatIsNoNode) {
  mesh_.elements[0][2] = 99;
  EXPECT_TRUE(mentions(verify_planar_mesh(mesh_, loops_), "no node"));
}

TEST_F(PlanarMeshCheck, FindsPieces) {
  PlanarMesh two = mesh_;
  for (const Vec2 p : mesh_.nodes) two.nodes.push_back(p + Vec2{100, 0});
  for (MeshElement element : mesh_.elements) {
    for (Index& corner : element) corner += static_cast<Index>(mesh_.nodes.size());
    two.elements.push_back(element);
  }
  sample::fix_boundary(two);
  EXPECT_TRUE(mentions(verify_planar_mesh(two, sample::loops_of(two)), "pieces"));
}

TEST_F(PlanarMeshCheck, FindsEmptyMesh) {
  EXPECT_FALSE(verify_planar_mesh({}, loops_).empty());
}

TEST_F(PlanarMeshCheck, FindsFreedomOfWrongLength) {
  mesh_.freedom.pop_back();
  EXPECT_TRUE(mentions(verify_planar_mesh(mesh_, loops_), "freedom"));
}

}  // namespace
}  // namespace beadmesh
