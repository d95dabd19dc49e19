// Our medial object of polygons against the medial axis in Boost.Polygon's segment Voronoi diagram.
#include "beadmesh/medial/medial_object.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "boost_axis.h"
#include "random_domains.h"

namespace beadmesh::oracle {
namespace {

constexpr int grid_bits = 28;

struct Deviations {
  double ours_to_theirs = 0;  ///< greatest distance of our points from their arcs, over the size
  double theirs_to_ours = 0;  ///< greatest distance of points of their arcs from ours, over the size
};

double distance_to_ours(const MedialObject& object, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (const MedialEdge& edge : object.edges) {
    const std::size_t n = edge.points.size(), steps = edge.type == MedialEdgeType::N ? n : n - 1;
    for (std::size_t i = 0; i < steps; ++i) {
      const Vec2 a = edge.points[i].point, d = edge.points[(i + 1) % n].point - a;
      const double length2 = dot(d, d), t = length2 > 0 ? std::clamp(dot(p - a, d) / length2, 0.0, 1.0) : 0;
      least = std::min(least, distance(p, a + d * t));
    }
  }
  return least;
}

Deviations deviations(const MedialObject& object, const std::vector<AxisArc>& arcs) {
  Deviations result;
  for (const MedialEdge& edge : object.edges)
    for (const MedialPoint& point : edge.points) {
      double least = std::numeric_limits<double>::infinity();
      for (const AxisArc& arc : arcs) least = std::min(least, arc.distance_to(point.point));
      result.ours_to_theirs = std::max(result.ours_to_theirs, least / object.size);
    }
  for (const AxisArc& arc : arcs)
    for (int i = 0; i <= 16; ++i)
      result.theirs_to_ours =
          std::max(result.theirs_to_ours, distance_to_ours(object, arc.at(i / 16.0)) / object.size);
  return result;
}

/// Every point of the polygon is a corner: Boost knows no smooth boundary.
void expect_same_axis(PlanarRegion polygon) {
  for (PlanarLoop& loop : polygon.loops) loop.corner.assign(loop.points.size(), true);
  const auto region = checked_region(std::move(polygon));
  ASSERT_TRUE(region) << to_line(region.error());
  const auto object = medial_object(*region);
  ASSERT_TRUE(object) << to_line(object.error());
  const std::vector<AxisArc> arcs = boost_axis(*region);
  ASSERT_FALSE(arcs.empty());
  const Deviations found = deviations(*object, arcs);
  EXPECT_LE(found.ours_to_theirs, 1e-7);
  EXPECT_LE(found.theirs_to_ours, 1e-7) << "the chords between our points are part of the deviation";
}

TEST(MedialObjectOracle, letters) {
  for (const NamedRegion& letter : letters())
    for (const double angle : {0.0, 0.3, 1.1}) {
      SCOPED_TRACE(letter.name + " turned by " + std::to_string(angle));
      expect_same_axis(on_grid(letter.region, angle, grid_bits));
    }
}

TEST(MedialObjectOracle, random_polygons) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    expect_same_axis(on_grid(random_region(seed, 4 + static_cast<int>(seed)), 0, grid_bits));
  }
}

TEST(MedialObjectOracle, the_comparison_notices_a_missing_edge) {
  auto region = checked_region(on_grid(letters()[1].region, 0.3, grid_bits));
  ASSERT_TRUE(region);
  auto object = medial_object(*region);
  ASSERT_TRUE(object);
  const std::vector<AxisArc> arcs = boost_axis(*region);
  object->edges.pop_back();
  EXPECT_GT(deviations(*object, arcs).theirs_to_ours, 1e-3);
}

}  // namespace
}  // namespace beadmesh::oracle
