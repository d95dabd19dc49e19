#include "beadmesh/bead/design_check.h"

#include <gtest/gtest.h>

#include <cmath>

#include "bead/studied_bead.h"
#include "examples/footprint.h"

using namespace beadmesh;
using namespace beadmesh::shapes;

namespace {

/// Steepest slope of the sin^2 profile: height * pi / (2 half width), at half height.
double steepest(double height, double half_width) {
  return std::atan(height * pi / (2 * half_width));
}

/// Both radii of the sin^2 profile at crown and root: curvature is height / 2 * (pi / half width)^2.
double radius_of(double height, double half_width) {
  return 2 * half_width * half_width / (pi * pi * height);
}

SectionMeasures measured(const Footprint& footprint, double height, const Base& base = flat_base) {
  const StudiedBead bead = studied_bead(footprint, height, base, {}, 1);
  return measure_sections(*bead.study, bead.medial);
}

/// Lines and arcs of a trapezoid with rounded corners over the distance from the root: wall angle, radii and
/// depth are what was drawn.
struct Trapezoid {
  double depth, angle, root, crown;

  double height(double s) const {
    const double tangent = std::tan(angle / 2), rise = std::tan(angle);
    const double root_end = root * std::sin(angle);
    const double wall_end = root * tangent + depth / rise - crown * tangent * std::cos(angle);
    if (s <= root_end) return root - std::sqrt(root * root - s * s);
    if (s <= wall_end) return (s - root * tangent) * rise;
    const double centre = root * tangent + depth / rise + crown * tangent;
    if (s >= centre) return depth;
    return depth - crown + std::sqrt(crown * crown - (centre - s) * (centre - s));
  }
};

SectionMeasures measured(const Footprint& footprint, const Trapezoid& profile, double sign = 1) {
  PlanPanel plan(flat_base, 0.7);
  const auto inside = std::make_shared<examples::BoundaryDistance>(footprint.loops);
  const int loop = plan.add_loop(points_of(footprint.loops.front(), 0.7));
  plan.add_face(loop, {}, [=](Vec2 p) {
    return Vec3{p.x, p.y, sign * profile.height(std::max(0.0, (*inside)(p)))};
  });
  const StudiedBead bead = studied_face(plan.take(), 0);
  return measure_sections(*bead.study, bead.medial);
}

}  // namespace

TEST(DesignCheck, MeasuresARoundCrest) {
  for (const double height : {3.0, 6.0}) {
    const auto m = measured(examples::strip({{80, 0, 0}}, 16), height);
    SCOPED_TRACE(height);
    EXPECT_GT(m.sections, 5);
    EXPECT_NEAR(height, m.depth, 0.01 * height);
    EXPECT_NEAR(height / 16, m.depth_to_width, 0.01 * height / 16);
    EXPECT_NEAR(degrees(steepest(height, 8)), degrees(m.wall_angle), 0.5);
    ASSERT_TRUE(m.crown_radius && m.root_radius);
    EXPECT_NEAR(radius_of(height, 8), *m.crown_radius, 0.05 * radius_of(height, 8));
    EXPECT_NEAR(radius_of(height, 8), *m.root_radius, 0.05 * radius_of(height, 8));
  }
}

TEST(DesignCheck, MeasuresWallsAndFillets) {
  for (const Trapezoid drawn : {Trapezoid{5, radians(45), 4, 3}, Trapezoid{6, radians(60), 3, 4}})
    for (const double sign : {1.0, -1.0}) {
      SCOPED_TRACE(testing::Message() << degrees(drawn.angle) << " " << sign);
      const auto m = measured(examples::strip({{90, 0, 0}}, 26), drawn, sign);
      EXPECT_NEAR(drawn.depth, m.depth, 0.02);
      EXPECT_NEAR(degrees(drawn.angle), degrees(m.wall_angle), 1);
      ASSERT_TRUE(m.crown_radius && m.root_radius);
      EXPECT_NEAR(drawn.crown, *m.crown_radius, 0.1 * drawn.crown);
      EXPECT_NEAR(drawn.root, *m.root_radius, 0.1 * drawn.root);
    }
}

