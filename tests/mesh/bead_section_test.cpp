#include "beadmesh/mesh/bead_section.h"

#include <gtest/gtest.h>

#include <cmath>

namespace beadmesh {
namespace {

/// Half a cylinder of radius 10 along y, unrolled: flat x is the arc length.
struct HalfCylinder {
  static constexpr double radius = 10;
  Facets facets;
  FlatFace flat;
  Skeleton crest;

  HalfCylinder() {
    constexpr int pieces = 400;
    for (int i = 0; i <= pieces; ++i)
      for (const double y : {0.0, 50.0}) {
        const double angle = pi * i / pieces;
        facets.points.push_back({-radius * std::cos(angle), y, radius * std::sin(angle)});
        flat.positions.push_back({radius * (angle - pi / 2), y});
      }
    for (Index i = 0; i < 2 * pieces; i += 2) {
      facets.triangles.push_back({i, i + 2, i + 1});
      facets.triangles.push_back({i + 1, i + 2, i + 3});
    }
    facets.triangle_surface.assign(facets.triangles.size(), 0);
    SkeletonArm arm;
    for (double y = 5; y <= 45; y += 5) {
      MedialPoint p;
      p.point = {0, y};
      p.radius = radius * pi / 2;
      p.subtended_angle = pi;
      p.feet[0].point = {-radius * pi / 2, y};
      p.feet[1].point = {radius * pi / 2, y};
      arm.points.push_back(p);
    }
    crest.arms.push_back(arm);
  }
};

TEST(BeadSection, OfAHalfCircleIsTheSagittaOfItsChords) {
  const HalfCylinder bead;
  const SurfaceMap map(bead.facets, bead.flat);
  for (const int m : {2, 4, 6, 8}) {
    const double sagitta = HalfCylinder::radius * (1 - std::cos(pi / m / 2));
    // The greatest of 25 places on half the section.
    EXPECT_NEAR(section_deviation(bead.crest, map, m), sagitta, 0.03 * sagitta + 0.002) << m;
  }
}

TEST(BeadSection, WithoutTouchingLinesAcrossThereIsNone) {
  HalfCylinder bead;
  const SurfaceMap map(bead.facets, bead.flat);
  for (MedialPoint& p : bead.crest.arms[0].points) p.subtended_angle = radians(120);
  EXPECT_EQ(section_deviation(bead.crest, map, 2), 0);
  EXPECT_EQ(section_deviation({}, map, 2), 0);
}

}  // namespace
}  // namespace beadmesh
