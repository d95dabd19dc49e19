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

TEST(CrestTip, ArmShorterThanItsCapSaysNothing) {
  const StudiedBead bead = leaning_bead();
  auto arm = arm_of(bead);
  arm.resize(3);
  EXPECT_FALSE(crest_tip(arm, 10, bead.study->region, bead.map()));
  EXPECT_FALSE(crest_tip(arm_of(bead), 0, bead.study->region, bead.map()));
}

}  // namespace
}  // namespace beadmesh
