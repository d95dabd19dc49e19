#include "beadmesh/geometry/segment_search.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "beadmesh/geometry/polyline.h"

namespace beadmesh {
namespace {

TEST(SegmentSearch, unit_square) {
  const auto search = SegmentSearch::of_loops({{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  const auto right = search.nearest({0.9, 0.5});
  EXPECT_EQ(right.segment, 1);
  EXPECT_EQ(right.point, (Vec2{1, 0.5}));
  EXPECT_NEAR(right.distance, 0.1, 1e-15);
  EXPECT_EQ(search.nearest({0.5, 0.5}).segment, 0) << "the first of four equally near";
  EXPECT_EQ(search.nearest_within({0.5, 0.5}, 0.4).segment, no_index);
}

TEST(SegmentSearch, no_segments) {
  EXPECT_EQ(SegmentSearch({}).nearest({1, 2}).segment, no_index);
}

RC_GTEST_PROP(SegmentSearch, equals_a_look_at_every_segment, ()) {
  const auto point = [] { return Vec2{*rc::gen::inRange(-9, 10) * 0.5, *rc::gen::inRange(-9, 10) * 0.5}; };
  std::vector<std::array<Vec2, 2>> segments(*rc::gen::inRange(1, 60));
  for (auto& segment : segments) segment = {point(), point()};
  const Vec2 p = point();
  NearestOnSegments best;
  double least = 1e300;
  for (Index i = 0; i < static_cast<Index>(segments.size()); ++i) {
    const auto [a, b] = segments[i];
    const double d = squared_norm(lerp(a, b, nearest_parameter(a, b, p)) - p);
    if (d < least) least = d, best.segment = i;
  }
  const auto found = SegmentSearch(segments).nearest(p);
  RC_ASSERT(found.segment == best.segment);
  RC_ASSERT(found.distance == std::sqrt(least));
}

}  // namespace
}  // namespace beadmesh
