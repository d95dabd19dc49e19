#include "beadmesh/delaunay/boundary_sampling.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "beadmesh/delaunay/triangulation.h"
#include "delaunay/shapes.h"

namespace beadmesh {
namespace {

using namespace shapes;

const Points strip{{0, 0}, {200, 0}, {200, 20}, {0, 20}};

BoundarySamples sampled(const PlanarRegion& input, const SamplingOptions& options = {}) {
  const auto checked = checked_region(input);
  EXPECT_TRUE(checked);
  return sample_boundary(*checked, options);
}

double length_from(const BoundarySamples& s, Index i) {
  return distance(s.samples[i].point, s.samples[next_sample(s, i)].point);
}

double greatest_ratio(const BoundarySamples& s, bool corners_only = false) {
  double ratio = 1;
  for (Index i = 0; i < static_cast<Index>(s.samples.size()); ++i) {
    if (corners_only && !s.samples[i].corner) continue;
    const double a = length_from(s, previous_sample(s, i)), b = length_from(s, i);
    ratio = std::max({ratio, a / b, b / a});
  }
  return ratio;
}

// Segments over which a third point sees an obtuse angle.
int encroached(const BoundarySamples& s) {
  Points points;
  std::vector<std::vector<Index>> loops(s.first.size() - 1);
  for (const BoundarySample& sample : s.samples) {
    loops[sample.loop].push_back(static_cast<Index>(points.size()));
    points.push_back(sample.point);
  }
  const auto t = triangulate(points, loops);
  EXPECT_TRUE(t);
  int count = 0;
  for (std::size_t i = 0; t && i < t->triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const Triangle& c = t->triangles[i];
      const Vec2 apex = points[c[k]];
      count += t->neighbours[i][k] == no_index &&
               dot(points[c[(k + 1) % 3]] - apex, points[c[(k + 2) % 3]] - apex) < 0;
    }
  return count;
}

TEST(BoundarySampling, strip_is_sampled_by_its_half_width) {
  const auto s = sampled(region({strip}));
  for (Index i = 0; i < static_cast<Index>(s.samples.size()); ++i) {
    EXPECT_GT(length_from(s, i), 2);
    EXPECT_LT(length_from(s, i), 6);
  }
  EXPECT_EQ(std::count_if(s.samples.begin(), s.samples.end(), [](const auto& p) { return p.corner; }), 4);
  EXPECT_DOUBLE_EQ(s.loop_length[0], 440);
  EXPECT_EQ(encroached(s), 0);
}

TEST(BoundarySampling, keeps_all_points_and_their_attributes) {
  PlanarRegion input = region({strip, circle({100, 10}, 4, 20)});
  input.loops[0].curve = {7, 8, 9, 6};
  const auto checked = checked_region(input);
  const auto s = sample_boundary(*checked);
  for (Index l = 0; l < 2; ++l) {
    std::size_t found = 0;
    for (Index i = s.first[l]; i < s.first[l + 1]; ++i) {
      const auto& points = checked->loops[l].points;
      if (found < points.size() && s.samples[i].point == points[found]) ++found;
      EXPECT_EQ(s.samples[i].loop, l);
    }
    EXPECT_EQ(found, checked->loops[l].points.size());
  }
  EXPECT_EQ(s.samples.front().curve, 7);
  EXPECT_EQ(s.samples[s.first[1] - 1].curve, 6);
  EXPECT_FALSE(s.samples[s.first[1]].corner) << "a 20-gon is smooth";
}

TEST(BoundarySampling, positions_are_arc_lengths) {
  const auto s = sampled(region({l_shape()}));
  for (Index i = 0; i + 1 < static_cast<Index>(s.samples.size()); ++i)
    EXPECT_NEAR(s.samples[i].position + length_from(s, i), s.samples[i + 1].position, 1e-9);
}

TEST(BoundarySampling, spacing_is_an_upper_bound) {
  SamplingOptions options;
  options.spacing = 3;
  const auto s = sampled(region({strip}), options);
  for (Index i = 0; i < static_cast<Index>(s.samples.size()); ++i) EXPECT_LE(length_from(s, i), 3 + 1e-9);
  EXPECT_LT(s.samples.size(), 160u);
}

TEST(BoundarySampling, a_narrow_place_is_dense_and_fades_out) {
  const auto s =
      sampled(region({{{0, 0}, {1000, 0}, {1000, 100}, {505, 100}, {500, 1}, {495, 100}, {0, 100}}}));
  double least = 1e9, greatest = 0;
  for (Index i = 0; i < static_cast<Index>(s.samples.size()); ++i) {
    least = std::min(least, length_from(s, i));
    greatest = std::max(greatest, length_from(s, i));
  }
  EXPECT_LT(least, 1);
  EXPECT_GT(greatest, 15);
  EXPECT_LE(greatest_ratio(s), 2 + 1e-6);
  EXPECT_LE(greatest_ratio(s, true), 1 + 1e-6);
  EXPECT_LT(s.samples.size(), 400u);
}

TEST(BoundarySampling, smooth_facets_are_not_split) {
  SamplingOptions options;
  options.facetted = true;
  const Points ring = circle({0, 0}, 100, 100), hole = circle({0, 0}, 85, 90);  // facets of 6.3, thickness 15
  EXPECT_EQ(sampled(region({ring, hole}), options).samples.size(), 190u);
  EXPECT_GT(sampled(region({ring, hole})).samples.size(), 300u);
}

TEST(BoundarySampling, the_number_of_samples_is_bounded) {
  SamplingOptions options;
  options.spacing = 1e-4;
  options.max_samples = 5000;
  EXPECT_LE(sampled(region({strip}), options).samples.size(), 5000u);
}

TEST(BoundarySampling, needle) {
  const auto s = sampled(region({{{0, 0}, {100, 0}, {100, 1}}}));
  EXPECT_LT(s.samples.size(), 5000u);
  EXPECT_LE(greatest_ratio(s, true), 1 + 1e-6);
}

RC_GTEST_PROP(BoundarySampling, graded_on_random_domains, ()) {
  const std::vector<Points> loops{random_star(10, 20), transformed(random_star(2, 6), 0, 1, {0.1, 0.2})};
  const auto checked = checked_region(region(loops));
  RC_PRE(checked.has_value());
  const auto s = sample_boundary(*checked);
  RC_ASSERT(greatest_ratio(s) <= 2.001);
  RC_ASSERT(s.first.back() == static_cast<Index>(s.samples.size()));
}

}  // namespace
}  // namespace beadmesh
