#include "beadmesh/flatten/rigid_layout.h"

#include <gtest/gtest.h>

#include "flatten/facet_shapes.h"

namespace beadmesh {
namespace {

std::vector<RestTriangle> rest_of(const Facets& facets) {
  std::vector<RestTriangle> rest;
  for (std::size_t t = 0; t < facets.triangles.size(); ++t)
    rest.push_back(rest_triangle(facets, static_cast<Index>(t)));
  return rest;
}

std::vector<Vec2> plan(const Facets& facets) {
  std::vector<Vec2> positions;
  for (const Vec3 p : facets.points) positions.push_back({p.x, p.y});
  return positions;
}

TEST(RigidLayout, LeavesAnIsometricLayoutAlone) {
  const Facets facets = shapes::sheet(9, 5, [](double s, double t) { return Vec3{30 * s, 7 * t * t, 0}; });
  const RigidLayout layout(facets.points.size(), facets.triangles, rest_of(facets));
  ASSERT_TRUE(layout.is_ready());
  double energy = 1;
  layout.rotations(plan(facets), &energy);
  EXPECT_NEAR(energy, 0, 1e-9);
  const std::vector<Vec2> relaxed = layout.relaxed(plan(facets), 20, 1e-12);
  for (std::size_t v = 0; v < relaxed.size(); ++v)
    EXPECT_NEAR(norm(relaxed[v] - (plan(facets)[v] - plan(facets)[0])), 0, 1e-9);
}

TEST(RigidLayout, StraightensABentStrip) {
  // Twelve times as long as wide, bent in the plane to a quarter circle.
  const Facets facets = shapes::sheet(96, 8, [](double s, double t) { return Vec3{192 * s, 16 * t, 0}; });
  std::vector<Vec2> bent;
  for (const Vec3 p : facets.points) {
    const double r = 192 / (pi / 2) + 8 - p.y, angle = p.x / 192 * pi / 2;
    bent.push_back({r * std::sin(angle), -r * std::cos(angle)});
  }
  const RigidLayout layout(facets.points.size(), facets.triangles, rest_of(facets));
  const std::vector<Vec2> relaxed = layout.relaxed(bent, 300, 1e-6);
  double energy = 1;
  layout.rotations(relaxed, &energy);
  EXPECT_NEAR(energy, 0, 1e-3);
  EXPECT_NEAR(distance(relaxed.front(), relaxed.back()), std::hypot(192, 16), 1e-2);
}

TEST(RigidLayout, WithoutFlipsNoneTurnsOver) {
  const Facets facets = shapes::stadium_dome(60, 16, 12);
  std::vector<Vec2> start = plan(facets);
  const RigidLayout layout(facets.points.size(), facets.triangles, rest_of(facets));
  for (const Vec2 p : layout.relaxed_without_flips(start, 30, 1e-6)) EXPECT_TRUE(std::isfinite(p.x + p.y));
  const std::vector<Vec2> relaxed = layout.relaxed_without_flips(start, 30, 1e-6);
  for (const Triangle& t : facets.triangles)
    EXPECT_GT(doubled_area(relaxed[t[0]], relaxed[t[1]], relaxed[t[2]]), 0);
}

}  // namespace
}  // namespace beadmesh