TEST(DesignCheck, ARootWithoutFilletIsSharp) {
  const auto m = measured(examples::strip({{90, 0, 0}}, 26), Trapezoid{5, radians(45), 1e-9, 3});
  ASSERT_TRUE(m.root_radius);
  EXPECT_EQ(0, *m.root_radius);
  EXPECT_NEAR(3, m.crown_radius.value_or(0), 0.3);
}

TEST(DesignCheck, JunctionsAndCurvedSheetsDoNotDisturb) {
  const double height = 5, half = 8;
  for (const Base& base : {Base(flat_base), cylinder_base(500)}) {
    const auto t = measured(t_footprint(), height, base);
    EXPECT_GT(t.sections, 10);
    EXPECT_NEAR(height / 16, t.depth_to_width, 0.03 * height / 16);
    EXPECT_NEAR(degrees(steepest(height, half)), degrees(t.wall_angle), 2.5);
    EXPECT_NEAR(radius_of(height, half), t.crown_radius.value_or(0), 0.1 * radius_of(height, half));
  }
}

TEST(DesignCheck, DistancesOnAPlate) {
  PlanPanel plan;
  const auto moved = [](const Footprint& footprint, double x, double y) {
    return placed(footprint, {x, y}, 0);
  };
  const auto straight = examples::strip({{60, 0, 0}}, 16);  // 76 x 16 with its caps
  const int rim = plan.add_loop({{-100, -60}, {100, -60}, {100, 60}, {-100, 60}}, {0, 1, 2, 3});
  std::vector<int> inner = plan.add_bead(moved(straight, 0, 0), 4);
  const auto second = plan.add_bead(moved(straight, 10, 30), 4);  // 14 mm beside it
  inner.insert(inner.end(), second.begin(), second.end());
  std::vector<Vec2> hole;
  for (const Vec2 p : points_of(examples::circle(5), 0.2)) hole.push_back(p + Vec2{0, -25});
  inner.push_back(plan.add_loop(hole));
  plan.add_face(rim, inner, on(flat_base));
  Panel panel = plan.take();

  BeadTable table;
  for (const Index id : {1, 2}) {
    Bead& bead = table.beads.emplace_back();
    bead.id = id, bead.faces = {id - 1};
  }
  const auto distances = bead_distances(panel, table);
  ASSERT_EQ(2u, distances.size());
  EXPECT_NEAR(14, distances[0].bead.value_or(0), 1e-6);
  EXPECT_EQ(2, distances[0].nearest_bead);
  EXPECT_EQ(1, distances[1].nearest_bead);
  EXPECT_NEAR(52, distances[0].rim.value_or(0), 1e-6);
  EXPECT_NEAR(22, distances[1].rim.value_or(0), 1e-6);
  EXPECT_NEAR(12, distances[0].hole.value_or(0), 0.02);

  table.beads[1].listed = false;
  const auto alone = bead_distances(panel, table);
  ASSERT_EQ(1u, alone.size());
  EXPECT_FALSE(alone[0].bead);
}

TEST(DesignCheck, LimitsAreJudgedBothWays) {
  BeadDesign bead;
  bead.id = 7;
  bead.sections = {9, 5, 0.3, radians(50), 4.0, 2.0};
  bead.distances = {12.0, 3, 30.0, {}};
  std::vector<BeadDesign> beads{bead};
  EXPECT_TRUE(judge_design(beads, {}).empty());
  EXPECT_TRUE(judge_design(beads, {0.3, radians(50), 4.0, 2.0, 12.0, 30.0, 99.0}).empty());
  const auto found = judge_design(beads, {0.29, radians(49), 4.1, 2.1, 12.5, 31.0, 99.0});
  EXPECT_EQ((std::vector<std::string>{"depth_to_width", "wall_angle", "crown_radius", "root_radius",
                                      "bead_distance", "rim_distance"}),
            beads[0].exceeded);
  ASSERT_EQ(6u, found.size());
  EXPECT_EQ("warning design.wall_angle: bead 7: wall angle 50 degrees, the limit is 49 degrees",
            to_line(found[1]));
  beads[0].sections.sections = 0;
  judge_design(beads, {0.1, radians(1), {}, {}, {}, {}, {}});
  EXPECT_TRUE(beads[0].exceeded.empty());
}
