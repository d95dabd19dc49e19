#include "beadmesh/bead/skeleton.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "bead/studied_bead.h"
#include "examples/skeletons.h"
#include "medial/shapes.h"

namespace beadmesh {
namespace {

using namespace shapes;

Skeleton skeleton_of_footprint(const Footprint& footprint) {
  return skeleton_of(medial_of(region_of(footprint)));
}

int nodes_of_degree(const Skeleton& skeleton, size_t degree) {
  return static_cast<int>(std::count_if(skeleton.nodes.begin(), skeleton.nodes.end(),
                                        [&](const SkeletonNode& n) { return n.arms.size() == degree; }));
}

/// What holds for every skeleton: arms begin and end at their nodes, which know them; feet lie on the right
/// sides.
void expect_sound(const Skeleton& skeleton) {
  for (Index a = 0; a < Index(skeleton.arms.size()); ++a) {
    const SkeletonArm& arm = skeleton.arms[a];
    for (const Index n : {arm.start, arm.end}) {
      if (n == no_index) continue;
      const auto& around = skeleton.nodes[n].arms;
      EXPECT_EQ(std::count(around.begin(), around.end(), a), arm.start == arm.end ? 2 : 1);
    }
    for (size_t i = 1; i < arm.points.size(); ++i) {
      const Vec2 step = arm.points[i].point - arm.points[i - 1].point;
      EXPECT_GT(norm(step), 0) << "arm " << a << " repeats point " << i;
      if (arm.points[i].subtended_angle < radians(150)) continue;
      EXPECT_GT(cross(step, arm.points[i].feet[0].point - arm.points[i].point), 0) << "left foot";
      EXPECT_LT(cross(step, arm.points[i].feet[1].point - arm.points[i].point), 0) << "right foot";
    }
  }
}

TEST(Skeleton, OfAStadiumIsItsMiddleLine) {
  const Skeleton skeleton = skeleton_of(medial_of(stadium(80, 8)));
  ASSERT_EQ(skeleton.arms.size(), 1);
  EXPECT_EQ(nodes_of_degree(skeleton, 1), 2);
  EXPECT_NEAR(length_of(skeleton.arms[0]), 80, 0.1);
  expect_sound(skeleton);
}

TEST(Skeleton, SpurOfARoundedOuterCornerIsNoArm) {
  // The outer corner is rounded by less than a concentric bend: its centre hangs on the axis as a short leaf.
  const PlanarRegion region = letter_l(14, 6, 7);
  const MedialObject medial = medial_of(region);
  ASSERT_EQ(medial.edges.size(), 3) << "the medial object has the spur";
  const Skeleton skeleton = skeleton_of(medial);
  ASSERT_EQ(skeleton.arms.size(), 1);
  EXPECT_EQ(skeleton.nodes.size(), 2) << "the node of degree 2 is dissolved";
  double without_spur = -1e300;
  for (const MedialEdge& edge : medial.edges) without_spur = std::max(without_spur, edge.length);
  EXPECT_GT(length_of(skeleton.arms[0]), without_spur + 50) << "both legs";
  expect_sound(skeleton);
}

TEST(Skeleton, LimitOfSpursIsAnOption) {
  const MedialObject medial = medial_of(letter_l(14, 6, 7));
  SkeletonOptions options;
  options.spur_length = 0;
  EXPECT_EQ(skeleton_of(medial, options).arms.size(), 3);
}

TEST(Skeleton, StemOfATIsNoSpur) {
  const Skeleton skeleton = skeleton_of_footprint(t_footprint());
  EXPECT_EQ(skeleton.arms.size(), 3);
  EXPECT_EQ(nodes_of_degree(skeleton, 3), 1);
  EXPECT_EQ(nodes_of_degree(skeleton, 1), 3);
  expect_sound(skeleton);
}

TEST(Skeleton, TwoNearTsOnOppositeSidesAreOneX) {
  // Stems up and down on a bar 14 mm wide.
  const auto pair = [](double apart) {
    return examples::network(
        {{-60, 0}, {-apart / 2, 0}, {apart / 2, 0}, {60, 0}, {-apart / 2, 50}, {apart / 2, -50}},
        {{0, 1}, {1, 2}, {2, 3}, {1, 4}, {2, 5}}, 14, 5);
  };
  const Skeleton near = skeleton_of_footprint(pair(10));
  EXPECT_EQ(near.arms.size(), 4);
  EXPECT_EQ(nodes_of_degree(near, 4), 1);
  expect_sound(near);
  const Skeleton far = skeleton_of_footprint(pair(40));
  EXPECT_EQ(far.arms.size(), 5);
  EXPECT_EQ(nodes_of_degree(far, 3), 2);
}

TEST(Skeleton, MergedJunctionLiesBetweenTheTwo) {
  const MedialObject medial = medial_of(letter_x(14, radians(70), 8));
  const Skeleton skeleton = skeleton_of(medial);
  ASSERT_EQ(nodes_of_degree(skeleton, 4), 1);
  for (const SkeletonNode& node : skeleton.nodes)
    if (node.arms.size() == 4) {
      EXPECT_LT(norm(node.point), 0.1);
    }
}

TEST(Skeleton, NeighbouringTeethStayApart) {
  const Skeleton skeleton = skeleton_of_footprint(examples::comb_bead(3, 26, 46, 12, 5));
  EXPECT_EQ(nodes_of_degree(skeleton, 3), 3);
  EXPECT_EQ(skeleton.arms.size(), 7);
  expect_sound(skeleton);
}

TEST(Skeleton, RingIsAClosedArmWithoutNodes) {
  const Skeleton skeleton = skeleton_of(medial_of(annulus(40, 26)));
  ASSERT_EQ(skeleton.arms.size(), 1);
  EXPECT_TRUE(skeleton.nodes.empty());
  EXPECT_EQ(skeleton.arms[0].start, no_index);
  EXPECT_NEAR(length_of(skeleton.arms[0]), 2 * pi * 33, 0.3) << "with the closing piece";
}

TEST(Skeleton, ArmsStandCounterClockwiseAboutTheirNode) {
  for (const Footprint& footprint :
       {t_footprint(), star_footprint({10, 130, 250}, 60, 14, 8),
        star_footprint({0, 90, 180, 270}, 60, 14, 8), examples::h_bead(90, 60, 13, 8)})
    for (const bool mirrored : {false, true}) {
      const Skeleton skeleton = skeleton_of_footprint(placed(footprint, {}, 0.4, mirrored));
      expect_sound(skeleton);
      for (Index n = 0; n < Index(skeleton.nodes.size()); ++n) {
        const auto& arms = skeleton.nodes[n].arms;
        double turn = 0;
        for (size_t k = 0; k < arms.size(); ++k) {
          const auto outward = [&](Index a) {
            return direction_at(skeleton.arms[a], skeleton.arms[a].end == n, 20);
          };
          const Vec2 u = outward(arms[k]), v = outward(arms[(k + 1) % arms.size()]);
          const double step = std::atan2(cross(u, v), dot(u, v));
          turn += step <= 0 ? step + 2 * pi : step;
        }
        if (arms.size() > 1) {
          EXPECT_NEAR(turn, 2 * pi, 1e-6);
        }
      }
    }
}

TEST(Skeleton, DirectionLooksAlongTheArmFromEitherEnd) {
  const Skeleton skeleton = skeleton_of(medial_of(stadium(80, 8)));
  const SkeletonArm& arm = skeleton.arms[0];
  const double sign = arm.points.front().point.x < arm.points.back().point.x ? 1 : -1;
  for (const double reach : {1.0, 10.0, 500.0}) {
    EXPECT_NEAR(direction_at(arm, false, reach).x, sign, 1e-3);
    EXPECT_NEAR(direction_at(arm, true, reach).x, -sign, 1e-3);
  }
  EXPECT_EQ(direction_at(SkeletonArm{}, false, 1), Vec2{});
}

TEST(Skeleton, OfADiscIsEmpty) {
  const Skeleton skeleton = skeleton_of(medial_of(region_of({circle({0, 0}, 20, {})}, true)));
  EXPECT_TRUE(skeleton.arms.empty());
}

}  // namespace
}  // namespace beadmesh
