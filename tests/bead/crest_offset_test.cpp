#include "beadmesh/bead/crest_offset.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "bead/studied_bead.h"
#include "examples/skeletons.h"

namespace beadmesh {
namespace {

using namespace shapes;

constexpr double height = 5;

/// Largest distance in plan between the middle part of a straight bead's crest line and where it is highest.
double off_crest(const StudiedBead& bead, const Skeleton& skeleton, double true_y) {
  double worst = 0;
  for (const SkeletonArm& arm : skeleton.arms)
    for (const MedialPoint& p : arm.points) {
      const Vec3 q = bead.study->lift(p.point);
      if (std::abs(q.x) < 35) worst = std::max(worst, std::abs(q.y - true_y));
    }
  return worst;
}

TEST(CrestOffset, OfAnUprightBeadIsNone) {
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 16), height, flat_base, {}, 1.3);
  const Skeleton moved = moved_to_crest(bead.skeleton(), bead.map());
  EXPECT_LT(off_crest(bead, moved, 0), 0.05);
}

TEST(CrestOffset, LeaningBeadsCrestIsNotTheMiddleOfTheFlatFace) {
  for (const double lean : {0.15, -0.15}) {
    const StudiedBead bead = studied_bead(examples::straight_bead(84, 16), height, flat_base, {0, lean}, 1.3);
    const Skeleton axis = bead.skeleton(), moved = moved_to_crest(axis, bead.map());
    EXPECT_GT(off_crest(bead, axis, lean * height), 0.2) << "the medial axis";
    EXPECT_LT(off_crest(bead, moved, lean * height), 0.1) << "the crest";
  }
}

TEST(CrestOffset, SunkBeadsAreTheSame) {
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 16), -height, flat_base, {0, 0.15}, 1.3);
  EXPECT_LT(off_crest(bead, moved_to_crest(bead.skeleton(), bead.map()), -0.15 * height), 0.1);
}

TEST(CrestOffset, FlatFaceKeepsItsMedialAxis) {
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 16), 0);
  const Skeleton axis = bead.skeleton(), moved = moved_to_crest(axis, bead.map());
  for (size_t i = 0; i < axis.arms[0].points.size(); ++i)
    EXPECT_LT(distance(axis.arms[0].points[i].point, moved.arms[0].points[i].point), 1e-9);
}

TEST(CrestOffset, KeepsRadiiFeetAndStructure) {
  const StudiedBead bead = studied_bead(t_footprint(), height, flat_base, {0.1, 0.15});
  const Skeleton axis = bead.skeleton(), moved = moved_to_crest(axis, bead.map());
  ASSERT_EQ(moved.arms.size(), axis.arms.size());
  for (size_t a = 0; a < axis.arms.size(); ++a) {
    ASSERT_EQ(moved.arms[a].points.size(), axis.arms[a].points.size());
    EXPECT_EQ(moved.arms[a].points.front().point, moved.nodes[moved.arms[a].start].point);
    EXPECT_EQ(moved.arms[a].points.back().point, moved.nodes[moved.arms[a].end].point);
    for (size_t i = 0; i < axis.arms[a].points.size(); ++i) {
      EXPECT_EQ(moved.arms[a].points[i].radius, axis.arms[a].points[i].radius);
      EXPECT_EQ(moved.arms[a].points[i].feet[0].point, axis.arms[a].points[i].feet[0].point);
    }
  }
}

TEST(CrestOffset, RingStaysClosedOnItsCrest) {
  const StudiedBead bead = studied_bead(examples::circular_ring(44, 14), height, flat_base, {}, 1.5);
  const Skeleton moved = moved_to_crest(bead.skeleton(), bead.map());
  ASSERT_EQ(moved.arms.size(), 1);
  for (const MedialPoint& p : moved.arms[0].points) {
    const Vec3 q = bead.study->lift(p.point);
    EXPECT_NEAR(std::hypot(q.x, q.y), 37, 0.05);
  }
}

}  // namespace
}  // namespace beadmesh
