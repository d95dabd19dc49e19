#include "beadmesh/medial/medial_object.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>
#include <map>

#include "medial/shapes.h"

namespace beadmesh {
namespace {

using Counts = std::map<std::string, int>;

PlanarRegion checked(PlanarRegion region) {
  auto result = checked_region(std::move(region));
  EXPECT_TRUE(result) << (result ? "" : to_line(result.error()));
  return result ? *result : PlanarRegion{};
}

/// The medial object, verified.
MedialObject medial_of(const PlanarRegion& region, double tolerance, const MedialOptions& options = {}) {
  const PlanarRegion good = checked(region);
  auto object = medial_object(good, options);
  EXPECT_TRUE(object) << (object ? "" : to_line(object.error()));
  if (!object) return {};
  const auto violations = verify_medial_object(*object, good, tolerance);
  EXPECT_TRUE(violations.empty()) << violations.size() << " violations, the first: " << violations.front();
  return *object;
}

/// Exact to 1e-10 of the size: sharp polygons.
MedialObject exact_medial_of(const PlanarRegion& region) {
  return medial_of(region, 1e-10 * diagonal(region));
}

Counts counts(const MedialObject& object) {
  Counts counts;
  for (const MedialVertex& vertex : object.vertices) ++counts[name_of(vertex.type)];
  for (const MedialEdge& edge : object.edges) ++counts[name_of(edge.type)];
  return counts;
}

const MedialVertex& nearest_vertex(const MedialObject& object, Vec2 to) {
  return *std::min_element(object.vertices.begin(), object.vertices.end(),
                           [&](const MedialVertex& a, const MedialVertex& b) {
                             return distance(a.point, to) < distance(b.point, to);
                           });
}

double greatest_kink(const MedialObject& object) {
  double most = 0;
  for (const MedialEdge& edge : object.edges)
    for (std::size_t i = 1; i + 1 < edge.points.size(); ++i)
      most = std::max(most, angle_between(edge.points[i].point - edge.points[i - 1].point,
                                          edge.points[i + 1].point - edge.points[i].point));
  return most;
}

TEST(MedialObject, Rectangle) {
  const MedialObject object = exact_medial_of(shapes::rectangle(100, 20));
  EXPECT_EQ(counts(object), (Counts{{"C", 4}, {"J", 2}, {"C-J", 4}, {"J-J", 1}}));
  for (const Vec2 end : {Vec2{10, 10}, Vec2{90, 10}}) {
    const MedialVertex& junction = nearest_vertex(object, end);
    EXPECT_LT(distance(junction.point, end), 1e-10);
    EXPECT_NEAR(junction.radius, 10, 1e-10);
    EXPECT_EQ(junction.touching_points.size(), 3u);
  }
  for (const MedialEdge& edge : object.edges) {
    const bool bar = edge.type == MedialEdgeType::JJ;
    EXPECT_NEAR(edge.length, bar ? 80 : 10 * std::sqrt(2), 1e-9);
    EXPECT_NEAR(edge.thickness.mean, bar ? 20 : 10, 1e-9);
    EXPECT_NEAR(edge.thickness.max, 20, 1e-9);
    EXPECT_NEAR(edge.thickness.min, bar ? 20 : 0, 1e-9);
    if (!bar) continue;
    for (std::size_t i = 1; i + 1 < edge.points.size(); ++i)
      EXPECT_NEAR(edge.points[i].subtended_angle, pi, 1e-9);
  }
}

TEST(MedialObject, SquareHasOneJunctionOfDegreeFour) {
  const MedialObject object = exact_medial_of(shapes::rectangle(30, 30));
  EXPECT_EQ(counts(object), (Counts{{"C", 4}, {"J", 1}, {"C-J", 4}}));
}

TEST(MedialObject, JunctionsThatAreNearButNotOneStayTwo) {
  for (const double longer : {1e-3, 1e-5}) {
    const MedialObject object = exact_medial_of(shapes::rectangle(20 + longer, 20));
    EXPECT_EQ(counts(object), (Counts{{"C", 4}, {"J", 2}, {"C-J", 4}, {"J-J", 1}})) << longer;
    for (const MedialVertex& vertex : object.vertices) EXPECT_FALSE(vertex.merged);
  }
}

TEST(MedialObject, Trapezium) {
  const MedialObject object = exact_medial_of(shapes::region_of({{{0, 0}, {120, 0}, {90, 30}, {20, 30}}}));
  EXPECT_EQ(counts(object), (Counts{{"C", 4}, {"J", 2}, {"C-J", 4}, {"J-J", 1}}));
}

TEST(MedialObject, TriangleHasItsIncentre) {
  const MedialObject object = exact_medial_of(shapes::region_of({{{0, 0}, {40, 0}, {0, 30}}}));
  EXPECT_EQ(counts(object), (Counts{{"C", 3}, {"J", 1}, {"C-J", 3}}));
  EXPECT_LT(distance(nearest_vertex(object, {10, 10}).point, {10, 10}), 1e-10);
}

TEST(MedialObject, Quadrilateral) {
  const MedialObject object = exact_medial_of(shapes::region_of({{{0, 0}, {50, -7}, {61, 40}, {-9, 33}}}));
  EXPECT_EQ(counts(object), (Counts{{"C", 4}, {"J", 2}, {"C-J", 4}, {"J-J", 1}}));
}

TEST(MedialObject, StadiumIsOneEdgeBetweenTheArcCentres) {
  for (const double phase : {0.0, 0.3, 0.7}) {
    const MedialObject object = medial_of(shapes::stadium(104, 8, {2, 0.05, phase}), 0.06);
    ASSERT_EQ(counts(object), (Counts{{"S", 2}, {"S-S", 1}})) << "phase " << phase;
    for (const Vec2 end : {Vec2{0, 0}, Vec2{104, 0}}) {
      const MedialVertex& vertex = nearest_vertex(object, end);
      EXPECT_LT(distance(vertex.point, end), 0.01);
      EXPECT_NEAR(vertex.radius, 8, 0.06);
      ASSERT_EQ(vertex.touching_points.size(), 3u);
      const Vec2 first = vertex.touching_points[0].point - end, last = vertex.touching_points[1].point - end;
      EXPECT_GT(angle_between(first, last), radians(160)) << "ends of the contact";
      EXPECT_LT(std::abs(vertex.touching_points[2].point.y), 1.2) << "its middle";
    }
    EXPECT_NEAR(object.edges[0].length, 104, 0.02);
    EXPECT_NEAR(object.edges[0].thickness.mean, 16, 0.06);
    EXPECT_LT(degrees(greatest_kink(object)), 1);
  }
}

TEST(MedialObject, TaperedStadium) {
  const MedialObject object = medial_of(shapes::tapered_stadium(90, 14, 7), 0.06);
  ASSERT_EQ(counts(object), (Counts{{"S", 2}, {"S-S", 1}}));
  EXPECT_LT(distance(nearest_vertex(object, {0, 0}).point, {0, 0}), 0.02);
  EXPECT_LT(distance(nearest_vertex(object, {90, 0}).point, {90, 0}), 0.02);
  EXPECT_NEAR(object.edges[0].thickness.max, 28, 0.1);
  EXPECT_NEAR(object.edges[0].thickness.min, 14, 0.1);
  EXPECT_NEAR(object.edges[0].thickness.mean, 21, 0.1);
}

TEST(MedialObject, SharpL) {
  const MedialObject object =
      exact_medial_of(shapes::region_of({{{0, 0}, {80, 0}, {80, 20}, {20, 20}, {20, 70}, {0, 70}}}));
  EXPECT_EQ(counts(object), (Counts{{"C", 5}, {"J", 3}, {"C-J", 5}, {"J-J", 2}}));
}

TEST(MedialObject, BendsOfConstantWidthAreOneEdge) {
  EXPECT_EQ(counts(medial_of(shapes::letter_l(14, 21, 7), 0.06)), (Counts{{"S", 2}, {"S-S", 1}}));
  EXPECT_EQ(counts(medial_of(shapes::letter_g(12), 0.06)), (Counts{{"S", 2}, {"S-S", 1}}));
}

TEST(MedialObject, NarrowOuterCornerGivesASpur) {
  const MedialObject object = medial_of(shapes::letter_l(16, 3, 4), 0.06);
  EXPECT_EQ(counts(object), (Counts{{"S", 3}, {"J", 1}, {"S-J", 3}}));
}

TEST(MedialObject, Letters) {
  const shapes::Facetting facetting;
  EXPECT_EQ(counts(medial_of(shapes::letter_t(14, 6, facetting), 0.06)),
            (Counts{{"S", 3}, {"J", 1}, {"S-J", 3}}));
  EXPECT_EQ(counts(exact_medial_of(shapes::letter_t(14, 0, facetting))),
            (Counts{{"C", 6}, {"J", 4}, {"C-J", 6}, {"J-J", 3}}));
  EXPECT_EQ(counts(medial_of(shapes::letter_h(14, 6, facetting), 0.06)),
            (Counts{{"S", 4}, {"J", 2}, {"S-J", 4}, {"J-J", 1}}));
}

TEST(MedialObject, CrossingIsOneJunctionWhereThatIsWanted) {
  MedialOptions merging;
  merging.merge_crossings = true;
  for (const double angle : {90.0, 88.0, 80.0, 70.0, 60.0}) {
    const MedialObject object = medial_of(shapes::letter_x(14, radians(angle), 6), 0.06, merging);
    ASSERT_EQ(counts(object), (Counts{{"S", 4}, {"J", 1}, {"S-J", 4}})) << angle << " degrees";
    EXPECT_LT(norm(nearest_vertex(object, {0, 0}).point), 0.1) << angle << " degrees";
    EXPECT_LT(degrees(greatest_kink(object)), 12) << angle << " degrees";
  }
}

TEST(MedialObject, SharpCombOfFifteenTeeth) {
  const MedialObject object = exact_medial_of(shapes::comb(15, 10, 20, 40));
  EXPECT_EQ(object.edges.size(), 61u);
  EXPECT_EQ(counts(object), (Counts{{"C", 32}, {"J", 30}, {"C-J", 32}, {"J-J", 29}}));
}

TEST(MedialObject, RoundComb) {
  const MedialObject object = medial_of(shapes::comb(8, 12, 26, 30, 5), 0.06);
  EXPECT_EQ(counts(object), (Counts{{"S", 8}, {"J", 6}, {"S-J", 8}, {"J-J", 5}}));
}

TEST(MedialObject, GasketWithFortyHoles) {
  const MedialObject object = medial_of(shapes::gasket(), 0.06);
  EXPECT_EQ(object.loops, 41);
  const auto edges = static_cast<int>(object.edges.size()),
             vertices = static_cast<int>(object.vertices.size());
  EXPECT_EQ(edges - vertices + 1, 40);
  const Counts found = counts(object);
  EXPECT_EQ(found, (Counts{{"J", 78}, {"J-J", 117}}));
}

TEST(MedialObject, RingsAreOneClosedEdge) {
  const MedialObject concentric = medial_of(shapes::annulus(40, 28), 0.06);
  ASSERT_EQ(counts(concentric), (Counts{{"N", 1}}));
  const MedialEdge& edge = concentric.edges[0];
  EXPECT_EQ(edge.start, no_index);
  EXPECT_NEAR(edge.length, 2 * pi * 34, 0.1);
  EXPECT_NEAR(edge.thickness.mean, 12, 0.06);
  for (const MedialPoint& point : edge.points) EXPECT_NEAR(norm(point.point), 34, 0.01);
  EXPECT_LT(edge.points.front().point.x, -33.8) << "starts at the left";
  EXPECT_GT(cross(edge.points[0].point, edge.points[1].point), 0) << "counter-clockwise";

  // Centres equidistant from two circles lie on the ellipse with the circles' centres as foci.
  const MedialObject eccentric = medial_of(shapes::annulus(40, 20, {9, 4}), 0.06);
  ASSERT_EQ(counts(eccentric), (Counts{{"N", 1}}));
  for (const MedialPoint& point : eccentric.edges[0].points)
    EXPECT_NEAR(norm(point.point) + distance(point.point, {9, 4}), 60, 0.01);
}

TEST(MedialObject, EllipseIsASegmentBetweenTheCentresOfCurvature) {
  const double a = 50, b = 25, focus = a - b * b / a;
  const MedialObject object = medial_of(shapes::ellipse(a, b, 240, 0.37), 0.02);
  ASSERT_EQ(counts(object), (Counts{{"S", 2}, {"S-S", 1}}));
  for (const MedialPoint& point : object.edges[0].points) EXPECT_NEAR(point.point.y, 0, 0.01);
  EXPECT_LT(distance(nearest_vertex(object, {focus, 0}).point, {focus, 0}), 0.5);
  EXPECT_LT(distance(nearest_vertex(object, {-focus, 0}).point, {-focus, 0}), 0.5);
}

TEST(MedialObject, FullDiscIsIsolated) {
  const MedialObject object = medial_of(shapes::region_of({shapes::circle({3, 4}, 20, {})}, true), 0.06);
  ASSERT_EQ(counts(object), (Counts{{"isolated", 1}}));
  EXPECT_LT(distance(object.vertices[0].point, {3, 4}), 1e-3);
  EXPECT_NEAR(object.vertices[0].radius, 20, 0.06);
}

TEST(MedialObject, LoopFromAJunctionToItself) {
  // A ring with a tail: one junction, one loop edge, one arm.
  PlanarRegion region = shapes::region_of({{}, shapes::circle({0, 0}, 20, {})}, true);
  std::vector<Vec2>& outer = region.loops[0].points;
  const double half = std::asin(6.0 / 32);
  shapes::add_arc(outer, {0, 0}, 32, half, 2 * pi - 2 * half, {});
  shapes::add_line(outer, {32 * std::cos(half), -6}, {80, -6}, {});
  shapes::add_arc(outer, {80, 0}, 6, -pi / 2, pi, {});
  shapes::add_line(outer, {80, 6}, {32 * std::cos(half), 6}, {});
  region.loops[0].corner.clear();  // where the tail meets the ring there are two, seen from the angle
  const MedialObject object = medial_of(region, 0.06);
  ASSERT_EQ(counts(object), (Counts{{"S", 1}, {"J", 1}, {"S-J", 1}, {"J-J", 1}}));
  for (const MedialVertex& vertex : object.vertices)
    EXPECT_EQ(vertex.edges.size(), vertex.type == MedialVertexType::J ? 3u : 1u);
}

TEST(MedialObject, DoubleEdgeBetweenTwoJunctions) {
  PlanarRegion region = shapes::stadium(100, 14);
  region.loops.push_back({shapes::circle({50, 0}, 6, {}), {}, {}});
  region.loops[1].corner.assign(region.loops[1].points.size(), false);
  const MedialObject object = medial_of(region, 0.06);
  EXPECT_EQ(counts(object), (Counts{{"S", 2}, {"J", 2}, {"S-J", 2}, {"J-J", 2}}));
}

struct NamedShape {
  std::string name;
  std::function<PlanarRegion(double phase)> make;
};

std::vector<NamedShape> invariant_shapes() {
  const auto facetted = [](double phase) { return shapes::Facetting{2, 0.05, phase}; };
  return {{"stadium", [=](double p) { return shapes::stadium(104, 8, facetted(p)); }},
          {"taper", [=](double p) { return shapes::tapered_stadium(90, 14, 7, facetted(p)); }},
          {"T", [=](double p) { return shapes::letter_t(14, 6, facetted(p)); }},
          {"X", [=](double p) { return shapes::letter_x(14, radians(75), 6, facetted(p)); }},
          {"L", [=](double p) { return shapes::letter_l(14, 21, 7, facetted(p)); }},
          {"G", [=](double p) { return shapes::letter_g(12, facetted(p)); }},
          {"H", [=](double p) { return shapes::letter_h(14, 6, facetted(p)); }},
          {"comb", [=](double p) { return shapes::comb(8, 12, 26, 30, 5, facetted(p)); }},
          {"sharp comb", [=](double) { return shapes::comb(15, 10, 20, 40); }},
          {"rectangle", [=](double) { return shapes::rectangle(100, 20); }},
          {"ring", [=](double p) { return shapes::annulus(40, 28, {}, facetted(p)); }},
          {"gasket", [=](double p) { return shapes::gasket(facetted(p)); }}};
}

TEST(MedialObject, TopologyIsInvariant) {
  for (const NamedShape& shape : invariant_shapes()) {
    const PlanarRegion region = shape.make(0);
    const Counts expected = counts(medial_of(region, 0.06));
    const auto expect_same = [&](const PlanarRegion& changed, double scale, const std::string& what) {
      EXPECT_EQ(counts(medial_of(changed, 0.12 * scale)), expected) << shape.name << ", " << what;
    };
    for (const double angle : {0.1, 0.7, 1.5707963267948966, 2.9})
      expect_same(shapes::rotated(region, angle), 1, "rotated");
    expect_same(shapes::translated(region, {1e5, -1e5}), 1, "translated");
    expect_same(shapes::scaled(region, 1e-3), 1e-3, "small");
    expect_same(shapes::scaled(region, 1e3), 1e3, "large");
    expect_same(shapes::reversed(region), 1, "reversed");
    expect_same(shapes::shifted(region, 17), 1, "shifted start");
    for (const double phase : {0.2, 0.5, 0.9}) expect_same(shape.make(phase), 1, "sampling phase");
    PlanarRegion reordered = region;
    std::reverse(reordered.loops.begin(), reordered.loops.end());
    expect_same(reordered, 1, "loop order");
  }
}

TEST(MedialObject, TopologySurvivesNoise) {
  for (const NamedShape& shape : invariant_shapes()) {
    if (shape.name == "sharp comb" || shape.name == "rectangle")
      continue;  // no points between the corners to move
    const Counts expected = counts(medial_of(shape.make(0), 0.06));
    for (const double amplitude : {0.005, 0.01, 0.02})
      for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const PlanarRegion region =
            shapes::rotated(shapes::noisy(shape.make(0.1 * seed), amplitude, seed), 0.4 * seed);
        EXPECT_EQ(counts(medial_of(region, 0.06 + 4 * amplitude)), expected)
            << shape.name << ", amplitude " << amplitude << ", seed " << seed;
      }
  }
}

TEST(MedialObject, DenseNoisySamplesGiveNoSpikes) {
  const PlanarRegion region = shapes::noisy(shapes::stadium(180, 10, {0.25, 0.01, 0}), 0.01, 7);
  EXPECT_EQ(counts(medial_of(region, 0.1)), (Counts{{"S", 2}, {"S-S", 1}}));
}

TEST(MedialObject, SameInputSameBits) {
  const PlanarRegion region = checked(shapes::gasket());
  const auto a = medial_object(region), b = medial_object(region);
  ASSERT_TRUE(a && b);
  ASSERT_EQ(a->edges.size(), b->edges.size());
  for (std::size_t e = 0; e < a->edges.size(); ++e)
    for (std::size_t i = 0; i < a->edges[e].points.size(); ++i)
      EXPECT_EQ(a->edges[e].points[i].point, b->edges[e].points[i].point);
}

TEST(MedialObject, EmptyRegionFails) {
  const auto object = medial_object({});
  ASSERT_FALSE(object);
  EXPECT_EQ(object.error().code, "medial.region.empty");
}

TEST(MedialObject, BadLoopFailsOrIsVerified) {
  for (const auto& points :
       std::vector<std::vector<Vec2>>{{{0, 0}, {1, 0}}, {{0, 0}, {1, 0}, {1, 0}, {0, 1}}, {{0, 0}}})
    EXPECT_FALSE(medial_object(shapes::region_of({points})));
}

MedialEdge& bar_of(MedialObject& object) {
  return *std::find_if(object.edges.begin(), object.edges.end(),
                       [](const MedialEdge& edge) { return edge.type == MedialEdgeType::JJ; });
}

TEST(VerifyMedialObject, SeesWhatIsWrong) {
  const PlanarRegion region = checked(shapes::rectangle(100, 20));
  const auto good = medial_object(region);
  ASSERT_TRUE(good);
  const double tolerance = 1e-8;
  EXPECT_TRUE(verify_medial_object(*good, region, tolerance).empty());
  const auto expect_seen = [&](const char* what, auto spoil) {
    MedialObject bad = *good;
    spoil(bad);
    EXPECT_FALSE(verify_medial_object(bad, region, tolerance).empty()) << what;
  };
  expect_seen("point", [](MedialObject& o) { bar_of(o).points[1].point.x += 1e-3; });
  expect_seen("radius", [](MedialObject& o) { o.vertices[0].radius += 1e-3; });
  expect_seen("vertex type", [](MedialObject& o) { o.vertices[0].type = MedialVertexType::isolated; });
  expect_seen("edge type", [](MedialObject& o) { o.edges[0].type = MedialEdgeType::SS; });
  expect_seen("edge left out", [](MedialObject& o) { o.edges.pop_back(); });
  expect_seen("incidence", [](MedialObject& o) { std::swap(o.vertices[0].edges, o.vertices[1].edges); });
  expect_seen("foot", [](MedialObject& o) { bar_of(o).points[1].feet[0].position += 1; });
  expect_seen("sides",
              [](MedialObject& o) { std::swap(bar_of(o).points[1].feet[0], bar_of(o).points[1].feet[1]); });
  expect_seen("length", [](MedialObject& o) { bar_of(o).length *= 2; });
}

TEST(PointAt, FollowsTheEdge) {
  const MedialObject object = exact_medial_of(shapes::rectangle(100, 20));
  for (const MedialEdge& edge : object.edges) {
    if (edge.type != MedialEdgeType::JJ) continue;
    const double towards = edge.points.front().point.x < 50 ? 1 : -1;
    EXPECT_NEAR(point_at(edge, 30).point.x, 50 - towards * 10, 1e-9);
    EXPECT_NEAR(point_at(edge, 30).radius, 10, 1e-9);
    EXPECT_NEAR(point_at(edge, 30).feet[0].point.x, 50 - towards * 10, 1e-6);
    EXPECT_EQ(point_at(edge, -1).point, edge.points.front().point);
    EXPECT_EQ(point_at(edge, 1000).point, edge.points.back().point);
  }
}

TEST(PointAt, WrapsAroundAClosedEdge) {
  const MedialObject object = medial_of(shapes::annulus(40, 28), 0.06);
  const MedialEdge& edge = object.edges.at(0);
  EXPECT_LT(distance(point_at(edge, 10).point, point_at(edge, 10 + edge.length).point), 1e-9);
  EXPECT_LT(distance(point_at(edge, -5).point, point_at(edge, edge.length - 5).point), 1e-9);
}

TEST(Names, AreThoseOfThePaper) {
  EXPECT_EQ(name_of(MedialVertexType::J), "J");
  EXPECT_EQ(name_of(MedialVertexType::isolated), "isolated");
  EXPECT_EQ(name_of(MedialEdgeType::SC), "S-C");
  EXPECT_EQ(name_of(MedialEdgeType::N), "N");
}

/// A smooth star-like outline of a few random harmonics, with round holes that stay clear of it and each
/// other.
PlanarRegion random_smooth_region() {
  const double a2 = *rc::gen::inRange(-25, 25), a3 = *rc::gen::inRange(-15, 15),
               turn = *rc::gen::inRange(0, 628);
  const int points = *rc::gen::inRange(60, 200), holes = *rc::gen::inRange(0, 5);
  std::vector<std::vector<Vec2>> loops(1);
  for (int i = 0; i < points; ++i) {
    const double t = 2 * pi * i / points;
    const double r = 100 + a2 * std::cos(2 * t) + a3 * std::cos(3 * t + turn / 100);
    loops[0].push_back({r * std::cos(t), r * std::sin(t)});
  }
  for (int k = 0; k < holes; ++k) {
    const double t = 2 * pi * k / holes + turn / 100, r = *rc::gen::inRange(5, 14);
    loops.push_back(shapes::circle({32 * std::cos(t), 32 * std::sin(t)}, r, {}));
  }
  return shapes::region_of(loops, true);
}

/// A polygon, star-like about the origin, with square holes.
PlanarRegion random_polygon() {
  const int n = *rc::gen::inRange(3, 14), holes = *rc::gen::inRange(0, 4);
  std::vector<std::vector<Vec2>> loops(1);
  for (int i = 0; i < n; ++i) {
    const double t = 2 * pi * (i + *rc::gen::inRange(0, 60) / 100.0) / n, r = *rc::gen::inRange(100, 240);
    loops[0].push_back({r * std::cos(t), r * std::sin(t)});
  }
  for (int k = 0; k < holes && n >= 6; ++k) {
    const double t = 2 * pi * k / holes, s = *rc::gen::inRange(3, 9);
    const Vec2 c{20 * std::cos(t), 20 * std::sin(t)};
    loops.push_back({c + Vec2{-s, -s}, c + Vec2{s, -s + 1}, c + Vec2{s - 1, s}, c + Vec2{-s, s}});
  }
  PlanarRegion region = shapes::region_of(loops);
  for (PlanarLoop& loop : region.loops) loop.corner.assign(loop.points.size(), true);
  return region;
}

RC_GTEST_PROP(MedialObjectProperty, SmoothRegionsVerify, ()) {
  const auto region = checked_region(random_smooth_region());
  RC_PRE(region.has_value());
  const auto object = medial_object(*region);
  RC_ASSERT(object.has_value());
  const auto violations =
      verify_medial_object(*object, *region, 0.6);  // sagitta of 60 facets on a radius of 140
  if (!violations.empty()) RC_FAIL(violations.front());
}

RC_GTEST_PROP(MedialObjectProperty, PolygonsVerify, ()) {
  const auto region = checked_region(random_polygon());
  RC_PRE(region.has_value());
  const auto object = medial_object(*region);
  RC_ASSERT(object.has_value());
  const auto violations = verify_medial_object(*object, *region, 1e-9 * diagonal(*region));
  if (!violations.empty()) RC_FAIL(violations.front());
}

}  // namespace
}  // namespace beadmesh
