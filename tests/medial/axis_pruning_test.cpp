#include "beadmesh/medial/axis_pruning.h"

#include <gtest/gtest.h>

#include "medial/sampled_shape.h"

namespace beadmesh {
namespace {

TEST(Protrusion, IsWhatTheBoundaryWouldLose) {
  EXPECT_NEAR(protrusion({{3, 0}, 1}, {{0, 0}, 2}), 2, 1e-15);
  EXPECT_NEAR(protrusion({{1, 0}, 1}, {{0, 0}, 2}), 0, 1e-15);
}

TEST(PruneTolerance, FollowsFacetsAndNoise) {
  const shapes::SampledShape clean = shapes::sampled(shapes::stadium(120, 10));
  const PruneTolerance tolerance(clean.curve, clean.samples, 0);
  EXPECT_LT(tolerance.at(20), 1e-6) << "middle of a straight line";
  EXPECT_GT(tolerance.at(70), 0.02) << "on a cap";
  EXPECT_EQ(PruneTolerance(clean.curve, clean.samples, 0.3).at(20), 0.3);
  const shapes::SampledShape noisy = shapes::sampled(shapes::noisy(shapes::stadium(120, 10), 0.01, 1));
  EXPECT_GT(PruneTolerance(noisy.curve, noisy.samples, 0).at(20), 0.02);
}

TEST(Prune, RemovesABumpAndKeepsTheEnds) {
  PlanarRegion region = shapes::stadium(120, 10);
  region.loops[0].points[25].y -= 0.4;  // spacing 2: more than h^2 / 2 r
  const shapes::SampledShape shape = shapes::sampled(region);
  AxisTriangles axis(shape.triangulation, shape.samples);
  axis.contract(1e-3);
  EXPECT_GT(axis.march().edges.size(), 1u);
  prune(axis, PruneTolerance(shape.curve, shape.samples, 0.5));
  const AxisGraph graph = axis.march();
  ASSERT_EQ(graph.nodes.size(), 2u);
  for (const AxisNode& node : graph.nodes) {
    const Vec2 at = axis.cluster(axis.find(node.triangle)).circle.centre;
    EXPECT_LT(std::min(norm(at), distance(at, {120, 0})), 1);
  }
}

TEST(Prune, NeverACorner) {
  const shapes::SampledShape shape = shapes::sampled(shapes::region_of({{{0, 0},
                                                                         {5, 0},
                                                                         {10, 0},
                                                                         {15, 0},
                                                                         {20, 0},
                                                                         {20, 5},
                                                                         {20, 10},
                                                                         {15, 10},
                                                                         {10, 10},
                                                                         {5, 10},
                                                                         {0, 10},
                                                                         {0, 5}}}));
  AxisTriangles axis(shape.triangulation, shape.samples);
  prune(axis, PruneTolerance(shape.curve, shape.samples, 100));
  Index corners = 0;
  for (const AxisNode& node : axis.march().nodes)
    corners += axis.cluster(axis.find(node.triangle)).corner != no_index;
  EXPECT_EQ(corners, 4);
}

TEST(Prune, NeverSwallowsAHole) {
  const shapes::SampledShape shape = shapes::sampled(shapes::gasket());
  AxisTriangles axis(shape.triangulation, shape.samples);
  prune(axis, PruneTolerance(shape.curve, shape.samples, 1000));
  const AxisGraph graph = axis.march();
  EXPECT_EQ(graph.edges.size() + 1 - graph.nodes.size(), 40u);
}

TEST(MergeJunctions, JoinsACrossingButNotTeeth) {
  const auto junctions = [](const PlanarRegion& region, bool crossings = true) {
    const shapes::SampledShape shape = shapes::sampled(region);
    AxisTriangles axis(shape.triangulation, shape.samples);
    axis.contract(1e-3);
    prune(axis, PruneTolerance(shape.curve, shape.samples, 0));
    merge_junctions(axis, shape.curve, shape.samples, crossings, 0);
    Index count = 0;
    for (const AxisNode& node : axis.march().nodes) count += node.out.size() > 2;
    return count;
  };
  EXPECT_EQ(junctions(shapes::letter_x(14, radians(70), 6)), 1);
  EXPECT_EQ(junctions(shapes::letter_x(14, radians(70), 6), false), 2);
  EXPECT_EQ(junctions(shapes::letter_h(14, 6)), 2);
  EXPECT_EQ(junctions(shapes::comb(8, 12, 26, 30, 5)), 6);
}

TEST(SettleEnds, PutsANoisyEndOnTheCentreOfItsArc) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const shapes::SampledShape shape = shapes::sampled(shapes::noisy(shapes::stadium(120, 10), 0.01, seed));
    AxisTriangles axis(shape.triangulation, shape.samples);
    axis.contract(1e-3);
    const PruneTolerance tolerance(shape.curve, shape.samples, 0);
    prune(axis, tolerance);
    settle_ends(axis, shape.curve, shape.samples, tolerance);
    for (const AxisNode& node : axis.march().nodes) {
      const Vec2 at = axis.cluster(axis.find(node.triangle)).circle.centre;
      EXPECT_LT(std::min(norm(at), distance(at, {120, 0})), 0.05) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace beadmesh
