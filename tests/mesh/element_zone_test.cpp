#include "beadmesh/mesh/element_zone.h"

#include <gtest/gtest.h>

#include "mesh/sample_quads.h"

namespace beadmesh {
namespace {

using sample::grid;

TEST(ElementZone, RingsGrowOverNodes) {
  const QuadConnectivity mesh(grid(9, 9, 1));
  EXPECT_EQ(elements_within(mesh, 40, 0), std::vector<Index>{40});
  EXPECT_EQ(elements_within(mesh, 40, 1).size(), 9u);
  EXPECT_EQ(elements_within(mesh, 40, 2).size(), 25u);
  EXPECT_EQ(elements_within(mesh, 0, 1).size(), 4u) << "at a corner";
  EXPECT_EQ(elements_within(mesh, 40, 50).size(), 81u);
}

TEST(ElementZone, OutlineRunsRoundCounterClockwise) {
  const PlanarMesh mesh = grid(3, 2, 1);
  const auto loop = closed_loop(outline_of(mesh.elements));
  ASSERT_TRUE(loop);
  ASSERT_EQ(loop->size(), 10u);
  double area = 0;
  for (size_t i = 0; i < loop->size(); ++i)
    area += cross(mesh.nodes[(*loop)[i]], mesh.nodes[(*loop)[(i + 1) % loop->size()]]) / 2;
  EXPECT_DOUBLE_EQ(area, 6);
}

TEST(ElementZone, NoLoopRoundAHoleOrThroughANodeTwice) {
  PlanarMesh ring = grid(3, 3, 1);
  ring.elements.erase(ring.elements.begin() + 4);
  EXPECT_FALSE(closed_loop(outline_of(ring.elements)));
  const PlanarMesh square = grid(2, 2, 1);
  EXPECT_FALSE(closed_loop(outline_of({square.elements[0], square.elements[3]}))) << "they share a node";
  EXPECT_FALSE(closed_loop({}));
}

TEST(ElementZone, WhatIsGoneIsLeftOut) {
  const PlanarMesh mesh = grid(3, 1, 1);
  QuadConnectivity edited(mesh);
  edited.remove_element(0);
  std::vector<Index> number;
  const PlanarMesh left = living_part(edited, mesh.nodes, mesh.freedom, number);
  EXPECT_EQ(left.elements.size(), 2u);
  EXPECT_EQ(left.nodes.size(), 6u);
  EXPECT_EQ(number[0], no_index);
  EXPECT_EQ(number[1], 0);
  EXPECT_EQ(left.nodes[number[7]], mesh.nodes[7]);
}

}  // namespace
}  // namespace beadmesh
