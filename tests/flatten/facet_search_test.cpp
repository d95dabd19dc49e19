#include "beadmesh/flatten/facet_search.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "flatten/facet_shapes.h"

namespace beadmesh {
namespace {

Vec3 point_of(const Facets& facets, const FacetPoint& at) {
  const Triangle& t = facets.triangles[at.triangle];
  return facets.points[t[0]] * at.weight[0] + facets.points[t[1]] * at.weight[1] +
         facets.points[t[2]] * at.weight[2];
}

TEST(NearestWeights, CornersEdgesAndInside) {
  const Vec3 a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
  EXPECT_EQ(nearest_weights(a, b, c, Vec3{-1, -1, 3}), (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(nearest_weights(a, b, c, Vec3{9, 0, 0}), (std::array<double, 3>{0, 1, 0}));
  EXPECT_EQ(nearest_weights(a, b, c, Vec3{2, -5, 1}), (std::array<double, 3>{0.5, 0.5, 0}));
  EXPECT_EQ(nearest_weights(a, b, c, Vec3{3, 3, 0}), (std::array<double, 3>{0, 0.5, 0.5}));
  EXPECT_EQ(nearest_weights(a, b, c, Vec3{1, 1, 7}), (std::array<double, 3>{0.5, 0.25, 0.25}));
}

TEST(NearestWeights, OfSegmentsAndPoints) {
  const Vec3 a{0, 0, 0}, b{4, 0, 0}, c{2, 0, 0};
  const auto w = nearest_weights(a, b, c, Vec3{3, 5, 0});
  EXPECT_NEAR(norm(a * w[0] + b * w[1] + c * w[2] - Vec3{3, 0, 0}), 0, 1e-12);
  EXPECT_EQ(nearest_weights(a, a, a, Vec3{3, 5, 0}), (std::array<double, 3>{1, 0, 0}));
}

RC_GTEST_PROP(FacetSearch, FindsWhatTryingAllFinds, ()) {
  static const Facets facets = shapes::stadium_dome(60, 16, 5);
  static const FacetSearch search(facets);
  const Vec3 p{*rc::gen::inRange(-400, 400) / 10.0, *rc::gen::inRange(-200, 200) / 10.0,
               *rc::gen::inRange(-100, 200) / 10.0};
  double least = std::numeric_limits<double>::infinity();
  Index first = no_index;
  for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
    FacetPoint at;
    at.triangle = static_cast<Index>(t);
    const Triangle& v = facets.triangles[t];
    const auto w = nearest_weights(facets.points[v[0]], facets.points[v[1]], facets.points[v[2]], p);
    std::copy(w.begin(), w.end(), at.weight);
    const double squared = squared_norm(point_of(facets, at) - p);
    if (squared < least) least = squared, first = at.triangle;
  }
  const FacetPoint found = search.nearest(p);
  RC_ASSERT(found.triangle == first);
  RC_ASSERT(std::abs(norm(point_of(facets, found) - p) - std::sqrt(least)) < 1e-12);
}

TEST(FacetSearch, NothingToFind) {
  const Facets none;
  EXPECT_EQ(FacetSearch(none).nearest({0, 0, 0}).triangle, no_index);
  const Facets facets = shapes::cylinder(25, 1, 80);
  EXPECT_EQ(FacetSearch(facets).nearest({std::numeric_limits<double>::quiet_NaN(), 0, 0}).triangle, no_index);
}

}  // namespace
}  // namespace beadmesh
