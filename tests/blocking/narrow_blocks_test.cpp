#include "beadmesh/blocking/narrow_blocks.h"

#include <gtest/gtest.h>

#include "bead/studied_bead.h"
#include "blocking/layout_check.h"
#include "medial/shapes.h"

namespace beadmesh {
namespace {

using namespace shapes;

Result<BlockLayout> narrow(const PlanarRegion& drawn, const NarrowBlockOptions& options = {}) {
  const PlanarRegion region = checked_region(drawn).value();
  const Skeleton skeleton = skeleton_of(medial_of(region));
  return blocks_of_narrow_bead(skeleton, ridge_of(skeleton, region), region, options);
}

TEST(NarrowBlocks, AreAStripOfOneElementAcross) {
  auto layout = narrow(stadium(60, 2));
  ASSERT_TRUE(layout) << layout.error().message;
  const auto counted = assign_counts(*layout, flat_lengths(*layout), {5, 2.5});
  ASSERT_TRUE(counted) << counted.error().message;
  expect_counted(*layout);
  int splits = 0, elements = 0;
  for (const VirtualEdge& edge : layout->edges) {
    EXPECT_TRUE(edge.kind == VirtualEdgeKind::boundary || edge.kind == VirtualEdgeKind::split);
    if (edge.kind != VirtualEdgeKind::split) continue;
    ++splits;
    EXPECT_EQ(edge.count, 1);
    EXPECT_NEAR(distance(edge.points.front(), edge.points.back()), 4, 0.01);
  }
  EXPECT_EQ(size_t(splits), layout->blocks.size() - 1);
  double area = 0;
  for (const Block& block : layout->blocks) {
    area += polygon_area(outline(*layout, block));
    elements += layout->edges[block.sides[1].edges[0]].count;
  }
  EXPECT_NEAR(area, 60 * 4 + 4 * pi, 0.5) << "they fill the bead";
  EXPECT_NEAR(elements, 13, 2);
}

TEST(NarrowBlocks, EndsKeepTheMinimum) {
  const auto layout = narrow(stadium(60, 2), {5, 3});
  ASSERT_TRUE(layout);
  int ends = 0;
  for (const VirtualEdge& edge : layout->edges)
    if (edge.kind == VirtualEdgeKind::boundary && edge.count == 1) {
      EXPECT_GE(distance(edge.points.front(), edge.points.back()), 3);
      ++ends;
    }
  EXPECT_EQ(ends, 6) << "two ends of three sides";
}

TEST(NarrowBlocks, RefuseWhatHasJunctionsOrNoLength) {
  const auto branched = narrow(region_of(t_footprint(4, 60, 30, 3)));
  ASSERT_FALSE(branched);
  EXPECT_EQ(branched.error().code, "blocking.narrow");
  const auto stub = narrow(stadium(6, 2));
  ASSERT_FALSE(stub);
  EXPECT_EQ(stub.error().code, "blocking.narrow");
}

}  // namespace
}  // namespace beadmesh
