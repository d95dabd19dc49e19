#include "beadmesh/medial/medial_query.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace beadmesh {
namespace {

MedialObject object_of(std::vector<std::vector<Vec2>> loops) {
  PlanarRegion region;
  for (auto& points : loops) {
    PlanarLoop loop;
    loop.points = std::move(points);
    region.loops.push_back(std::move(loop));
  }
  auto checked = checked_region(std::move(region));
  EXPECT_TRUE(checked);
  auto object = medial_object(*checked);
  EXPECT_TRUE(object);
  return std::move(*object);
}

/// 100 x 20 with corners at the origin: the axis runs along y = 10 from x = 10 to 90, and into the corners.
const MedialObject& rectangle() {
  static const MedialObject object = object_of({{{0, 0}, {100, 0}, {100, 20}, {0, 20}}});
  return object;
}

std::vector<Vec2> circle(double radius, int count) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i)
    points.push_back(Vec2{std::cos(2 * pi * i / count), std::sin(2 * pi * i / count)} * radius);
  return points;
}

/// A comb: three teeth on a back, two holes in it.
const MedialObject& comb() {
  static const MedialObject object = object_of({{{0, 0},
                                                 {120, 0},
                                                 {120, 60},
                                                 {100, 60},
                                                 {100, 20},
                                                 {70, 20},
                                                 {70, 55},
                                                 {50, 55},
                                                 {50, 20},
                                                 {20, 20},
                                                 {20, 70},
                                                 {0, 70}},
                                                {{30, 6}, {40, 6}, {40, 14}, {30, 14}},
                                                {{80, 5}, {90, 8}, {86, 15}}});
  return object;
}

Index vertex_near(const MedialObject& object, Vec2 p) {
  Index best = 0;
  for (Index v = 0; v < static_cast<Index>(object.vertices.size()); ++v)
    if (distance(object.vertices[v].point, p) < distance(object.vertices[best].point, p)) best = v;
  EXPECT_LT(distance(object.vertices[best].point, p), 0.5);
  return best;
}

TEST(MedialQuery, NearestAxisOfARectangle) {
  const MedialQuery query(rectangle());
  const auto near = query.nearest({40, 3});
  ASSERT_TRUE(near);
  EXPECT_NEAR(near->gap, 7, 1e-6);
  EXPECT_NEAR(distance(near->place.point, {40, 10}), 0, 1e-6);
  EXPECT_NEAR(near->place.radius, 10, 1e-6);
  const MedialPoint there = point_at(rectangle().edges[near->place.edge], near->place.distance);
  EXPECT_NEAR(distance(there.point, near->place.point), 0, 1e-9) << "edge and distance say the same place";
}

TEST(MedialQuery, ThicknessIsThatOfTheLargestDiscThatHoldsThePoint) {
  const MedialQuery query(rectangle());
  for (const Vec2 p : {Vec2{50, 10}, Vec2{50, 0.5}, Vec2{12, 19}, Vec2{3.5, 10}})
    EXPECT_NEAR(query.thickness_at(p)->thickness, 20, 1e-4) << p.x << " " << p.y;
  // The disc with centre (s, s) and radius s holds (c, c) from s = c / (1 - sqrt(1/2)) on.
  EXPECT_NEAR(query.thickness_at({1, 1})->thickness, 2 / (1 - std::sqrt(0.5)), 1e-3);
  EXPECT_EQ(query.thickness_at({1, 1})->outside, 0);
}

TEST(MedialQuery, PointsOutsideAreSaidToBe) {
  const MedialQuery query(rectangle());
  const auto outside = query.thickness_at({50, 25});
  ASSERT_TRUE(outside);
  EXPECT_NEAR(outside->outside, 5, 1e-4);
  EXPECT_NEAR(outside->thickness, 20, 1e-4);
  const auto at_corner = query.thickness_at({-3, -4});
  EXPECT_NEAR(at_corner->outside, 5, 1e-4);
  EXPECT_NEAR(at_corner->thickness, 0, 1e-4);
}

TEST(MedialQuery, RingAndFullDisc) {
  const MedialObject ring = object_of({circle(30, 96), circle(20, 96)});
  const MedialQuery of_ring(ring);
  const auto near = of_ring.nearest({0, -29});
  EXPECT_NEAR(near->gap, 4, 0.05);
  EXPECT_NEAR(of_ring.thickness_at({21, 0})->thickness, 10, 0.05);

  const MedialObject disc = object_of({circle(30, 96)});
  ASSERT_EQ(disc.vertices.size(), 1);
  const MedialQuery of_disc(disc);
  EXPECT_EQ(of_disc.nearest({3, 4})->place.edge, no_index);
  EXPECT_EQ(of_disc.nearest({3, 4})->place.vertex, 0);
  EXPECT_NEAR(of_disc.nearest({3, 4})->gap, 5, 0.05);
  EXPECT_NEAR(of_disc.thickness_at({29, 0})->thickness, 60, 0.1);
}

TEST(MedialQuery, NothingOfNothing) {
  const MedialObject empty;
  EXPECT_FALSE(MedialQuery(empty).nearest({0, 0}));
  EXPECT_FALSE(MedialQuery(empty).thickness_at({0, 0}));
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(MedialQuery(rectangle()).nearest({none, 0}));
  EXPECT_FALSE(MedialQuery(rectangle()).thickness_at({0, none}));
}

