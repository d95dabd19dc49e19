// The medial object against axes in closed form, and radii against the distance
// to the boundary by brute force.
#include <gtest/gtest.h>

#include <utility>

#include "beadmesh/medial/medial_object.h"
#include "medial/axis_comparison.h"
#include "medial/exact_region.h"
#include "medial/reference_axis.h"

namespace beadmesh {
namespace {

using namespace exact_shapes;
using namespace reference;

using Counts = MedialCounts;

/// How exact an answer must be, in parts of the region's size.
struct Goal {
  double radius, hausdorff;
};

constexpr Goal exact_goal{1e-10, 1e-7};  // lines, circular arcs
constexpr Goal curved_goal{1e-8, 1e-7};  // other curves with an evaluator

void expect_medial(const PlanarRegion& region, const Counts& expected, const Axis& axis, Goal goal) {
  const auto object = medial_object(region);
  ASSERT_TRUE(object) << to_line(object.error());
  EXPECT_EQ(medial_counts(*object), expected);
  const double size = diagonal(region);
  EXPECT_LE(radius_error(*object, Boundary(region)) / size, goal.radius);
  if (axis.empty()) return;
  const Hausdorff error = hausdorff(*object, axis);
  EXPECT_LE(error.found_to_known / size, goal.hausdorff);
  EXPECT_LE(error.known_to_found / size, goal.hausdorff);
}

const Counts bar{{"C", 4}, {"J", 2}, {"C-J", 4}, {"J-J", 1}};
const Counts one_arm{{"S", 2}, {"S-S", 1}};
const Counts ring{{"N", 1}};

TEST(AnalyticShapes, Rectangle) {
  expect_medial(polygon({{{0, 0}, {100, 0}, {100, 20}, {0, 20}}}), bar, rectangle_axis(100, 20), exact_goal);
  expect_medial(polygon({{{0, 0}, {20.1, 0}, {20.1, 20}, {0, 20}}}), bar, rectangle_axis(20.1, 20),
                exact_goal);
  expect_medial(polygon({{{0, 0}, {1e5, 0}, {1e5, 20}, {0, 20}}}), bar, rectangle_axis(1e5, 20), exact_goal);
}

TEST(AnalyticShapes, SharpL) {
  const auto region = [](double w, double x, double y) {
    return polygon({{{0, 0}, {x, 0}, {x, w}, {w, w}, {w, y}, {0, y}}});
  };
  const Counts expected{{"C", 5}, {"J", 3}, {"C-J", 5}, {"J-J", 2}};
  expect_medial(region(20, 80, 70), expected, l_axis(20, 80, 70), exact_goal);
  expect_medial(region(3, 200, 11), expected, l_axis(3, 200, 11), exact_goal);
}

TEST(AnalyticShapes, SharpT) {
  const double h = 7;
  expect_medial(polygon({{{-h, -60}, {h, -60}, {h, -h}, {50, -h}, {50, h}, {-50, h}, {-50, -h}, {-h, -h}}}),
                {{"C", 6}, {"J", 4}, {"C-J", 6}, {"J-J", 3}}, t_axis(h, 50, 60), exact_goal);
}

TEST(AnalyticShapes, SharpComb) {
  expect_medial(polygon({comb_corners(15, 10, 20, 40)}), {{"C", 32}, {"J", 30}, {"C-J", 32}, {"J-J", 29}},
                comb_axis(15, 10, 20, 40), exact_goal);
  expect_medial(polygon({comb_corners(3, 4, 31, 8)}), {{"C", 8}, {"J", 6}, {"C-J", 8}, {"J-J", 5}},
                comb_axis(3, 4, 31, 8), exact_goal);
}

TEST(AnalyticShapes, Stadium) {
  for (const double step : {15.0, 7.5, 3.0})
    expect_medial(stadium(104, 8, {true, radians(step), 0}), one_arm, {straight({0, 0}, {104, 0})},
                  exact_goal);
}

TEST(AnalyticShapes, FullDisc) {
  for (const double phase : {0.0, 0.4}) {
    PlanarRegion region;
    LoopBuilder(region, {true, radians(7.5), phase}).circle({3, 4}, 20).close();
    const auto object = medial_object(finished(region, {}));
    ASSERT_TRUE(object) << to_line(object.error());
    ASSERT_EQ(medial_counts(*object), (Counts{{"isolated", 1}}));
    EXPECT_LT(distance(object->vertices[0].point, {3, 4}), 1e-10);
    EXPECT_NEAR(object->vertices[0].radius, 20, 1e-10);
  }
}

TEST(AnalyticShapes, ConcentricAnnulus) {
  expect_medial(annulus(40, 28, {}), ring, annulus_axis(40, 28, {}), exact_goal);
  expect_medial(annulus(40, 1, {}), ring, annulus_axis(40, 1, {}), exact_goal);
  expect_medial(annulus(40, 39, {}, {true, radians(1), 0.3}), ring, annulus_axis(40, 39, {}), exact_goal);
}

TEST(AnalyticShapes, EccentricAnnulus) {
  for (const double phase : {0.0, 0.5})
    expect_medial(annulus(40, 20, {9, 4}, {true, radians(7.5), phase}), ring, annulus_axis(40, 20, {9, 4}),
                  exact_goal);
  expect_medial(annulus(40, 2, {-30, 0}), ring, annulus_axis(40, 2, {-30, 0}), exact_goal);
}

TEST(AnalyticShapes, PlateWithARoundHole) {
  const Counts expected{{"C", 4}, {"J", 4}, {"C-J", 4}, {"J-J", 4}};
  expect_medial(holed_plate(30, 12), expected, holed_plate_axis(30, 12), exact_goal);
  expect_medial(holed_plate(30, 0.5), expected, holed_plate_axis(30, 0.5), exact_goal);
}

TEST(AnalyticShapes, Ellipse) {
  for (const auto& [a, b] : {std::pair(50.0, 25.0), std::pair(50.0, 45.0), std::pair(50.0, 10.0)})
    for (const double phase : {0.0, 0.37}) {
      SCOPED_TRACE(testing::Message() << "axes " << a << ", " << b << ", phase " << phase);
      const double end = a - b * b / a;
      expect_medial(ellipse(a, b, {true, radians(7.5), phase}), one_arm, {straight({-end, 0}, {end, 0})},
                    curved_goal);
    }
}

TEST(AnalyticShapes, GasketWithFortyHoles) {
  expect_medial(gasket(), {{"J", 78}, {"J-J", 117}}, {}, exact_goal);
}

TEST(AnalyticShapes, LinesAndArcs) {
  // A bend that is concentric (no junction), and one that is not.
  expect_medial(rounded({{-7, -7}, {90, -7}, {90, 7}, {7, 7}, {7, 70}, {-7, 70}}, {21, 7, 7, 7, 7, 7}),
                one_arm, {}, exact_goal);
  expect_medial(rounded({{-8, -8}, {90, -8}, {90, 8}, {8, 8}, {8, 70}, {-8, 70}}, {3, 8, 8, 4, 8, 8}),
                {{"S", 3}, {"J", 1}, {"S-J", 3}}, {}, exact_goal);
}

// Facets: no better than their sagitta, measured from the curves that they
// stand for.
TEST(AnalyticShapes, FacetsAreAsExactAsTheirSagitta) {
  for (const double step : {7.5, 3.0, 1.0}) {
    SCOPED_TRACE(testing::Message() << "facets of " << step << " degrees");
    const Accuracy facets{false, radians(step), 0.3};
    const auto sagitta = [&](double r) { return r * (1 - std::cos(radians(step) / 2)); };
    const auto goal = [&](const PlanarRegion& region, double r) {
      const double most =
          1.001 * sagitta(r) / diagonal(region);  // the radius reaches the curve, a sagitta beyond
      return Goal{most, most};
    };
    const PlanarRegion slot = stadium(104, 8, facets), round = annulus(40, 28, {}, facets),
                       moon = annulus(40, 20, {9, 4}, facets), plate = holed_plate(30, 12, facets);
    expect_medial(slot, one_arm, {straight({0, 0}, {104, 0})}, goal(slot, 8));
    expect_medial(round, ring, annulus_axis(40, 28, {}), goal(round, 40));
    expect_medial(moon, ring, annulus_axis(40, 20, {9, 4}), goal(moon, 40));
    expect_medial(plate, {{"C", 4}, {"J", 4}, {"C-J", 4}, {"J-J", 4}}, holed_plate_axis(30, 12),
                  goal(plate, 12));
  }
}

}  // namespace
}  // namespace beadmesh
