#include "beadmesh/mesh/loop_splitting.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mesh/sample_loops.h"

namespace beadmesh {
namespace {

PlanarMesh split(const NodeLoops& loops, double size) {
  MeshDraft draft(loops, nullptr, size);
  fill_by_splitting(draft, loops.loops[0]);
  return std::move(draft).take();
}

TEST(LoopSplitting, AngleCost) {
  EXPECT_NEAR(split_angle_cost(pi, pi / 2), 0, 1e-12);
  EXPECT_NEAR(split_angle_cost(2 * pi, pi / 2), 0, 1e-12);
  EXPECT_NEAR(split_angle_cost(pi, pi / 4), 2, 1e-12);
  EXPECT_LT(split_angle_cost(pi / 2, pi / 2), 0);  // along the edge
  EXPECT_LT(split_angle_cost(pi / 2, pi), 0);      // outside
  EXPECT_EQ(misfit_cost(3, 3), 0);
  EXPECT_DOUBLE_EQ(misfit_cost(2, 4), misfit_cost(4, 2));
}

TEST(LoopSplitting, LShapeIsRegular) {
  NodeLoops loops;
  test::add_loop(loops, test::polygon({{0, 0}, {9, 0}, {9, 4}, {4, 4}, {4, 8}, {0, 8}}, {9, 4, 5, 4, 4, 8}));
  const PlanarMesh mesh = split(loops, 1);
  EXPECT_TRUE(verify_planar_mesh(mesh, loops).empty());
  EXPECT_EQ(mesh.elements.size(), 9u * 4 + 4 * 4);
  EXPECT_EQ(test::irregular_nodes(mesh), 0);
}

TEST(LoopSplitting, OddLoopHasOneTriangle) {
  for (const int count : {5, 7, 9, 15, 31}) {
    NodeLoops loops;
    test::add_loop(loops, test::circle({0, 0}, count / 6.0, count));
    const PlanarMesh mesh = split(loops, 1);
    EXPECT_TRUE(verify_planar_mesh(mesh, loops).empty()) << count;
    EXPECT_EQ(test::triangles(mesh), 1) << count;
  }
}

TEST(LoopSplitting, FoldedLoopsStillGiveAValidMesh) {
  NodeLoops loops;
  loops.nodes = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 2}, {1, 2}, {2, 2}, {3, 2}};
  loops.loops = {{0, 1, 2, 3, 4, 5, 6, 7, 6, 5, 4}};  // a scar that nearly cuts the square; odd
  EXPECT_EQ(test::triangles(split(loops, 1)), 1);
  // All nodes on one line: no line is visible, the topology has to hold all the same.
  NodeLoops flat;
  test::add_loop(flat,
                 {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {3.5, 0}, {2.5, 0}, {1.5, 0}, {0.7, 0}, {0.2, 0}});
  EXPECT_TRUE(verify_planar_mesh(split(flat, 1), flat).empty());
}

RC_GTEST_PROP(LoopSplitting, AnyStarIsAllQuads, ()) {
  const int half = *rc::gen::inRange(2, 40);
  const auto radii = *rc::gen::container<std::vector<int>>(2 * half, rc::gen::inRange(10, 40));
  std::vector<Vec2> points = test::circle({0, 0}, 1, 2 * half);
  for (int i = 0; i < 2 * half; ++i) points[i] = points[i] * (0.1 * radii[i]);
  NodeLoops loops;
  test::add_loop(loops, points);
  const PlanarMesh mesh = split(loops, *rc::gen::element(0.3, 1.0, 3.0));
  RC_ASSERT(verify_planar_mesh(mesh, loops).empty());
  RC_ASSERT(test::triangles(mesh) == 0);
}

}  // namespace
}  // namespace beadmesh
