#include "beadmesh/mesh/mapped_area.h"

#include <gtest/gtest.h>

#include "mesh/sample_loops.h"

namespace beadmesh {
namespace {

bool map_loop(const std::vector<Vec2>& points, PlanarMesh& mesh, NodeLoops& loops) {
  const NodeLoop loop = test::add_loop(loops, points);
  MeshDraft draft(loops, nullptr, 1);
  const bool done = fill_by_mapping(draft, loop, interior_angles(draft.nodes(), loop));
  mesh = std::move(draft).take();
  return done;
}

TEST(MappedArea, RectangleBecomesARegularGrid) {
  PlanarMesh mesh;
  NodeLoops loops;
  ASSERT_TRUE(map_loop(test::rectangle(5, 3, 5, 3), mesh, loops));
  EXPECT_EQ(mesh.elements.size(), 15u);
  EXPECT_TRUE(verify_planar_mesh(mesh, loops).empty());
  for (const MeshElement& element : mesh.elements) EXPECT_NEAR(test::signed_area(mesh, element), 1, 1e-12);
}

TEST(MappedArea, StartsAtAnyNode) {
  auto points = test::polygon({{0, 0}, {6, 0}, {5, 3}, {1, 4}}, {5, 3, 5, 3});
  std::rotate(points.begin(), points.begin() + 7, points.end());
  PlanarMesh mesh;
  NodeLoops loops;
  ASSERT_TRUE(map_loop(points, mesh, loops));
  EXPECT_TRUE(verify_planar_mesh(mesh, loops).empty());
}

TEST(MappedArea, RefusesUnequalCountsAndOtherCorners) {
  PlanarMesh mesh;
  for (const auto& points :
       {test::polygon({{0, 0}, {5, 0}, {5, 3}, {0, 3}}, {5, 3, 7, 3}), test::circle({0, 0}, 5, 24),
        test::polygon({{0, 0}, {4, 0}, {2, 3}}, {4, 4, 4})}) {
    NodeLoops loops;
    EXPECT_FALSE(map_loop(points, mesh, loops));
    EXPECT_TRUE(mesh.elements.empty());
  }
}

}  // namespace
}  // namespace beadmesh
