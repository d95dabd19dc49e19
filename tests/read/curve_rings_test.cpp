// Loops of lines and arcs, as CURVEPOLYGON gives them.
#include "beadmesh/read/curve_rings.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "beadmesh/read/polygon_reader.h"

namespace beadmesh {
namespace {

PlanarRegion region_of(const std::string& text) {
  auto region = parse_wkt(text);
  EXPECT_TRUE(region) << text << ": " << (region ? "" : to_line(region.error()));
  return region ? *region : PlanarRegion{};
}

void expect_failure(const std::string& text, const std::string& code, const std::string& entity,
                    const std::string& in_message) {
  const auto region = parse_wkt(text);
  ASSERT_FALSE(region) << text;
  EXPECT_EQ(region.error().code, code) << region.error().message;
  EXPECT_EQ(region.error().entity, entity);
  EXPECT_NE(region.error().message.find(in_message), std::string::npos) << region.error().message;
}

std::string text_of(const std::vector<Vec2>& points) {
  std::string text;
  for (const Vec2 p : points) {
    char buffer[80];
    std::snprintf(buffer, sizeof buffer, "%s%.17g %.17g", text.empty() ? "(" : ", ", p.x, p.y);
    text += buffer;
  }
  return text + ")";
}

Vec2 on_circle(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

const CircularArc& arc_of(const PlanarRegion& region, std::size_t loop, std::size_t segment) {
  return dynamic_cast<const CircularArc&>(*region.curves.at(region.loops[loop].curve[segment]));
}

/// Every facet runs along its curve between its two points, by no more than `most`; returns the area under
/// the arcs.
void expect_facets_on_curves(const PlanarRegion& region, double most, double tolerance) {
  for (const PlanarLoop& loop : region.loops) {
    const std::size_t n = loop.points.size();
    ASSERT_EQ(loop.curve.size(), n);
    ASSERT_EQ(loop.parameters.size(), n);
    ASSERT_EQ(loop.corner.size(), n);
    for (std::size_t i = 0; i < n; ++i) {
      if (loop.curve[i] == no_index) continue;
      const PlanarCurve& curve = *region.curves.at(loop.curve[i]);
      const auto [from, to] = loop.parameters[i];
      EXPECT_LT(distance(curve.at(from).point, loop.points[i]), tolerance);
      EXPECT_LT(distance(curve.at(to).point, loop.points[(i + 1) % n]), tolerance);
      EXPECT_LE(std::abs(to - from), most);
    }
  }
}

constexpr double facet = radians(7.5) + 1e-12;

TEST(CurveRings, stadium) {
  const PlanarRegion region = region_of(
      "CurvePolygon(CompoundCurve((0 -8, 40 -8), CircularString(40 -8, 48 0, 40 8), (40 8, 0 8),\n"
      " CIRCULARSTRING(0 8, -8 0, 0 -8)))");
  ASSERT_EQ(region.loops.size(), 1u);
  const PlanarLoop& loop = region.loops[0];
  EXPECT_EQ(loop.points.size(), 2u + 24 + 24);
  EXPECT_EQ(std::count(loop.corner.begin(), loop.corner.end(), true), 0) << "lines and arcs are tangent";
  EXPECT_EQ(std::count(loop.curve.begin(), loop.curve.end(), no_index), 2);
  EXPECT_LT(distance(arc_of(region, 0, 5).centre(), {40, 0}), 1e-13);
  EXPECT_NEAR(arc_of(region, 0, 5).radius(), 8, 1e-13);
  expect_facets_on_curves(region, facet, 1e-13);
  for (const Vec2 p : loop.points)
    EXPECT_NEAR(p.x > 40 ? distance(p, {40, 0}) : p.x < 0 ? norm(p) : std::abs(p.y), 8, 1e-13);
}

TEST(CurveRings, full_circles_and_their_direction) {
  const PlanarRegion region =
      region_of("CURVEPOLYGON(CIRCULARSTRING(10 0, -10 0, 10 0), CIRCULARSTRING(6 0, 0 6, -6 0, 0 -6, 6 0))");
  ASSERT_EQ(region.loops.size(), 2u);
  EXPECT_EQ(region.loops[0].points.size(), 48u);
  EXPECT_GT(signed_area(region.loops[0]), 0);
  EXPECT_LT(signed_area(region.loops[1]), 0) << "turned round, and the parameters with it";
  expect_facets_on_curves(region, facet, 1e-13);
  EXPECT_LT(region.loops[1].parameters[0][1], region.loops[1].parameters[0][0]);
  for (const PlanarLoop& loop : region.loops)
    EXPECT_EQ(std::count(loop.corner.begin(), loop.corner.end(), true), 0);
}

TEST(CurveRings, corners_are_where_the_tangent_turns) {
  // A half disc: two corners; and a lens with tangents that differ by 0.02 or by 0.005 degrees from a line's.
  const PlanarRegion half =
      region_of("CURVEPOLYGON(COMPOUNDCURVE(CIRCULARSTRING(5 0, 0 5, -5 0), (-5 0, 0 0, 5 0)))");
  const PlanarLoop& loop = half.loops[0];
  EXPECT_EQ(std::count(loop.corner.begin(), loop.corner.end(), true), 2);
  for (std::size_t i = 0; i < loop.points.size(); ++i)
    EXPECT_EQ(loop.corner[i], std::abs(std::abs(loop.points[i].x) - 5) < 1e-12 && loop.points[i].y == 0);
  // An arc of 90 degrees between two lines, turned out of their tangents.
  for (const auto& [turn, corners] : {std::pair(0.005, 1), std::pair(0.02, 3)}) {
    const auto p = [turn = radians(turn)](double angle) { return on_circle(10, angle - turn); };
    const PlanarRegion region =
        region_of("CURVEPOLYGON(COMPOUNDCURVE(CIRCULARSTRING" + text_of({p(0), p(pi / 4), p(pi / 2)}) + "," +
                  text_of({p(pi / 2), {-20, 10}, {10, -20}, p(0)}) + "))");
    const auto& tags = region.loops[0].corner;
    EXPECT_EQ(std::count(tags.begin(), tags.end(), true), corners + 1) << turn;
  }
}

TEST(CurveRings, lines_alone_and_dimensions) {
  const PlanarRegion region = region_of(
      "CURVEPOLYGON Z((0 0 1, 4 0 1, 8 0 1, 8 8 1, 0 8 1, 0 0 1), LINESTRING Z(2 2 0, 3 2 0, 3 3 0, 2 2 0))");
  EXPECT_EQ(region.loops[0].corner, (std::vector<bool>{true, false, true, true, true}));
  EXPECT_EQ(region.loops[0].curve, std::vector<Index>(5, no_index));
  EXPECT_EQ(region_of("CURVEPOLYGONZ(CIRCULARSTRINGZ(1 0 9, -1 0 9, 1 0 9))").loops.size(), 1u);
}

TEST(CurveRings, three_points_on_a_line_are_a_line) {
  const PlanarRegion region =
      region_of("CURVEPOLYGON(COMPOUNDCURVE(CIRCULARSTRING(0 0, 5 0, 10 0), (10 0, 10 10, 0 0)))");
  EXPECT_EQ(region.loops[0].points.size(), 3u);
  EXPECT_TRUE(region.curves.empty());
  expect_failure("CURVEPOLYGON(COMPOUNDCURVE(CIRCULARSTRING(0 0, 15 0, 10 0), (10 0, 10 10, 0 0)))",
                 "read.wkt.arc", "loop 1", "the arc from point 1 to point 3 of loop 1");
}

TEST(CurveRings, facets_are_finer_where_something_is_near) {
  // A gap of 1e-3 of the radius, less than the height of a facet of 7.5 degrees (2.1e-3 of the radius).
  const PlanarRegion ring = region_of(
      "CURVEPOLYGON(CIRCULARSTRING(10 0, -10 0, 10 0),"
      "CIRCULARSTRING(9.99 0, -9.99 0, 9.99 0))");
  EXPECT_GT(ring.loops[1].points.size(), 48u);
  expect_facets_on_curves(ring, facet, 1e-12);
  // A hole in the bulge of a facet, outside of its chord.
  const Vec2 p = on_circle(9.9895, radians(3.75));
  const PlanarRegion holed = region_of("CURVEPOLYGON(CIRCULARSTRING(10 0, -10 0, 10 0)," +
                                       text_of({p, p + Vec2{1e-3, 0}, p + Vec2{0, 1e-3}, p}) + ")");
  EXPECT_EQ(holed.loops.size(), 2u);
  EXPECT_GT(holed.loops[0].points.size(), 48u);
}

void expect_conflict(const std::string& text) {
  const auto region = parse_wkt(text);
  ASSERT_FALSE(region) << text;
  const std::string& code = region.error().code;
  EXPECT_TRUE(code == "delaunay.region.crossing" || code == "delaunay.region.touching" ||
              code == "read.wkt.arc")
      << to_line(region.error());
}

TEST(CurveRings, curves_that_cross_where_their_facets_do_not) {
  const auto in_box = [](double x, const std::vector<Vec2>& circle) {
    return "CURVEPOLYGON(" + text_of({{-20, -20}, {x, -20}, {x, 20}, {-20, 20}, {-20, -20}}) +
           ",CIRCULARSTRING" + text_of(circle) + ")";
  };
  // The wall at x = 9.999 cuts the bulge of the facet between -3.75 and 3.75 degrees; its chord ends
  // at 9.979.
  const double half = radians(3.75);
  expect_conflict(in_box(9.999, {on_circle(10, half), on_circle(-10, half), on_circle(10, half)}));
  expect_conflict(in_box(10, {{0, 10}, {0, -10}, {0, 10}}));  // touches
  EXPECT_TRUE(parse_wkt(in_box(10.001, {on_circle(10, half), on_circle(-10, half), on_circle(10, half)})));
}

TEST(CurveRings, an_arc_that_cuts_its_neighbour_beside_their_joint) {
  // The line comes to the arc's start from where the arc goes: outside of the tangent by 2 degrees, then
  // inside.
  const auto loop = [](double lean) {
    const Vec2 far = Vec2{10, 0} + on_circle(30, pi / 2 + lean);
    return "CURVEPOLYGON(COMPOUNDCURVE(CIRCULARSTRING(10 0, 0 10, -10 0), " +
           text_of({{-10, 0}, {-40, 0}, {-40, 60}, far, {10, 0}}) + "))";
  };
  EXPECT_TRUE(parse_wkt(loop(radians(-2))));
  expect_conflict(loop(radians(2)));
}

TEST(CurveRings, a_cusp_between_an_arc_and_its_tangent) {
  const auto tip = Vec2{10, 10} + on_circle(10, radians(225));
  const PlanarRegion cusp = region_of("CURVEPOLYGON(COMPOUNDCURVE((10 0, 40 0, 40 10, 0 10), CIRCULARSTRING" +
                                      text_of({{0, 10}, tip, {10, 0}}) + "))");
  EXPECT_EQ(std::count(cusp.loops[0].corner.begin(), cusp.loops[0].corner.end(), true), 3);
  const PlanarRegion sharp = region_of("CURVEPOLYGON(COMPOUNDCURVE((10 0, 0 0, 0 10), CIRCULARSTRING" +
                                       text_of({{0, 10}, tip, {10, 0}}) + "))");
  EXPECT_EQ(std::count(sharp.loops[0].corner.begin(), sharp.loops[0].corner.end(), true), 3);
  EXPECT_LE(sharp.loops[0].points.size(), 2u + 12) << "tangent neighbours need no finer facets";
}

TEST(CurveRings, bad_curves) {
  expect_failure("CURVEPOLYGON(CIRCULARSTRING(0 0, 1 1, 2 0))", "read.wkt.syntax", "line 1",
                 "loop 1 is open");
  expect_failure("CURVEPOLYGON(CIRCULARSTRING(0 0, 1 1, 2 0, 0 0))", "read.wkt.syntax", "line 1", "3, 5, 7");
  expect_failure("CURVEPOLYGON(COMPOUNDCURVE((0 0, 1 0),(2 0, 0 0)))", "read.wkt.syntax", "line 1",
                 "point 3 of loop 1");
  expect_failure("CURVEPOLYGON(CIRCULARSTRING(0 0, 0 0, 2 0, 1 5, 0 0))", "read.wkt.arc", "loop 1",
                 "same point");
  expect_failure("CURVEPOLYGON(CIRCULARSTRING(0 0, 0 0, 0 0))", "read.wkt.arc", "loop 1", "same point");
  expect_failure("CURVEPOLYGON(CIRCULARSTRING(0 0, nan 0, 0 0))", "delaunay.region.not_finite", "loop 1",
                 "point 1 to point 3");
  expect_failure("CURVEPOLYGON(CIRCLE(0 0, 1 1, 2 0))", "read.wkt.syntax", "line 1", "'CIRCLE'");
  expect_failure("CURVEPOLYGON(COMPOUNDCURVE(CIRCLE(0 0, 1 1, 2 0)))", "read.wkt.syntax", "line 1",
                 "'CIRCLE'");
  expect_failure("CURVEPOLYGON(COMPOUNDCURVE((0 0, 1 0)", "read.wkt.syntax", "line 1", "");
  expect_failure("CURVEPOLYGON(CIRCULARSTRING(10 0, -10 0, 10 0),CIRCULARSTRING(12 0, 4 0, 12 0))",
                 "delaunay.region.crossing", "loop 1", "the arc from point 1 to point 3 of loop 2");
  expect_failure("CURVEPOLYGON((0 0, 0 0))", "delaunay.region.few_points", "loop 1", "");
}

RC_GTEST_PROP(CurveRings, an_arc_passes_through_its_three_points, ()) {
  const auto number = [] { return *rc::gen::inRange(-1000, 1001) * 0.01; };
  const Vec2 a{number(), number()}, b{number(), number()}, c{number(), number()};
  RC_PRE(std::abs(cross(b - a, c - a)) > 1e-3);
  const auto text = [](Vec2 p) { return std::to_string(p.x) + " " + std::to_string(p.y); };
  const auto region = parse_wkt("CURVEPOLYGON(COMPOUNDCURVE(CIRCULARSTRING(" + text(a) + "," + text(b) + "," +
                                text(c) + "),(" + text(c) + "," + text(a) + ")))");
  RC_ASSERT(region.has_value());
  const PlanarLoop& loop = region->loops[0];
  const auto& arc = dynamic_cast<const CircularArc&>(*region->curves[0]);
  RC_ASSERT(std::abs(distance(arc.centre(), b) - arc.radius()) < 1e-9 * arc.radius());
  // The middle point is near a facet of the arc, and not on the other side of the circle.
  double nearest = 1e9;
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    if (loop.curve[i] == no_index) continue;
    const Vec2 p = loop.points[i], d = loop.points[(i + 1) % loop.points.size()] - p;
    const double t = std::clamp(dot(b - p, d) / squared_norm(d), 0.0, 1.0);
    nearest = std::min(nearest, distance(b, p + d * t));
  }
  RC_ASSERT(nearest < 0.0025 * arc.radius());
}

}  // namespace
}  // namespace beadmesh
