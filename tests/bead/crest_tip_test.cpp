#include "beadmesh/bead/crest_tip.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "bead/studied_bead.h"
#include "beadmesh/bead/crest_offset.h"
#include "beadmesh/bead/ridge.h"
#include "examples/skeletons.h"

namespace beadmesh {
namespace {

using namespace shapes;

/// Drawn along +z on a sheet that rises across the bead.
double slope(Vec2 p) {
  return 0.4 * p.x;
}

StudiedBead leaning_bead() {
  return studied_bead(placed(examples::straight_bead(100, 20), {}, radians(90)), 5, slope, {}, 1);
}

std::vector<MedialPoint> arm_of(const StudiedBead& bead) {
  return moved_to_crest(bead.skeleton(), bead.map()).arms.at(0).points;
}

TEST(CrestTip, OfALeaningBeadLiesWhereItsFootprintEnds) {
  const StudiedBead bead = leaning_bead();
  const auto tip = crest_tip(arm_of(bead), 10, bead.study->region, bead.map());
  ASSERT_TRUE(tip);
  const Vec3 at = bead.study->lift(tip->point);
  EXPECT_NEAR(at.x, 0, 0.15);
  EXPECT_NEAR(std::abs(at.y), 60, 0.1);
  EXPECT_FALSE(tip->crest.empty());
  for (const Vec2 p : tip->crest) EXPECT_NEAR(bead.study->lift(p).x, 0, 0.2);
}

TEST(CrestTip, MedialAxisOfALeaningBeadBends) {
  const StudiedBead bead = leaning_bead();
  double aside = 0;
  for (const MedialPoint& p : arm_of(bead)) aside = std::max(aside, std::abs(bead.study->lift(p.point).x));
  EXPECT_GT(aside, 0.5) << "what the tip is looked for in space for";
}

TEST(CrestTip, RidgeOfALeaningBeadIsStraightInPlan) {
  const StudiedBead bead = leaning_bead();
  const RidgeGraph ridge =
      ridge_of(moved_to_crest(bead.skeleton(), bead.map()), bead.study->region, &bead.map());
  ASSERT_EQ(ridge.arms.size(), 1);
  for (const Vec2 p : ridge.arms[0].points) EXPECT_NEAR(bead.study->lift(p).x, 0, 0.25);
  for (const RidgeNode& node : ridge.nodes) EXPECT_TRUE(node.tip);
}

TEST(CrestTip, FollowsAGentleArc) {
  const StudiedBead bead = studied_bead(examples::arc_bead(120, 50, 16), 5);
  const auto tip = crest_tip(arm_of(bead), 8, bead.study->region, bead.map());
  ASSERT_TRUE(tip) << arm_of(bead).size();
  // The footprint's cap is a half circle about the end of the centre line.
  const Vec3 end = bead.study->lift(arm_of(bead).front().point), at = bead.study->lift(tip->point);
  EXPECT_NEAR(std::hypot(at.x - end.x, at.y - end.y), 8, 0.3);
}

/// Flat on top, with upright walls between fillets of the given radius.
StudiedBead walled_bead(double width, double height, double fillet, const Base& base) {
  const Footprint footprint = placed(examples::straight_bead(60, width), {}, radians(90));
  PlanPanel plan(base, 1);
  const int loop = plan.add_loop(points_of(footprint.loops[0], 0.5));
  const examples::BoundaryDistance inside(footprint.loops);
  // A strip of the plan along the boundary is bent up: a third of it each for root, wall and shoulder.
  const double third = 2 * fillet / 3;
  const auto profile = [=](double d) {
    if (d >= 3 * third) return Vec2{d, height};
    if (d >= 2 * third) {
      const double angle = (d - 2 * third) / third * pi / 2;
      return Vec2{fillet * (2 - std::cos(angle)), height - fillet * (1 - std::sin(angle))};
    }
    if (d >= third) return Vec2{fillet, fillet + (d - third) / third * (height - 2 * fillet)};
    const double angle = d / third * pi / 2;
    return Vec2{fillet * std::sin(angle), fillet * (1 - std::cos(angle))};
  };
  plan.add_face(
      loop, {},
      [=](Vec2 p) {
        constexpr double h = 1e-3;
        const Vec2 inwards{inside(p + Vec2{h, 0}) - inside(p - Vec2{h, 0}),
                           inside(p + Vec2{0, h}) - inside(p - Vec2{0, h})};
        const double d = std::max(0.0, inside(p));
        const Vec2 bent = profile(d), at = p + normalized(inwards) * (bent.x - d);
        return Vec3{at.x, at.y, base(at) + bent.y};
      },
      0.4);
  return studied_face(plan.take(), 0);
}

/// On walls nearly upright a place in plan says little: the crest must not run past the tip and back.
TEST(CrestTip, OnASteepWallTheCrestOnlyComesNearerToTheTip) {
  for (const double height : {3.0, 4.0, 6.0}) {
    const StudiedBead bead = walled_bead(8, height, 0.4, [](Vec2 p) { return 0.25 * p.x + 0.12 * p.y; });
    std::vector<MedialPoint> arm = arm_of(bead);
    for (int end = 0; end < 2; ++end, std::reverse(arm.begin(), arm.end())) {
      SCOPED_TRACE(std::to_string(height) + " high, end " + std::to_string(end));
      const auto tip = crest_tip(arm, arm.front().radius, bead.study->region, bead.map());
      ASSERT_TRUE(tip);
      double left = distance(arm[tip->kept].point, tip->point);
      for (const Vec2 p : tip->crest) {
        EXPECT_LT(distance(p, tip->point), left);
        left = distance(p, tip->point);
      }
    }
  }
}

TEST(CrestTip, ArmShorterThanItsCapSaysNothing) {
  const StudiedBead bead = leaning_bead();
  auto arm = arm_of(bead);
  arm.resize(3);
  EXPECT_FALSE(crest_tip(arm, 10, bead.study->region, bead.map()));
  EXPECT_FALSE(crest_tip(arm_of(bead), 0, bead.study->region, bead.map()));
}

}  // namespace
}  // namespace beadmesh
