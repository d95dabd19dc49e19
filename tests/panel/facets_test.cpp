#include "beadmesh/panel/facets.h"

#include <gtest/gtest.h>

#include "panel/panel_shapes.h"

namespace beadmesh {
namespace {

TEST(FacetsOfTriangles, TracesTheLoopOfASquare) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Facets facets = facets_of_triangles(points, {{0, 1, 2}, {0, 2, 3}});
  ASSERT_EQ(facets.loops.size(), 1u);
  EXPECT_EQ(facets.loops[0].size(), 4u);
  EXPECT_DOUBLE_EQ(area(facets), 1);
  EXPECT_EQ(vector_area(facets), (Vec3{0, 0, 1}));
}

TEST(FacetsOfTriangles, SplitsAPointWhereThePieceOnlyTouchesItself) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  const Facets facets = facets_of_triangles(points, {{0, 1, 2}, {0, 3, 4}});
  EXPECT_EQ(facets.points.size(), 6u);
  EXPECT_EQ(facets.loops.size(), 2u);
}

TEST(FacetsOfTriangles, CutsAnEdgeOfThreeTriangles) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
  const Facets facets = facets_of_triangles(points, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  EXPECT_EQ(facets.loops.size(), 3u);
}

TEST(OuterLoop, IsTheLargestOfARing) {
  const Panel panel = test::disc_in_ring();
  Facets ring = panel.faces[1].facets;
  EXPECT_EQ(outer_loop(ring), 0u);
  std::swap(ring.loops[0], ring.loops[1]);
  EXPECT_EQ(outer_loop(ring), 1u);
}

TEST(OuterLoop, IsTheLongestOfATube) {
  const int n = 12;
  std::vector<Vec3> points;
  for (const double radius : {1.0, 1.02})
    for (int i = 0; i < n; ++i)
      points.push_back(
          {radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n), 40 * (radius - 1)});
  std::vector<Triangle> triangles;
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    triangles.push_back({i, j, n + j});
    triangles.push_back({i, n + j, n + i});
  }
  const Facets tube = facets_of_triangles(points, triangles);
  ASSERT_EQ(tube.loops.size(), 2u);
  EXPECT_GE(tube.panel_points[tube.loops[0][0]], n);
}

}  // namespace
}  // namespace beadmesh
