#include "beadmesh/medial/axis_refinement.h"

#include <gtest/gtest.h>

#include "beadmesh/medial/axis_polish.h"
#include "medial/exact_region.h"
#include "medial/shapes.h"

namespace beadmesh {
namespace {

/// A point between the floor and the reflex corner (20, 20): on the parabola with that focus.
AxisPoint on_parabola(const BoundaryCurve& curve, double x) {
  AxisPoint point{{{x, 11}, 10}, {BoundaryPlace{0, 2, 1}, BoundaryPlace{0, 0, x / 80}}, {}};
  EXPECT_TRUE(polish(curve, point));
  return point;
}

const std::vector<Vec2> l_shape{{0, 0}, {80, 0}, {80, 20}, {20, 20}, {20, 70}, {0, 70}};

TEST(AxisRefiner, FollowsAParabola) {
  const BoundaryCurve curve(shapes::region_of({l_shape}), radians(160));
  const AxisPoint start = on_parabola(curve, 12), end = on_parabola(curve, 19.9);
  PlacedEdge points{on_parabola(curve, 16)};
  AxisRefiner(curve, 1e-5).refine_open(points, start, false, end, false);
  EXPECT_GT(points.size(), 30u);
  Vec2 last = start.circle.centre;
  for (const AxisPoint& point : points) {
    const Vec2 at = point.circle.centre, middle = lerp(last, at, 0.5);
    EXPECT_NEAR(at.y, distance(at, {20, 20}), 1e-11);
    EXPECT_LT(std::abs(middle.y - distance(middle, {20, 20})), 4e-5);
    EXPECT_GT(at.x, last.x);
    last = at;
  }
}

TEST(AxisRefiner, LeavesAStraightAxisAlone) {
  const BoundaryCurve curve(shapes::rectangle(100, 20), radians(160));
  const auto on_axis = [](double x) {
    return AxisPoint{
        {{x, 10}, 10}, {BoundaryPlace{0, 2, 1 - x / 100}, BoundaryPlace{0, 0, x / 100}}, {0, 20}};
  };
  PlacedEdge points{on_axis(40), on_axis(60)};
  AxisRefiner(curve, 1e-9).refine_open(points, on_axis(20), false, on_axis(80), false);
  EXPECT_EQ(points.size(), 2u);
}

TEST(AxisRefiner, GoesAroundAClosedEdge) {
  const BoundaryCurve curve(exact_shapes::annulus(50, 30, {}), radians(160));
  PlacedEdge points;
  for (int i = 0; i < 12; ++i) {
    const Vec2 at = Vec2{std::cos(-i * pi / 6), std::sin(-i * pi / 6)} * 40;
    const Contact outer = curve.nearest(at, SegmentRun{0, 0, curve.segments(0)});
    const Contact inner = curve.nearest(at, SegmentRun{1, 0, curve.segments(1)});
    points.push_back({{at, 10}, {outer.place, inner.place}, outer.point - inner.point});
  }
  AxisRefiner(curve, 1e-4).refine_closed(points);
  EXPECT_GT(points.size(), 500u);
  for (const AxisPoint& point : points) EXPECT_NEAR(norm(point.circle.centre), 40, 1e-11);
}

}  // namespace
}  // namespace beadmesh
