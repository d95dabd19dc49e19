#include "beadmesh/mesh/quad_connectivity.h"

#include <gtest/gtest.h>

#include "mesh/sample_quads.h"

namespace beadmesh {
namespace {

class Connectivity : public testing::Test {
 protected:
  PlanarMesh plane_ = sample::grid(3, 3, 1.0);
  QuadConnectivity mesh_{plane_};
};

TEST_F(Connectivity, KnowsElementsAroundNodes) {
  EXPECT_EQ(mesh_.valence(0), 1);
  EXPECT_EQ(mesh_.valence(1), 2);
  EXPECT_EQ(mesh_.valence(5), 4);
  EXPECT_TRUE(mesh_.has_boundary_edge(1));
  EXPECT_FALSE(mesh_.has_boundary_edge(5));
  EXPECT_EQ(mesh_.neighbours(5), (std::vector<Index>{1, 4, 6, 9}));
}

TEST_F(Connectivity, FindsElementOfDirectedEdge) {
  EXPECT_EQ(mesh_.element_with_edge(5, 6), 4);
  EXPECT_EQ(mesh_.element_with_edge(6, 5), 1);
  EXPECT_EQ(mesh_.element_with_edge(1, 0), no_index);
  EXPECT_EQ(mesh_.element_with_edge(5, 10), no_index);
}

TEST_F(Connectivity, UndoesAnEdit) {
  const MeshElement removed = mesh_.element(4);
  mesh_.remove_element(4);
  EXPECT_FALSE(mesh_.is_alive(4));
  EXPECT_TRUE(mesh_.has_boundary_edge(5));
  const Index node = mesh_.add_node();
  mesh_.add_element({5, 6, node, no_index});
  EXPECT_EQ(mesh_.valence(node), 1);
  mesh_.remove_last_elements(9);
  mesh_.remove_last_nodes(16);
  mesh_.restore_element(4, removed);
  EXPECT_EQ(mesh_.element_count(), 9);
  EXPECT_EQ(mesh_.valence(5), 4);
  EXPECT_EQ(mesh_.element_with_edge(5, 6), 4);
}

TEST(Corners, NeighboursOfTriangleCorner) {
  const MeshElement tria = {7, 8, 9, no_index};
  EXPECT_EQ(corner_of(tria, 9), 2);
  EXPECT_EQ(corner_neighbours(tria, 9), (std::pair<Index, Index>{7, 8}));
  EXPECT_EQ(corner_neighbours(tria, 7), (std::pair<Index, Index>{8, 9}));
}

}  // namespace
}  // namespace beadmesh
