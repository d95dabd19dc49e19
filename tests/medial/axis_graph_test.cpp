#include "beadmesh/medial/axis_graph.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "medial/sampled_shape.h"

namespace beadmesh {
namespace {

Index holes_of(const AxisGraph& graph) {
  Index closed = 0;
  for (const AxisEdge& edge : graph.edges) closed += edge.start == no_index;
  return static_cast<Index>(graph.edges.size()) - static_cast<Index>(graph.nodes.size()) + 1 -
         (closed > 0 && graph.nodes.empty() ? 1 : 0);
}

TEST(AxisGraph, ContractionMakesAStadiumOneEdge) {
  const shapes::SampledShape shape = shapes::sampled(shapes::stadium(100, 8));
  AxisTriangles axis(shape.triangulation, shape.samples);
  EXPECT_GT(axis.march().nodes.size(), 6u) << "the samples of the caps are cocircular";
  axis.contract(1e-3);
  const AxisGraph graph = axis.march();
  EXPECT_EQ(graph.nodes.size(), 2u);
  EXPECT_EQ(graph.edges.size(), 1u);
}

TEST(AxisGraph, RingHasNoNodes) {
  const shapes::SampledShape shape = shapes::sampled(shapes::annulus(40, 28));
  AxisTriangles axis(shape.triangulation, shape.samples);
  const AxisGraph graph = axis.march();
  EXPECT_TRUE(graph.nodes.empty());
  ASSERT_EQ(graph.edges.size(), 1u);
  EXPECT_EQ(graph.edges[0].start, no_index);
  EXPECT_EQ(graph.edges[0].half_edges.size(), shape.triangulation.triangles.size());
}

TEST(AxisGraph, DomainsOfOneAndTwoTriangles) {
  const shapes::SampledShape one = shapes::sampled(shapes::region_of({{{0, 0}, {4, 0}, {0, 3}}}));
  EXPECT_EQ(AxisTriangles(one.triangulation, one.samples).march().nodes.size(), 1u);
  const shapes::SampledShape two = shapes::sampled(shapes::rectangle(4, 3));
  const AxisGraph graph = AxisTriangles(two.triangulation, two.samples).march();
  EXPECT_EQ(graph.nodes.size(), 2u);
  EXPECT_EQ(graph.edges.size(), 1u);
}

TEST(AxisGraph, ClosedHalfEdgesNeverCloseACycle) {
  const shapes::SampledShape shape = shapes::sampled(shapes::annulus(40, 28));
  AxisTriangles axis(shape.triangulation, shape.samples);
  const std::vector<Index> chain = axis.march().edges[0].half_edges;
  std::size_t refused = 0;
  for (const Index h : chain) refused += !axis.close(h, axis.cluster_of(chain[0]));
  EXPECT_EQ(refused, 1u);
  EXPECT_EQ(axis.march().edges.size(), 1u) << "the hole is still there";
}

TEST(AxisGraph, SectorsOfAllNodesAndEdgesCoverTheBoundaryInOrder) {
  const shapes::SampledShape shape = shapes::sampled(shapes::letter_t(14, 6));
  AxisTriangles axis(shape.triangulation, shape.samples);
  axis.contract(1e-3);
  std::size_t steps = 0;
  std::vector<char> seen(3 * shape.triangulation.triangles.size(), 0);
  for (const AxisEdge& edge : axis.march().edges)
    for (const Index half : edge.half_edges)
      for (const Index h : {half, axis.twin(half)}) {
        if (seen[h]) continue;
        seen[h] = 1;
        const Sector sector = axis.sector_after(h);
        for (Index i = sector.first; i != sector.last; i = next_sample(shape.samples, i)) ++steps;
      }
  EXPECT_EQ(steps, shape.samples.samples.size());
}

RC_GTEST_PROP(AxisGraphProperty, HolesAreKeptByMarchAndContraction, ()) {
  const int holes = *rc::gen::inRange(0, 6);
  const double tolerance = *rc::gen::element(1e-3, 0.1, 2.0);
  std::vector<std::vector<Vec2>> loops{shapes::circle({0, 0}, 100, {6, 0.5, 0})};
  for (int k = 0; k < holes; ++k) {
    const double r = *rc::gen::inRange(5, 20);
    loops.push_back(shapes::circle(Vec2{std::cos(k * 1.05), std::sin(k * 1.05)} * 60.0, r, {4, 0.5, 0}));
  }
  const shapes::SampledShape shape = shapes::sampled(shapes::region_of(loops, true));
  AxisTriangles axis(shape.triangulation, shape.samples);
  RC_ASSERT(holes_of(axis.march()) == holes);
  axis.contract(tolerance);
  RC_ASSERT(holes_of(axis.march()) == holes);
}

}  // namespace
}  // namespace beadmesh
