#include "beadmesh/bead/plan_frame.h"

#include <gtest/gtest.h>

#include "bead/studied_bead.h"
#include "examples/skeletons.h"

namespace beadmesh {
namespace {

using namespace shapes;

TEST(PlanFrame, WithoutAMapThePlaneIsThePlan) {
  const PlanFrame frame(nullptr, {1, 2}, {0, 0, 1});
  EXPECT_EQ(frame.to_plan({3, 4}), (Vec2{3, 4}));
  EXPECT_EQ(frame.to_flat({3, 4}, {0, 0}), (Vec2{3, 4}));
}

TEST(PlanFrame, MeasuresAsSeenFromAbove) {
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 16), 5);
  const PlanFrame frame(&bead.map(), {0, 0}, {0, 0, 1});
  const Vec2 a{0, 6}, b{20, -5};
  const Vec3 p = bead.study->lift(a), q = bead.study->lift(b);
  EXPECT_NEAR(distance(frame.to_plan(a), frame.to_plan(b)), std::hypot(p.x - q.x, p.y - q.y), 1e-9);
  EXPECT_LT(norm(frame.to_plan({0, 0})), 1e-9) << "its origin";
}

TEST(PlanFrame, FindsTheWayBack) {
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 16), 5, cylinder_base(300));
  const PlanFrame frame(&bead.map(), {0, 0}, {0, 0, 1});
  for (const Vec2 flat : {Vec2{5, 3}, Vec2{-20, 6}, Vec2{30, -7}}) {
    const Vec2 plan = frame.to_plan(flat);
    EXPECT_LT(distance(frame.to_plan(frame.to_flat(plan, {0, 0})), plan), 0.02);
  }
}

TEST(PlanFrame, StaysPutOnAWallSeenEdgeOn) {
  // Seen along x the bead's crest is a point: no way back, but no flight either.
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 16), 5);
  const PlanFrame frame(&bead.map(), {0, 0}, {1, 0, 0});
  const Vec2 guess{3, 0};
  EXPECT_LT(distance(frame.to_flat({40, 2}, guess), guess), 100);
}

}  // namespace
}  // namespace beadmesh
