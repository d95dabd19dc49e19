#include "beadmesh/medial/sampled_boundary.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "medial/exact_region.h"
#include "medial/shapes.h"

namespace beadmesh {
namespace {

struct Sampled {
  BoundaryCurve curve;
  SampledBoundary boundary;

  explicit Sampled(const PlanarRegion& region, const SamplingOptions& options = {})
      : curve(checked_region(region).value(), radians(160)),
        boundary(sampled_boundary(curve, options).value()) {}

  const std::vector<BoundarySample>& samples() const { return boundary.samples.samples; }
  Index count() const { return static_cast<Index>(samples().size()); }
  double length_from(Index i) const {
    return distance(samples()[i].point, samples()[next_sample(boundary.samples, i)].point);
  }
  double greatest_ratio(bool corners_only = false) const {
    double ratio = 1;
    for (Index i = 0; i < count(); ++i) {
      if (corners_only && !samples()[i].corner) continue;
      const double a = length_from(previous_sample(boundary.samples, i)), b = length_from(i);
      ratio = std::max({ratio, a / b, b / a});
    }
    return ratio;
  }
  /// Segments over which a third point sees an obtuse angle.
  int encroached() const {
    int found = 0;
    const Triangulation& t = boundary.triangulation;
    for (std::size_t i = 0; i < t.triangles.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const Triangle& c = t.triangles[i];
        const Vec2 apex = t.points[c[k]];
        found += t.neighbours[i][k] == no_index &&
                 dot(t.points[c[(k + 1) % 3]] - apex, t.points[c[(k + 2) % 3]] - apex) < 0;
      }
    return found;
  }
  void verify() const {
    std::vector<std::vector<Index>> loops;
    for (std::size_t l = 0; l + 1 < boundary.samples.first.size(); ++l) {
      loops.emplace_back();
      for (Index i = boundary.samples.first[l]; i < boundary.samples.first[l + 1]; ++i) {
        EXPECT_EQ(boundary.triangulation.points[i], samples()[i].point);
        loops.back().push_back(i);
      }
    }
    const auto violations = verify_triangulation(boundary.triangulation, loops);
    EXPECT_TRUE(violations.empty()) << violations.front();
  }
};

TEST(SampledBoundary, StripIsSampledByItsHalfWidth) {
  const Sampled strip(shapes::rectangle(200, 20));
  strip.verify();
  EXPECT_EQ(strip.encroached(), 0);
  EXPECT_LE(strip.greatest_ratio(), 2 * (1 + 1e-6));
  for (Index i = 0; i < strip.count(); ++i)
    if (strip.samples()[i].point.y == 0 && std::abs(strip.samples()[i].point.x - 100) < 50) {
      EXPECT_LE(strip.length_from(i), 5 * 1.01);
      EXPECT_GT(strip.length_from(i), 1);
    }
  EXPECT_LT(strip.count(), 300);
}

TEST(SampledBoundary, KeepsAllPointsInOrder) {
  const Sampled shape(shapes::gasket());
  shape.verify();
  const PlanarRegion& region = shape.curve.tagged_region();
  for (std::size_t l = 0; l < region.loops.size(); ++l) {
    std::size_t at = 0;
    for (Index i = shape.boundary.samples.first[l]; i < shape.boundary.samples.first[l + 1]; ++i) {
      const BoundarySample& sample = shape.samples()[i];
      EXPECT_EQ(sample.loop, static_cast<Index>(l));
      if (sample.t > 0) {
        EXPECT_EQ(sample.segment, static_cast<Index>(at) - 1);
        EXPECT_FALSE(sample.corner);
        continue;
      }
      ASSERT_EQ(sample.segment, static_cast<Index>(at));
      EXPECT_EQ(sample.point, region.loops[l].points[at]);
      EXPECT_EQ(sample.corner, region.loops[l].corner[at]);
      ++at;
    }
    EXPECT_EQ(at, region.loops[l].points.size());
  }
}

TEST(SampledBoundary, SpacingIsAnUpperBound) {
  SamplingOptions options;
  options.spacing = 3;
  const Sampled shape(shapes::rectangle(200, 60), options);
  for (Index i = 0; i < shape.count(); ++i) EXPECT_LE(shape.length_from(i), 3);
  EXPECT_GT(shape.count(), 520 / 3);
}

TEST(SampledBoundary, FacetsThatAreFineAreNotSplit) {
  const PlanarRegion stadium = shapes::stadium(100, 8);
  EXPECT_EQ(Sampled(stadium).samples().size(), stadium.loops[0].points.size());
}

TEST(SampledBoundary, NewSamplesLieOnAnExactCurve) {
  const Sampled disc(exact_shapes::annulus(50, 40, {6, -1}));
  disc.verify();
  EXPECT_GT(disc.count(), 200);
  for (const BoundarySample& sample : disc.samples())
    EXPECT_NEAR(sample.loop == 0 ? norm(sample.point) : distance(sample.point, {6, -1}),
                sample.loop == 0 ? 50 : 40, 1e-12);
}

TEST(SampledBoundary, EveryConvexCornerHasATriangleOfItsOwn) {
  const Sampled comb(shapes::comb(6, 12, 26, 30));
  comb.verify();
  EXPECT_LE(comb.greatest_ratio(true), 2 * (1 + 1e-6));
  int ears = 0;
  for (std::size_t t = 0; t < comb.boundary.triangulation.triangles.size(); ++t) {
    const auto& around = comb.boundary.triangulation.neighbours[t];
    ears += std::count(around.begin(), around.end(), no_index) == 2;
  }
  int convex = 0;
  for (Index i = 0; i < comb.curve.segments(0); ++i) convex += comb.curve.is_convex_corner(0, i);
  EXPECT_EQ(ears, convex);
}

// What comes as near as one likes needs no samples as near: straight sides at a corner or along a slit.
TEST(SampledBoundary, NeedlesAndSlitsAreNoThickness) {
  const double needle = radians(0.01);
  EXPECT_LT(Sampled(shapes::region_of({{{0, 0}, {100, 0}, {100, 100 * std::tan(needle)}}})).count(), 1000);
  const Sampled slit(shapes::region_of({{{0, 0}, {10, 0}, {10, 10}, {0, 10}},
                                        {{1, 1}, {4, 1}, {4, 4}, {1, 4}},
                                        {{4 + 1e-12, 1}, {7, 1}, {7, 4}, {4 + 1e-12, 4}}}));
  EXPECT_LT(slit.count(), 3000);
}

TEST(SampledBoundary, TheNumberOfSamplesIsBounded) {
  SamplingOptions options;
  options.max_samples = 50;
  const BoundaryCurve curve(exact_shapes::annulus(50, 49.9, {}), radians(160));
  const auto sampled = sampled_boundary(curve, options);
  ASSERT_FALSE(sampled);
  EXPECT_EQ(sampled.error().code, "medial.too_many_samples");
}

TEST(AddSamples, PutsThemOnTheCurveButNoneTwice) {
  Sampled shape(shapes::stadium(100, 8));
  const auto before = shape.count();
  const Contact contact = shape.curve.nearest({31, 0}, SegmentRun{0, 0, shape.curve.segments(0)});
  const BoundaryPlace inside{contact.place.loop, contact.place.segment, 0.4};
  EXPECT_TRUE(add_samples(shape.boundary, {inside, inside}, shape.curve));
  EXPECT_EQ(shape.count(), before + 1);
  shape.verify();
  EXPECT_FALSE(add_samples(shape.boundary, {inside}, shape.curve));
}

RC_GTEST_PROP(SampledBoundaryProperty, GradedAndDelaunayOnRandomPolygons, ()) {
  const int n = *rc::gen::inRange(3, 40);
  std::vector<Vec2> star;
  for (int i = 0; i < n; ++i) {
    const double t = 2 * pi * i / n, r = *rc::gen::inRange(20, 200);
    star.push_back({r * std::cos(t), r * std::sin(t)});
  }
  PlanarRegion polygon = shapes::region_of({star});
  polygon.loops[0].corner.assign(star.size(), true);
  const auto region = checked_region(polygon);
  RC_PRE(region.has_value());
  const Sampled shape(*region);
  shape.verify();
  RC_ASSERT(shape.greatest_ratio() <= 2.2);
}

}  // namespace
}  // namespace beadmesh
