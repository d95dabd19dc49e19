#include "beadmesh/mesh/washers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "beadmesh/mesh/element_quality.h"
#include "beadmesh/mesh/subdivision_mesher.h"
#include "mesh/sample_loops.h"

namespace beadmesh {
namespace {

std::vector<Vec2> hole(Vec2 centre, double radius, int n) {
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i)
    points.push_back(centre + Vec2{radius * std::cos(2 * pi * i / n), -radius * std::sin(2 * pi * i / n)});
  return points;
}

/// 100 x 60 with its lower left corner at (-50, -30), nodes 5 apart.
NodeLoops plate() {
  NodeLoops loops;
  std::vector<Vec2> box;
  for (int i = 0; i < 20; ++i) box.push_back({-50 + 5.0 * i, -30});
  for (int i = 0; i < 12; ++i) box.push_back({50, -30 + 5.0 * i});
  for (int i = 0; i < 20; ++i) box.push_back({50 - 5.0 * i, 30});
  for (int i = 0; i < 12; ++i) box.push_back({-50, 30 - 5.0 * i});
  test::add_loop(loops, box);
  return loops;
}

TEST(WasherWidth, IsTheSizeOrLessAroundSmallHoles) {
  EXPECT_EQ(washer_width({}, 20, 5, 2.5), 5);
  EXPECT_NEAR(washer_width({}, 8, 5, 2.5).value(), 4 / 0.86, 1e-9);
  EXPECT_FALSE(washer_width({}, 4, 5, 2.5)) << "quads would be too uneven";
  EXPECT_FALSE(washer_width({}, 51, 5, 2.5)) << "an opening";
  EXPECT_TRUE(washer_width({}, 99, 10, 4));
}

TEST(WasherWidth, FollowsTheUser) {
  WasherControl control;
  control.width = 8;
  control.min_diameter = 10;
  control.max_diameter = 70;
  EXPECT_EQ(washer_width(control, 60, 5, 2.5), 8);
  EXPECT_FALSE(washer_width(control, 9, 5, 2.5));
  EXPECT_FALSE(washer_width(control, 71, 5, 2.5));
  control.width = 2;
  EXPECT_FALSE(washer_width(control, 60, 5, 2.5)) << "below the minimum edge";
  control = {};
  control.rows = 0;
  EXPECT_FALSE(washer_width(control, 20, 5, 2.5));
}

TEST(WasherControl, SenselessValuesAreRefused) {
  EXPECT_TRUE(check_washers({}));
  for (const WasherControl bad : {WasherControl{-1, {}, {}, {}, {}}, WasherControl{1, 0.0, {}, {}, {}},
                                  WasherControl{1, {}, -1.0, {}, {}}, WasherControl{1, {}, {}, {}, 7},
                                  WasherControl{1, {}, {}, {}, 4}}) {
    const auto result = check_washers(bad);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, "control.washer");
  }
}

TEST(WasherRings, AreConcentric) {
  NodeLoops loops = plate();
  test::add_loop(loops, hole({4, -3}, 8, 12));
  const auto rings = washer_rings(loops, {{1, 2, 5}}, 5, 2.5);
  ASSERT_EQ(rings.size(), 1);
  ASSERT_EQ(rings[0].rings.size(), 2);
  double radius = 8;
  for (const auto& ring : rings[0].rings) {
    radius += 5 / std::cos(pi / 12);
    ASSERT_EQ(ring.size(), 12);
    for (const Vec2 p : ring) EXPECT_NEAR(distance(p, Vec2{4, -3}), radius, 1e-9);
  }
}

TEST(WasherRings, KeepAwayFromOtherLoopsAndFromEachOther) {
  NodeLoops loops = plate();
  test::add_loop(loops, hole({-24, 0}, 8, 12));
  test::add_loop(loops, hole({6, 0}, 8, 12));
  test::add_loop(loops, hole({38, 0}, 8, 12));  // 4 from the edge of the plate
  const auto rings = washer_rings(loops, {{1, 2, 5}, {2, 2, 5}, {3, 1, 5}}, 5, 2.5);
  ASSERT_EQ(rings.size(), 1);
  EXPECT_EQ(rings[0].loop, 1);
  // Between the holes are 14 mm: two rings and a gap at one of them, none at the other.
  EXPECT_EQ(rings[0].rings.size(), 2);
}

TEST(WasherRings, AnIslandNeedsMoreRoom) {
  for (const auto& [radius, count] : {std::pair{26.0, 0}, std::pair{32.0, 1}}) {
    NodeLoops loops;
    auto outer = hole({0, 0}, radius, 40);
    std::reverse(outer.begin(), outer.end());
    test::add_loop(loops, outer);
    test::add_loop(loops, hole({0, 0}, 14, 20));
    EXPECT_EQ(washer_rings(loops, {{1, 1, 5}}, 5, 2.5).size(), count) << radius;
  }
}

TEST(WithWashers, TheWholeIsAConformingMesh) {
  NodeLoops loops = plate();
  test::add_loop(loops, hole({-20, 3}, 6, 10));
  test::add_loop(loops, hole({25, -2}, 10, 14));
  const auto rings = washer_rings(loops, {{1, 1, 5}, {2, 2, 4}}, 5, 2.5);
  ASSERT_EQ(rings.size(), 2);
  const auto outside = mesh_by_subdivision(outside_of_washers(loops, rings), nullptr, {5, 2.5});
  ASSERT_TRUE(outside) << outside.error().message;
  const PlanarMesh mesh = with_washers(loops, rings, *outside);
  EXPECT_EQ(verify_planar_mesh(mesh, loops), std::vector<std::string>{});
  for (size_t n = 0; n < loops.nodes.size(); ++n) EXPECT_EQ(mesh.nodes[n], loops.nodes[n]);
  EXPECT_EQ(mesh.elements.size(), outside->elements.size() + 10 + 2 * 14);
}

}  // namespace
}  // namespace beadmesh
