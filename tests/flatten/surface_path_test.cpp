#include "beadmesh/flatten/surface_path.h"

#include <gtest/gtest.h>

#include <cmath>

#include "flatten/facet_shapes.h"

namespace beadmesh {
namespace {

using namespace shapes;

double length(const Facets& facets, const std::vector<PathStop>& way) {
  const auto point = [&](const PathStop& s) {
    return lerp(facets.points[s.from], facets.points[s.to], s.at);
  };
  double sum = 0;
  for (std::size_t i = 1; i < way.size(); ++i) sum += distance(point(way[i - 1]), point(way[i]));
  return sum;
}

Index vertex_nearest(const Facets& facets, Vec3 p) {
  Index best = 0;
  for (Index v = 0; v < static_cast<Index>(facets.points.size()); ++v)
    if (distance(facets.points[v], p) < distance(facets.points[best], p)) best = v;
  return best;
}

TEST(SurfacePath, StraightAcrossAPlaneAgainstTheGrain) {
  const Facets plane = sheet(14, 9, [](double s, double t) { return Vec3{50 * s, 30 * t, 0}; });
  for (const Vec3 end : {Vec3{50, 30, 0}, Vec3{0, 30, 0}, Vec3{50, 12, 0}}) {
    const Vec3 start = end.x > 0 ? Vec3{0, 0, 0} : Vec3{50, 0, 0};
    const auto way = shortest_path(plane, {vertex_nearest(plane, start)}, {vertex_nearest(plane, end)});
    ASSERT_GE(way.size(), 2);
    EXPECT_TRUE(way.front().is_vertex() && way.back().is_vertex());
    const double exact = distance(start, plane.points[way.back().from]);
    EXPECT_LT(length(plane, way), 1.005 * exact);
  }
}

TEST(SurfacePath, ScrewLineOnACylinder) {
  const Facets part = cylinder(10, 2, 20);
  const Index from = vertex_nearest(part, {10 * std::sin(-1), 0, 10 * std::cos(-1)}),
              to = vertex_nearest(part, {10 * std::sin(1), 20, 10 * std::cos(1)});
  const auto way = shortest_path(part, {from}, {to});
  EXPECT_NEAR(length(part, way), std::hypot(20, 20), 0.1);
}

TEST(SurfacePath, NoWayIsEmpty) {
  Facets two = sheet(2, 1, [](double s, double t) { return Vec3{s, t, 0}; });
  two.points.push_back({5, 5, 5});
  EXPECT_TRUE(shortest_path(two, {0}, {static_cast<Index>(two.points.size()) - 1}).empty());
}

TEST(SurfacePath, FarthestVertexOfASheetIsTheOppositeCorner) {
  const Facets plane = sheet(14, 9, [](double s, double t) { return Vec3{50 * s, 30 * t, 0}; });
  const Index corner = vertex_nearest(plane, {0, 30, 0});
  EXPECT_EQ(farthest_vertex(plane, {vertex_nearest(plane, {50, 0, 0})}), corner);
}

}  // namespace
}  // namespace beadmesh
