#include "beadmesh/delaunay/boundary_splitter.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "delaunay/shapes.h"

namespace beadmesh {
namespace {

struct Split {
  BoundarySamples samples;
  Triangulation triangulation;

  explicit Split(const std::vector<shapes::Points>& loops) {
    PlanarRegion region = checked_region(shapes::region(loops)).value();
    for (PlanarLoop& loop : region.loops) loop.corner.assign(loop.points.size(), true);
    samples = samples_of(region);
    triangulation = triangulate(points(), indices()).value();
  }
  std::vector<Vec2> points() const {
    std::vector<Vec2> points;
    for (const BoundarySample& sample : samples.samples) points.push_back(sample.point);
    return points;
  }
  std::vector<std::vector<Index>> indices() const {
    std::vector<std::vector<Index>> loops;
    for (std::size_t l = 0; l + 1 < samples.first.size(); ++l) {
      loops.emplace_back();
      for (Index i = samples.first[l]; i < samples.first[l + 1]; ++i) loops.back().push_back(i);
    }
    return loops;
  }
  BoundarySplitter splitter() { return {std::move(samples), std::move(triangulation)}; }
  std::vector<std::string> violations() const { return verify_triangulation(triangulation, indices()); }
};

Index halve(BoundarySplitter& splitter, Index edge, Vec2 offset = {}) {
  const BoundarySample &from = splitter.sample(edge), &to = splitter.sample(splitter.next(edge));
  BoundarySample added = from;
  added.corner = false;
  added.t = (from.t + (to.segment == from.segment && to.t > from.t ? to.t : 1)) / 2;
  const Vec2 middle = lerp(from.point, to.point, 0.5);
  added.point = middle + offset;
  std::vector<Index> touched;
  return splitter.split(edge, added, middle, touched);
}

TEST(BoundarySplitter, KnowsTheBoundary) {
  Split square({shapes::square(0, 0, 4)});
  BoundarySplitter splitter = square.splitter();
  EXPECT_EQ(splitter.count(), 4);
  EXPECT_EQ(splitter.next(3), 0);
  EXPECT_EQ(splitter.previous(0), 3);
  int ears = 0;
  for (Index i = 0; i < 4; ++i) ears += splitter.is_ear(i);
  EXPECT_EQ(ears, 2);
}

TEST(BoundarySplitter, ReportsTheEdgesWhoseTriangleChanged) {
  Split square({shapes::square(0, 0, 4)});
  BoundarySplitter splitter = square.splitter();
  std::vector<Index> touched;
  const BoundarySample added{{2, 0}, 0.5, 0, 0, false};
  const Index made = splitter.split(0, added, {2, 0}, touched);
  ASSERT_EQ(made, 4);
  EXPECT_EQ(splitter.next(0), 4);
  EXPECT_EQ(splitter.next(4), 1);
  EXPECT_TRUE(std::count(touched.begin(), touched.end(), 0));
  EXPECT_TRUE(std::count(touched.begin(), touched.end(), 4));
}

TEST(BoundarySplitter, APointThatDoesNotFitIsPutOnTheChord) {
  Split square({shapes::square(0, 0, 4)});
  BoundarySplitter splitter = square.splitter();
  const Index made = halve(splitter, 0, {0, 3});
  ASSERT_NE(made, no_index);
  EXPECT_EQ(splitter.sample(made).point, (Vec2{2, 0}));
  const Index bulging = halve(splitter, 1, {0.3, 0});
  EXPECT_EQ(splitter.sample(bulging).point, (Vec2{4.3, 2}));
  const Index far = halve(splitter, 2, {std::nan(""), 0});
  EXPECT_EQ(splitter.sample(far).point, (Vec2{2, 4}));
}

TEST(BoundarySplitter, FinishPutsSamplesInLoopOrder) {
  Split ring({shapes::square(0, 0, 10), shapes::square(3, 3, 4)});
  BoundarySplitter splitter = ring.splitter();
  halve(splitter, 5);
  halve(splitter, 0);
  halve(splitter, 0);
  splitter.finish(ring.samples, ring.triangulation);
  EXPECT_EQ(ring.samples.first, (std::vector<Index>{0, 6, 11}));
  EXPECT_EQ(ring.samples.samples[1].point, (Vec2{2.5, 0}));
  EXPECT_EQ(ring.samples.samples[2].point, (Vec2{5, 0}));
  EXPECT_EQ(ring.samples.samples[6].loop, 1);
  EXPECT_TRUE(ring.violations().empty());
}

RC_GTEST_PROP(BoundarySplitter, StaysConstrainedDelaunay, ()) {
  std::vector<shapes::Points> loops{shapes::random_star(10, 20), shapes::square(-1, -1, 2)};
  Split shape(loops);
  BoundarySplitter splitter = shape.splitter();
  const int splits = *rc::gen::inRange(1, 60);
  for (int i = 0; i < splits; ++i) {
    const Index edge = *rc::gen::inRange(0, splitter.count());
    const double bulge = *rc::gen::inRange(-10, 11) / 400.0;
    halve(splitter, edge, {bulge, -bulge / 2});
  }
  const Index count = splitter.count();
  splitter.finish(shape.samples, shape.triangulation);
  RC_ASSERT(static_cast<Index>(shape.samples.samples.size()) == count);
  // Bulges may make the boundary cross itself across a narrow place; only a simple one has a triangulation.
  RC_PRE(triangulate(shape.points(), shape.indices()).has_value());
  const auto violations = shape.violations();
  if (!violations.empty()) RC_FAIL(violations.front());
}

}  // namespace
}  // namespace beadmesh