RC_GTEST_PROP(MedialQuery, AgreesWithBruteForce, ()) {
  const MedialObject& object = comb();
  static const MedialQuery query(comb());
  const Vec2 p{*rc::gen::inRange(-500, 1700) * 0.1, *rc::gen::inRange(-500, 1200) * 0.1};
  double gap = 1e9, thickness = 0;
  for (const MedialEdge& edge : object.edges)
    for (int i = 0; i <= 2000; ++i) {
      const MedialPoint at = point_at(edge, edge.length * i / 2000);
      gap = std::min(gap, distance(at.point, p));
      if (distance(at.point, p) <= at.radius) thickness = std::max(thickness, 2 * at.radius);
    }
  RC_ASSERT(std::abs(query.nearest(p)->gap - gap) < 0.05);
  const auto local = query.thickness_at(p);
  // What the samples of the axis find is a bound from below: a disc between two of them may hold p and be
  // larger.
  if (thickness > 0) {
    RC_ASSERT(local->outside == 0);
    RC_ASSERT(local->thickness > thickness - 1e-9);
    RC_ASSERT(query.nearest(local->disc.point)->gap < 1e-9);
    RC_ASSERT(distance(local->disc.point, p) <= local->disc.radius + 1e-9);
  } else {
    // Near a corner, or on a wall, where only a disc between two samples touches.
    RC_ASSERT(local->outside > 0 || local->thickness < 0.5 ||
              distance(local->disc.point, p) > local->disc.radius - 0.01);
  }
}

TEST(MedialWalk, DeparturesRunCounterClockwise) {
  const MedialObject& object = comb();
  for (Index v = 0; v < static_cast<Index>(object.vertices.size()); ++v) {
    const std::vector<Departure> ways = departures(object, v);
    ASSERT_EQ(ways.size(), object.vertices[v].edges.size());
    ASSERT_FALSE(ways.empty());
    EXPECT_EQ(ways[0].edge, object.vertices[v].edges[0]);
    double turn = 0;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      const auto out = [&](Departure way) {
        return point_along(object, way, 0.01 * object.edges[way.edge].length).point -
               object.vertices[v].point;
      };
      const Vec2 a = out(ways[i]), b = out(ways[(i + 1) % ways.size()]);
      const double angle = std::atan2(cross(a, b), dot(a, b));
      turn += angle > 0 || ways.size() == 1 ? angle : angle + 2 * pi;
    }
    EXPECT_NEAR(turn, ways.size() > 1 ? 2 * pi : 0, 1e-6) << "once round, vertex " << v;
  }
}

TEST(MedialWalk, EndsAndArrivals) {
  const MedialObject& object = rectangle();
  const Index left = vertex_near(object, {10, 10}), right = vertex_near(object, {90, 10});
  int middle = 0;
  for (const Departure way : departures(object, left)) {
    EXPECT_EQ(other_end(object, way.edge, left), arrival(object, way));
    if (arrival(object, way) != right) continue;
    ++middle;
    EXPECT_NEAR(distance(point_along(object, way, 25).point, {35, 10}), 0, 1e-6);
    EXPECT_NEAR(distance(point_along(object, {way.edge, !way.forward}, 25).point, {65, 10}), 0, 1e-6);
  }
  EXPECT_EQ(middle, 1);
  const Index corner = vertex_near(object, {0, 0});
  EXPECT_EQ(other_end(object, departures(object, corner)[0].edge, right), no_index);
}

TEST(MedialWalk, BackwardsLeftAndRightChangePlaces) {
  const MedialObject& object = rectangle();
  const Index left = vertex_near(object, {10, 10}), right = vertex_near(object, {90, 10});
  const Departure way = path_between(object, left, right).front(), back{way.edge, !way.forward};
  EXPECT_NEAR(point_along(object, way, 30).feet[0].point.y, 20, 1e-6) << "left of +x";
  EXPECT_NEAR(point_along(object, back, 30).feet[0].point.y, 0, 1e-6) << "left of -x";
}

TEST(MedialWalk, PathBetweenCornersOfARectangle) {
  const MedialObject& object = rectangle();
  const Index from = vertex_near(object, {0, 0}), to = vertex_near(object, {100, 20});
  const std::vector<Departure> path = path_between(object, from, to);
  ASSERT_EQ(path.size(), 3);
  EXPECT_NEAR(total_length(object, path), 80 + 2 * std::sqrt(200), 1e-4);
  EXPECT_NEAR(total_length(object), 80 + 4 * std::sqrt(200), 1e-4);
  Index at = from;
  for (const Departure way : path) {
    EXPECT_EQ(arrival(object, {way.edge, !way.forward}), at);
    at = arrival(object, way);
  }
  EXPECT_EQ(at, to);
  EXPECT_TRUE(path_between(object, to, to).empty());
}

TEST(MedialWalk, EvenPoints) {
  const MedialObject& object = rectangle();
  const Index left = vertex_near(object, {10, 10}), right = vertex_near(object, {90, 10});
  const MedialEdge& middle = object.edges[path_between(object, left, right).front().edge];
  const std::vector<MedialPoint> points = even_points(middle, 5);
  ASSERT_EQ(points.size(), 5);
  for (std::size_t i = 1; i < points.size(); ++i)
    EXPECT_NEAR(distance(points[i].point, points[i - 1].point), 20, 1e-6);
  EXPECT_EQ(even_points(middle, 1).size(), 1);
  EXPECT_NEAR(even_points(middle, 1)[0].point.x, 50, 1e-6);

  const MedialObject ring = object_of({circle(30, 96), circle(20, 96)});
  const std::vector<MedialPoint> around = even_points(ring.edges[0], 4);
  ASSERT_EQ(around.size(), 4);
  EXPECT_NEAR(distance(around[3].point, around[0].point), 25 * std::sqrt(2), 0.1);
}

}  // namespace
}  // namespace beadmesh
