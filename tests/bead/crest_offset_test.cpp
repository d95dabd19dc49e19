#include "beadmesh/bead/crest_offset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

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

/// Rise over the base at a distance from the foot, on one side of a bead with steep walls and a flat top:
/// wall and top are rounded by tangents of the length that a ball of one radius has between them in space.
class RoundedWall {
 public:
  RoundedWall(double wall, double slope, double radius) {
    const double steep = std::atan(wall + slope), top = std::atan(slope);
    const double tangent = radius * std::tan((steep - top) / 2), foot = height / wall;
    const Vec2 corner{foot, height}, before = corner - Vec2{1, wall} * (tangent * std::cos(steep)),
                                     after = corner + Vec2{tangent * std::cos(top), 0};
    line_.push_back({0, 0});
    for (int i = 0; i <= 20; ++i) {
      const double t = i / 20.0;
      line_.push_back(lerp(lerp(before, corner, t), lerp(corner, after, t), t));
    }
    line_.push_back({1e3, height});
  }

  double operator()(double distance) const {
    size_t i = 1;
    while (line_[i].x < distance) ++i;
    const double t = (distance - line_[i - 1].x) / (line_[i].x - line_[i - 1].x);
    return lerp(line_[i - 1], line_[i], std::clamp(t, 0.0, 1.0)).y;
  }

 private:
  std::vector<Vec2> line_;
};

TEST(CrestOffset, FlatTopsOnSlopesAreCrestedBetweenTheirWalls) {
  const double slope = 0.36;
  const Base base = [=](Vec2 p) { return slope * p.y; };
  const Footprint footprint = examples::straight_bead(84, 16);
  const examples::BoundaryDistance inside(footprint.loops);
  const RoundedWall lower(5, slope, 1.5), upper(5, -slope, 1.5);
  PlanPanel plan(base, 0.8);
  plan.add_face(plan.add_loop(points_of(footprint.loops[0], 1)), {}, [&](Vec2 p) {
    const double d = std::max(0.0, inside(p));
    return Vec3{p.x, p.y, base(p) + (p.y < 0 ? lower(d) : upper(d))};
  });
  const StudiedBead bead = studied_face(plan.take(), 0);
  EXPECT_LT(off_crest(bead, moved_to_crest(bead.skeleton(), bead.map()), 0), 0.1);
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
