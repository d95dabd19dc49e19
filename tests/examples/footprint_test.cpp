#include "examples/footprint.h"

#include <gtest/gtest.h>

#include "examples/skeletons.h"

namespace beadmesh::examples {
namespace {

double signed_area(const PlanLoop& loop) {
  const std::vector<Vec2> points = sampled(loop);
  double twice = 0;
  for (std::size_t i = 0; i < points.size(); ++i) twice += cross(points[i], points[(i + 1) % points.size()]);
  return twice / 2;
}

double perimeter(const PlanLoop& loop) {
  double length = 0;
  for (const PlanEdge& edge : loop) length += edge.length();
  return length;
}

/// Unit tangent at fraction t.
Vec2 tangent(const PlanEdge& edge, double t) {
  if (!edge.is_arc()) return normalized(edge.end - edge.start);
  const Vec2 arm = edge.point(t) - edge.centre;
  return left_normal(arm) * ((edge.sweep > 0 ? 1 : -1) / edge.radius);
}

void expect_closed_and_smooth(const Footprint& footprint) {
  for (const PlanLoop& loop : footprint.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const PlanEdge& next = loop[(i + 1) % loop.size()];
      EXPECT_LT(distance(loop[i].end, next.start), 1e-9);
      EXPECT_LT(distance(loop[i].point(1), loop[i].end), 1e-9);
      EXPECT_LT(angle_between(tangent(loop[i], 1), tangent(next, 0)), 1e-6);
    }
}

TEST(Footprint, RoundedRectangleHasTheAreaAndPerimeterOfTheFormula) {
  const PlanLoop loop = rounded_rectangle(80, 50, 10);
  EXPECT_EQ(loop.size(), 8);
  EXPECT_NEAR(perimeter(loop), 2 * (60 + 30) + 2 * pi * 10, 1e-9);
  EXPECT_NEAR(signed_area(loop), 80 * 50 - (4 - pi) * 100, 1);
}

TEST(Footprint, RoundedRectangleOfFullRadiusIsAnOvalOfFourEdges) {
  const PlanLoop loop = rounded_rectangle(80, 50, 25);
  EXPECT_NEAR(perimeter(loop), 2 * 30 + 2 * pi * 25, 1e-9);
  EXPECT_EQ(loop.size(), 6);  // the quarter arcs stay apart
}

TEST(Footprint, ReversedTwiceIsTheSame) {
  const PlanLoop loop = t_bead(90, 40, 14, 8).loops.front(), back = reversed(reversed(loop));
  ASSERT_EQ(back.size(), loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i) {
    EXPECT_EQ(back[i].start, loop[i].start);
    EXPECT_DOUBLE_EQ(back[i].start_angle, loop[i].start_angle);
    EXPECT_DOUBLE_EQ(back[i].sweep, loop[i].sweep);
  }
  EXPECT_LT(signed_area(reversed(loop)), 0);
}

TEST(Footprint, StripHasThePathsLengthAndTheBandsArea) {
  const Footprint l = l_bead(50, 40, 20, 90, 14);
  EXPECT_NEAR(l.centreline_length, 90 + 10 * pi, 1e-9);
  EXPECT_NEAR(signed_area(l.loops.front()), l.centreline_length * 14 + pi * 49, 1.5);
  EXPECT_NEAR(perimeter(l.loops.front()), 2 * l.centreline_length + 14 * pi, 1e-9);
}

TEST(Footprint, TaperTouchesBothCapCircles) {
  const Footprint t = taper(80, 24, 12);
  const BoundaryDistance inside(t.loops);
  EXPECT_NEAR(inside({-40, 0}), 12, 1e-9);
  EXPECT_NEAR(inside({40, 0}), 6, 1e-9);
  EXPECT_NEAR(inside({0, 0}), 9, 1e-9);  // the inscribed circles grow evenly along the axis
}

TEST(Footprint, AllBeadsAreClosedSmoothAndCounterClockwise) {
  const std::vector<Footprint> beads{
      straight_bead(80, 16),         arc_bead(60, 80, 14),        s_bead(40, 70, 12),
      l_bead(50, 40, 20, 90, 14),    g_bead(30, 14, 12),          taper(80, 24, 12),
      t_bead(90, 40, 14, 8),         y_bead(45, 14, 8),           x_bead(90, 75, 12, 8),
      h_bead(80, 50, 12, 8),         comb_bead(5, 34, 46, 12, 8), trident_bead(60, 34, 38, 12, 7),
      ladder_bead(3, 30, 44, 11, 6), circular_ring(44, 12),       rounded_ring(90, 70, 20, 13),
      wavy_bead(30, 90, 2, 12),      f_bead(80, 40, 12, 8),       curved_comb_bead(3, 84, 24, 40, 12, 7),
      tree_bead(44, 45, 36, 12, 7),  eccentric_ring(44, 12, 3),   oval_with_round_window(90, 80, 13)};
  for (const Footprint& bead : beads) {
    expect_closed_and_smooth(bead);
    EXPECT_GT(signed_area(bead.loops.front()), 0);
    for (std::size_t i = 1; i < bead.loops.size(); ++i) EXPECT_LT(signed_area(bead.loops[i]), 0);
  }
  EXPECT_EQ(beads[12].loops.size(), 3);
  EXPECT_EQ(beads[10].loops.size(), 1);
}

TEST(Footprint, CurvedCombIsABandAroundItsCentreLines) {
  const Footprint comb = curved_comb_bead(3, 84, 24, 40, 12, 7);
  EXPECT_EQ(comb.loops.front().size(), 3 * 6 + 4);
  EXPECT_NEAR(comb.centreline_length, 84 * radians(4 * 24) + 3 * 40, 1e-9);
  // Bands, two half caps of the spine, a half cap and an overlap a tooth; the fillets add a little.
  const double bands = comb.centreline_length * 12 - 3 * 6 * 12, caps = 5 * pi * 36 / 2;
  EXPECT_NEAR(signed_area(comb.loops.front()), bands + caps, 90);
}

TEST(Footprint, WavyBeadEndsAsItBegan) {
  const Footprint wavy = wavy_bead(30, 90, 2, 12);
  EXPECT_NEAR(wavy.centreline_length, 30 * radians(90) * 3, 1e-9);
  double turn = 0;  // of one side: the heading at the end is that at the start
  for (int i = 0; i < 4; ++i) turn += wavy.loops.front()[i].sweep;
  EXPECT_NEAR(turn, 0, 1e-12);
}

TEST(Footprint, BandsBetweenLoopsOfTheirOwnHaveNoConstantWidth) {
  const BoundaryDistance to(eccentric_ring(44, 12, 3).loops);
  EXPECT_NEAR(to.to_loop(0, {40, 0}) + to.to_loop(1, {40, 0}), 9, 1e-9);
  EXPECT_NEAR(to.to_loop(0, {-40, 0}) + to.to_loop(1, {-40, 0}), 15, 1e-9);
  const Footprint oval = oval_with_round_window(90, 80, 13);
  const BoundaryDistance of_oval(oval.loops);
  EXPECT_NEAR(of_oval({0, 33.5}), 6.5, 1e-9);
  EXPECT_NEAR(of_oval({36, 0}), 9, 1e-9);
}

TEST(Footprint, CentreLinesKeepHalfTheWidthFromTheBoundary) {
  const std::vector<Footprint> beads{arc_bead(60, 80, 14), g_bead(30, 14, 12), comb_bead(5, 34, 46, 12, 8),
                                     circular_ring(44, 12), rounded_ring(90, 70, 20, 13)};
  for (const Footprint& bead : beads) {
    const BoundaryDistance inside(bead.loops);
    double length = 0;
    for (const PlanLoop& chain : bead.centrelines) {
      for (const Vec2 p : sampled(chain)) EXPECT_GT(inside(p), bead.half_width - 1e-6);
      for (const PlanEdge& edge : chain) {
        EXPECT_NEAR(inside(edge.point(0)), bead.half_width, 3) << "a little more at junctions";
        length += edge.length();
      }
    }
    EXPECT_NEAR(length, bead.centreline_length, 1e-9);
  }
}

TEST(Footprint, BoundaryDistanceIsSigned) {
  const BoundaryDistance inside(circular_ring(40, 10).loops);
  EXPECT_NEAR(inside({35, 0}), 5, 1e-9);
  EXPECT_NEAR(inside({0, 33}), 3, 1e-9);
  EXPECT_NEAR(inside({0, 0}), -30, 1e-9);
  EXPECT_NEAR(inside({0, -52}), -12, 1e-9);
}

}  // namespace
}  // namespace beadmesh::examples
