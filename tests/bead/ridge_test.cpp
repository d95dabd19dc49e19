#include "beadmesh/bead/ridge.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "bead/studied_bead.h"
#include "beadmesh/bead/crest_offset.h"
#include "examples/skeletons.h"
#include "medial/shapes.h"

namespace beadmesh {
namespace {

using namespace shapes;

struct Drawn {
  PlanarRegion region;
  Skeleton skeleton;
  RidgeGraph ridge;
};

Drawn drawn(const PlanarRegion& drawn_region) {
  const PlanarRegion region = checked_region(drawn_region).value();
  Skeleton skeleton = skeleton_of(medial_of(region));
  RidgeGraph ridge = ridge_of(skeleton, region);
  return {region, std::move(skeleton), std::move(ridge)};
}

const RidgeNode& junction(const RidgeGraph& ridge) {
  return *std::max_element(
      ridge.nodes.begin(), ridge.nodes.end(),
      [](const RidgeNode& a, const RidgeNode& b) { return a.arms.size() < b.arms.size(); });
}

/// Largest distance of the ridge's points from the nearest of the rays from `centre` at these angles.
double off_rays(const RidgeGraph& ridge, Vec2 centre, const std::vector<double>& angles) {
  double worst = 0;
  for (const RidgeArm& arm : ridge.arms)
    for (const Vec2 p : arm.points) {
      double nearest = distance(p, centre);
      for (const double angle : angles) {
        const Vec2 d{std::cos(radians(angle)), std::sin(radians(angle))};
        if (dot(p - centre, d) > 0) nearest = std::min(nearest, std::abs(cross(d, p - centre)));
      }
      worst = std::max(worst, nearest);
    }
  return worst;
}

void expect_tips_on_boundary(const Drawn& shape, int tips) {
  int found = 0;
  for (const RidgeNode& node : shape.ridge.nodes) {
    EXPECT_EQ(node.tip, node.arms.size() == 1);
    if (!node.tip) continue;
    ++found;
    const auto& points = shape.region.loops[node.boundary.loop].points;
    double at = 0, nearest = 1e300;
    for (size_t i = 0; i < points.size(); ++i) {
      const Vec2 a = points[i], b = points[(i + 1) % points.size()];
      const double step = distance(a, b);
      if (node.boundary.position >= at && node.boundary.position <= at + step)
        nearest = distance(node.point, lerp(a, b, (node.boundary.position - at) / step));
      at += step;
    }
    EXPECT_LT(nearest, 1e-6) << "the tip lies where its boundary position says";
  }
  EXPECT_EQ(found, tips);
}

TEST(Ridge, OfAStadiumRunsFromTipToTip) {
  const Drawn shape = drawn(stadium(80, 8));
  ASSERT_EQ(shape.ridge.arms.size(), 1);
  expect_tips_on_boundary(shape, 2);
  auto ends = std::minmax(shape.ridge.arms[0].points.front().x, shape.ridge.arms[0].points.back().x);
  EXPECT_NEAR(ends.first, -8, 0.05);
  EXPECT_NEAR(ends.second, 88, 0.05);
  for (const Vec2 p : shape.ridge.arms[0].points) EXPECT_NEAR(p.y, 0, 1e-3);
}

TEST(Ridge, MedialAxisOfAFilletedTBendsAtTheJunction) {
  const Drawn shape = drawn(letter_t(16, 9));
  double bent = 0;
  for (const SkeletonArm& arm : shape.skeleton.arms)
    for (const MedialPoint& p : arm.points)
      bent = std::max(bent, std::min(std::abs(p.point.x), std::abs(p.point.y)));
  EXPECT_GT(bent, 0.5) << "what the squaring is for";
}

TEST(Ridge, TIsSquaredToStraightLines) {
  const Drawn shape = drawn(letter_t(16, 9, {1, 0.002}));
  const RidgeNode& node = junction(shape.ridge);
  ASSERT_EQ(node.arms.size(), 3);
  EXPECT_TRUE(node.squared);
  EXPECT_LT(norm(node.point), 0.01);
  EXPECT_GT(norm(node.medial_point), 0.1) << "the equidistant point is kept";
  EXPECT_LT(off_rays(shape.ridge, {0, 0}, {0, 180, 270}), 0.01);
  expect_tips_on_boundary(shape, 3);
}

TEST(Ridge, ObliqueTIsSquaredWhereItsLinesMeet) {
  const std::vector<double> angles{0, 180, 300};
  const Drawn shape = drawn(region_of(star_footprint(angles, 70, 14, 9)));
  EXPECT_LT(norm(junction(shape.ridge).point), 0.03);
  EXPECT_LT(off_rays(shape.ridge, {0, 0}, angles), 0.03);
}

TEST(Ridge, YIsStraightAndMeetsInTheMiddle) {
  const std::vector<double> angles{90, 210, 330};
  const Drawn shape = drawn(region_of(star_footprint(angles, 60, 14, 8)));
  EXPECT_EQ(junction(shape.ridge).arms.size(), 3);
  EXPECT_LT(norm(junction(shape.ridge).point), 1e-3);
  EXPECT_LT(off_rays(shape.ridge, {0, 0}, angles), 1e-3);
  expect_tips_on_boundary(shape, 3);
}

/// The bar ends so near to the stem that the fillet bends its axis up to the cap.
TEST(Ridge, StubIsTheArmOppositeCarriedOn) {
  const Footprint footprint =
      examples::network({{0, 0}, {-70, 0}, {18, 0}, {0, -60}}, {{0, 1}, {0, 2}, {0, 3}}, 16, 9);
  const Drawn shape = drawn(region_of(footprint));
  double bent = 0;
  for (const SkeletonArm& arm : shape.skeleton.arms)
    for (const MedialPoint& p : arm.points)
      bent = std::max(bent, std::min(std::abs(p.point.x - junction(shape.ridge).point.x),
                                     std::abs(p.point.y - junction(shape.ridge).point.y)));
  EXPECT_GT(bent, 0.3);
  EXPECT_LT(off_rays(shape.ridge, junction(shape.ridge).point, {0, 180, 270}), 0.06);
  expect_tips_on_boundary(shape, 3);
}

TEST(Ridge, XMeetsInOnePoint) {
  for (const double crossing : {90.0, 70.0}) {
    const Drawn shape = drawn(letter_x(14, radians(crossing), 8));
    EXPECT_EQ(junction(shape.ridge).arms.size(), 4);
    EXPECT_LT(norm(junction(shape.ridge).point), 0.04) << crossing;
    EXPECT_LT(off_rays(shape.ridge, {0, 0}, {0, crossing, 180, 180 + crossing}), 0.04) << crossing;
    expect_tips_on_boundary(shape, 4);
  }
}

TEST(Ridge, ArmsMeetTheirNodes) {
  for (const Footprint& footprint :
       {t_footprint(), examples::h_bead(90, 60, 13, 8), examples::comb_bead(3, 34, 46, 12, 8)}) {
    const Drawn shape = drawn(region_of(footprint));
    ASSERT_EQ(shape.ridge.arms.size(), shape.skeleton.arms.size());
    for (const RidgeArm& arm : shape.ridge.arms) {
      EXPECT_EQ(arm.points.front(), shape.ridge.nodes[arm.start].point);
      EXPECT_EQ(arm.points.back(), shape.ridge.nodes[arm.end].point);
      for (size_t i = 1; i < arm.points.size(); ++i)
        EXPECT_GT(distance(arm.points[i - 1], arm.points[i]), 1e-9);
    }
  }
}

TEST(Ridge, RingHasOneClosedArm) {
  const Drawn shape = drawn(annulus(40, 26));
  ASSERT_EQ(shape.ridge.arms.size(), 1);
  EXPECT_EQ(shape.ridge.arms[0].start, no_index);
  for (const Vec2 p : shape.ridge.arms[0].points) EXPECT_NEAR(norm(p), 33, 0.02);
}

TEST(Ridge, StraightMeansStraightInSpace) {
  // Laid flat, the walls widen the bar and the stem and bend the crest lines at the junction: on the surface
  // they are straight.
  const StudiedBead bead = studied_bead(t_footprint(), 6, flat_base, {}, 1.3);
  const RidgeGraph ridge =
      ridge_of(moved_to_crest(bead.skeleton(), bead.map()), bead.study->region, &bead.map());
  const Vec3 centre = bead.study->lift(junction(ridge).point);
  EXPECT_LT(std::hypot(centre.x, centre.y), 0.05);
  for (const RidgeArm& arm : ridge.arms)
    for (const Vec2 p : arm.points) {
      const Vec3 q = bead.study->lift(p);
      EXPECT_LT(std::min(std::abs(q.x), std::abs(q.y)), 0.08) << q.x << " " << q.y;
    }
}

}  // namespace
}  // namespace beadmesh
