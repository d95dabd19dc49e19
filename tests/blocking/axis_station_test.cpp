#include "beadmesh/blocking/axis_station.h"

#include <gtest/gtest.h>

#include "bead/studied_bead.h"
#include "beadmesh/blocking/block_layout.h"
#include "medial/shapes.h"

namespace beadmesh {
namespace {

using namespace shapes;

TEST(AxisStation, DifferenceOnALoopIsTheShortWayRound) {
  EXPECT_NEAR(loop_difference(10, 30, 100), 20, 1e-12);
  EXPECT_NEAR(loop_difference(95, 5, 100), 10, 1e-12);
  EXPECT_NEAR(loop_difference(5, 95, 100), -10, 1e-12);
}

TEST(AxisStation, OfAStadiumHasItsFeetAcross) {
  const PlanarRegion region = stadium(80, 8);
  const Skeleton skeleton = skeleton_of(medial_of(region));
  const auto lengths = loop_lengths_of(region);
  ASSERT_EQ(lengths.size(), 1);
  EXPECT_NEAR(lengths[0], 160 + 16 * pi, 0.2);
  const BlockLayoutBuilder boundary(region);
  const SkeletonArm& arm = skeleton.arms[0];
  const bool ahead = arm.points.front().point.x < 40;
  for (double along = 2; along < 80; along += 7.3) {
    const AxisStation station = station_at(arm, along, lengths);
    const double x = ahead ? along : 80 - along;
    EXPECT_NEAR(station.centre.x, x, 0.1);
    EXPECT_NEAR(station.radius, 8, 0.01);
    EXPECT_LT(distance(boundary.point_at(station.left), {station.centre.x, ahead ? 8.0 : -8.0}), 0.1);
    EXPECT_LT(distance(boundary.point_at(station.right), {station.centre.x, ahead ? -8.0 : 8.0}), 0.1);
  }
}

TEST(AxisStation, IsClampedToAnOpenArmAndGoesRoundAClosedOne) {
  const Skeleton open = skeleton_of(medial_of(stadium(80, 8)));
  const std::vector<double> lengths{200};
  EXPECT_EQ(station_at(open.arms[0], -5, lengths).centre, open.arms[0].points.front().point);
  EXPECT_EQ(station_at(open.arms[0], 500, lengths).centre, open.arms[0].points.back().point);

  const PlanarRegion ring = checked_region(annulus(40, 26)).value();
  const Skeleton closed = skeleton_of(medial_of(ring));
  const auto loops = loop_lengths_of(ring);
  const double length = length_of(closed.arms[0]);
  const AxisStation a = station_at(closed.arms[0], 0.3 * length, loops);
  const AxisStation b = station_at(closed.arms[0], -0.7 * length, loops);
  EXPECT_LT(distance(a.centre, b.centre), 1e-9);
  EXPECT_NE(a.left.loop, a.right.loop);
  for (double t = 0; t < 1; t += 0.01)
    EXPECT_NEAR(norm(station_at(closed.arms[0], t * length, loops).centre), 33, 0.05)
        << "also on the closing piece";
}

TEST(AxisStation, DistancesGrowAlongTheArm) {
  const Skeleton skeleton = skeleton_of(medial_of(stadium(80, 8)));
  const auto at = distances_along(skeleton.arms[0]);
  ASSERT_EQ(at.size(), skeleton.arms[0].points.size());
  EXPECT_EQ(at.front(), 0);
  EXPECT_NEAR(at.back(), length_of(skeleton.arms[0]), 1e-9);
}

}  // namespace
}  // namespace beadmesh
