#include "beadmesh/blocking/block_layout.h"

#include <gtest/gtest.h>

#include "blocking/layout_check.h"
#include "medial/shapes.h"

namespace beadmesh {
namespace {

using namespace shapes;

/// 40 x 20, positions from the lower left corner: 40, 60 and 100 are the other corners.
const PlanarRegion& box() {
  static const PlanarRegion region = rectangle(40, 20);
  return region;
}

struct Corners {
  Index a, b, c, d;
};

Corners add_corners(BlockLayoutBuilder& builder) {
  return {builder.add_boundary_vertex({0, 0}), builder.add_boundary_vertex({0, 40}),
          builder.add_boundary_vertex({0, 60}), builder.add_boundary_vertex({0, 100})};
}

TEST(BlockLayout, BoundaryPositionsAreArcLengths) {
  const BlockLayoutBuilder builder(box());
  EXPECT_EQ(builder.loop_length(0), 120);
  EXPECT_LT(distance(builder.point_at({0, 50}), {40, 10}), 1e-12);
  EXPECT_LT(distance(builder.point_at({0, 110}), {0, 10}), 1e-12) << "on the closing segment";
  EXPECT_LT(distance(builder.point_at({0, -10}), {0, 10}), 1e-12) << "any turn";
  EXPECT_LT(distance(builder.point_at({0, 165}), {40, 5}), 1e-12);
}

TEST(BlockLayout, EdgeBetweenTwoVerticesIsShared) {
  BlockLayoutBuilder builder(box());
  const Index a = builder.add_vertex({1, 1}), b = builder.add_vertex({5, 1});
  const Index edge = builder.add_edge(a, b, VirtualEdgeKind::inner, {{3, 2}}, 2);
  EXPECT_EQ(builder.add_edge(b, a, VirtualEdgeKind::ridge), edge);
  EXPECT_EQ(builder.find_edge(b, a), edge);
  EXPECT_EQ(builder.find_edge(a, a), no_index);
  EXPECT_EQ(builder.edge(edge).points.size(), 3);
  EXPECT_EQ(builder.edge(edge).kind, VirtualEdgeKind::inner) << "as it was first";
}

TEST(BlockLayout, BoundaryEdgeRunsEitherWayRound) {
  BlockLayoutBuilder builder(box());
  const Index from = builder.add_boundary_vertex({0, 110}), to = builder.add_boundary_vertex({0, 50});
  const VirtualEdge forward = builder.edge(builder.add_boundary_edge(from, to, false));
  EXPECT_EQ(forward.from, 110);
  EXPECT_EQ(forward.to, 170) << "over the loop's first point";
  EXPECT_EQ(forward.points, (std::vector<Vec2>{{0, 10}, {0, 0}, {40, 0}, {40, 10}}));

  BlockLayoutBuilder other(box());
  const Index start = other.add_boundary_vertex({0, 10}), end = other.add_boundary_vertex({0, 110});
  const VirtualEdge backward = other.edge(other.add_boundary_edge(start, end, true));
  EXPECT_EQ(backward.to, -10);
  EXPECT_EQ(backward.points, (std::vector<Vec2>{{10, 0}, {0, 0}, {0, 10}}));
}

TEST(BlockLayout, OneBlockCoversTheRegion) {
  BlockLayoutBuilder builder(box());
  const Corners v = add_corners(builder);
  builder.add_boundary_edge(v.a, v.b, false);
  builder.add_boundary_edge(v.b, v.c, false);
  builder.add_boundary_edge(v.c, v.d, false);
  builder.add_boundary_edge(v.d, v.a, false);
  builder.add_block({{{v.a, v.b}, {v.b, v.c}, {v.c, v.d}, {v.d, v.a}}});
  const auto layout = builder.take();
  ASSERT_TRUE(layout);
  expect_sound(*layout, box());
}

TEST(BlockLayout, ClockwiseBlocksAreTurnedOver) {
  BlockLayoutBuilder builder(box());
  const Corners v = add_corners(builder);
  const Index middle = builder.add_boundary_vertex({0, 20});
  builder.add_boundary_edge(v.a, middle, false);
  builder.add_boundary_edge(middle, v.b, false);
  builder.add_boundary_edge(v.c, v.b, true);
  builder.add_boundary_edge(v.c, v.d, false);
  builder.add_boundary_edge(v.a, v.d, true);
  builder.add_block({{{v.a, v.d}, {v.d, v.c}, {v.c, v.b}, {v.b, middle, v.a}}});
  const auto layout = builder.take();
  ASSERT_TRUE(layout);
  expect_sound(*layout, box());
}

TEST(BlockLayout, MissingSideIsSaid) {
  BlockLayoutBuilder builder(box());
  const Corners v = add_corners(builder);
  builder.add_boundary_edge(v.a, v.b, false);
  builder.add_block({{{v.a, v.b}, {v.b, v.c}, {v.c, v.d}, {v.d, v.a}}});
  const auto layout = builder.take();
  ASSERT_FALSE(layout);
  EXPECT_EQ(layout.error().code, "blocking.missing_edge");
}

TEST(BlockLayout, BoundaryEdgeBetweenTwoLoopsIsRefused) {
  const PlanarRegion ring = checked_region(annulus(20, 10)).value();
  BlockLayoutBuilder builder(ring);
  const Index a = builder.add_boundary_vertex({0, 0}), b = builder.add_boundary_vertex({1, 0});
  EXPECT_EQ(builder.add_boundary_edge(a, b, false), no_index);
  EXPECT_FALSE(builder.take());
}

}  // namespace
}  // namespace beadmesh
