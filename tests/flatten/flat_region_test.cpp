#include "beadmesh/flatten/flat_region.h"

#include <gtest/gtest.h>

#include "flatten/facet_shapes.h"

namespace beadmesh {
namespace {

TEST(FlatRegion, FollowsTheLoops) {
  const Facets facets = shapes::sheet(
      9, 9,
      [](double s, double t) {
        return Vec3{9 * s, 9 * t, 0};
      },
      [](double s, double t) { return std::abs(s - 0.5) > 0.2 || std::abs(t - 0.5) > 0.2; });
  const FlatFace flat = flatten(facets).value();
  std::vector<std::vector<bool>> corners(2);
  corners[0].assign(facets.loops[0].size(), false);
  corners[0][3] = true;
  const PlanarRegion region = flat_region(facets, flat, corners);
  ASSERT_EQ(region.loops.size(), 2u);
  for (std::size_t l = 0; l < 2; ++l) {
    ASSERT_EQ(region.loops[l].points.size(), facets.loops[l].size());
    for (std::size_t i = 0; i < facets.loops[l].size(); ++i)
      EXPECT_EQ(region.loops[l].points[i], flat.positions[facets.loops[l][i]]);
  }
  EXPECT_EQ(region.loops[0].corner, corners[0]);
  EXPECT_TRUE(region.loops[1].corner.empty());
  EXPECT_TRUE(flat_region(facets, flat).loops[0].corner.empty());
}

}  // namespace
}  // namespace beadmesh
