#include "beadmesh/flatten/flat_face.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "beadmesh/flatten/triangle_geometry.h"
#include "flatten/facet_shapes.h"

namespace beadmesh {
namespace {

double greatest_length_error(const Facets& facets, const FlatFace& flat) {
  double worst = 0;
  for (const Triangle& t : facets.triangles)
    for (int k = 0; k < 3; ++k) {
      const Index a = t[k], b = t[(k + 1) % 3];
      worst = std::max(worst, std::abs(distance(facets.points[a], facets.points[b]) -
                                       distance(flat.positions[a], flat.positions[b])));
    }
  return worst;
}

void expect_no_flips(const Facets& facets, const FlatFace& flat) {
  for (const Triangle& t : facets.triangles)
    ASSERT_GT(doubled_area(flat.positions[t[0]], flat.positions[t[1]], flat.positions[t[2]]), 0);
}

TEST(Flatten, PlaneSheetKeepsItsCoordinates) {
  const Facets facets = shapes::sheet(7, 5, [](double s, double t) {
    return Vec3{100 + 40 * s, 30 * t * t - 7, 12};
  });
  const auto flat = flatten(facets);
  ASSERT_TRUE(flat);
  for (std::size_t v = 0; v < facets.points.size(); ++v) {
    EXPECT_EQ(flat->positions[v].x, facets.points[v].x);
    EXPECT_EQ(flat->positions[v].y, facets.points[v].y);
  }
  EXPECT_NEAR(flat->distortion.max_ratio, 1, 1e-12);
}

RC_GTEST_PROP(Flatten, AnyPlaneIsCopiedIsometrically, ()) {
  const double turn = *rc::gen::inRange(0, 360) * pi / 180, tilt = *rc::gen::inRange(0, 360) * pi / 180;
  Facets facets = shapes::sheet(6, 4, [](double s, double t) { return Vec3{50 * s, 20 * t + 9 * s * s, 3}; });
  facets = shapes::turned(shapes::turned(facets, {0, 0, 1}, turn), {1, 0, 0}, tilt);
  const auto flat = flatten(facets);
  RC_ASSERT(flat.has_value());
  RC_ASSERT(greatest_length_error(facets, *flat) < 1e-10);
  for (const Triangle& t : facets.triangles)
    RC_ASSERT(doubled_area(flat->positions[t[0]], flat->positions[t[1]], flat->positions[t[2]]) > 0);
}

TEST(Flatten, PartsOfACylinderBecomeRectangles) {
  for (const double angle : {pi / 2, pi, 1.5 * pi, 2 * pi}) {  // 2 pi: cut at the seam
    const Index columns = 48;
    const Facets facets = shapes::cylinder(25, angle, 80, columns, 20);
    const auto flat = flatten(facets);
    ASSERT_TRUE(flat) << flat.error().message;
    EXPECT_LT(greatest_length_error(facets, *flat), 1e-6) << angle;
    expect_no_flips(facets, *flat);
    const double width = columns * 2 * 25 * std::sin(angle / columns / 2);
    double most = 0;
    for (const Vec2 p : flat->positions)
      for (const Vec2 q : flat->positions) most = std::max(most, distance(p, q));
    EXPECT_NEAR(most, std::hypot(width, 80), 1e-5) << angle;
  }
}

TEST(Flatten, CylinderLiesOverItsProjection) {
  const Facets facets = shapes::cylinder(25, 1.0, 80);
  const auto flat = flatten(facets);
  ASSERT_TRUE(flat);
  for (std::size_t v = 0; v < facets.points.size(); ++v) {
    EXPECT_NEAR(flat->positions[v].y, facets.points[v].y, 1e-5);
    EXPECT_NEAR(flat->positions[v].x, 25 * std::atan2(facets.points[v].x, facets.points[v].z), 0.02);
  }
}

TEST(Flatten, ConePatchIsIsometric) {
  const double slope = 0.6;  // half opening angle
  const Facets facets = shapes::sheet(40, 12, [&](double s, double t) {
    const double along = 20 + 50 * t, a = (s - 0.5) * 4;
    return Vec3{along * std::sin(slope) * std::cos(a), along * std::sin(slope) * std::sin(a),
                along * std::cos(slope)};
  });
  const auto flat = flatten(facets);
  ASSERT_TRUE(flat) << flat.error().message;
  EXPECT_LT(greatest_length_error(facets, *flat), 1e-2);  // the facets of a cone do not unroll exactly
  EXPECT_LT(flat->distortion.max_ratio, 1.002);
}

TEST(Flatten, SphericalCapIsSymmetricAndLittleDistorted) {
  const double r = 50, reach = 0.6;
  const Facets facets = shapes::sheet(48, 48, [&](double s, double t) {
    const double x = 2 * s - 1, y = 2 * t - 1;  // square to disc
    const double u = x * std::sqrt(1 - y * y / 2), v = y * std::sqrt(1 - x * x / 2),
                 a = reach * std::hypot(u, v);
    const double c = a > 0 ? r * std::sin(a) / std::hypot(u, v) : 0;
    return Vec3{c * u, c * v, r * std::cos(a)};
  });
  const auto flat = flatten(facets);
  ASSERT_TRUE(flat) << flat.error().message;
  EXPECT_LT(flat->distortion.max_ratio, 1.15);
  EXPECT_LT(flat->distortion.max_stretch, 1.12);
  EXPECT_LE(flat->distortion.mean_stretch, flat->distortion.max_stretch);
  EXPECT_GT(flat->distortion.max_ratio, 1.01);  // a sphere is not developable
  double low = 1e9, high = 0;
  for (const Index v : facets.loops[0]) {
    low = std::min(low, norm(flat->positions[v]));
    high = std::max(high, norm(flat->positions[v]));
  }
  EXPECT_NEAR(low, high, 0.05);
}

/// Distance of the crest points (z = height before bending, plan y = 0) from the middle line of the flat
/// image.
void expect_crest_in_the_middle(const Facets& plain, const FlatFace& flat, double height, double tolerance) {
  for (std::size_t v = 0; v < plain.points.size(); ++v) {
    if (plain.points[v].z < height - 1e-9) continue;
    EXPECT_NEAR(flat.positions[v].y, 0, tolerance) << plain.points[v].x;
  }
}

TEST(Flatten, CrestOfADomeMapsToTheMiddle) {
  const Facets facets = shapes::stadium_dome(120, 16, 5, 192, 14);
  const auto flat = flatten(facets);
  ASSERT_TRUE(flat) << flat.error().message;
  expect_no_flips(facets, *flat);
  EXPECT_LT(flat->distortion.max_ratio, 1.6);
  EXPECT_GT(flat->distortion.max_ratio, 1.05);
  expect_crest_in_the_middle(facets, *flat, 5, 0.02);
  double left = 0, right = 0;
  for (const Index v : facets.loops[0]) {
    left = std::min(left, flat->positions[v].y);
    right = std::max(right, flat->positions[v].y);
  }
  EXPECT_NEAR(left, -right, 0.02);
}

TEST(Flatten, CrestOfADomeOnACylinderMapsToTheMiddle) {
  const double r = 150;
  const auto bend = [&](Vec3 p) {
    const double a = p.x / r;
    return Vec3{(r + p.z) * std::sin(a), p.y, (r + p.z) * std::cos(a) - r};
  };
  const Facets plain = shapes::stadium_dome(160, 16, 5, 192, 14);
  const Facets facets = shapes::stadium_dome(160, 16, 5, 192, 14, bend);
  const auto flat = flatten(facets);
  ASSERT_TRUE(flat) << flat.error().message;
  expect_crest_in_the_middle(plain, *flat, 5, 0.05);
}

TEST(Flatten, RingWithSteepWallsKeepsItsWinding) {
  // Walls of 70 degrees: the turn unrolled around them misses a full turn by more than half a turn.
  const double pitch = 10;
  Facets facets;
  const Index around = 120, across = 16;
  for (Index j = 0; j <= across; ++j)
    for (Index i = 0; i < around; ++i) {
      const double a = 2 * pi * i / around, s = 2.0 * j / across - 1, r = 60 + pitch * s;
      facets.points.push_back({r * std::cos(a), r * std::sin(a), 17 * std::pow(std::cos(s * pi / 2), 2)});
    }
  for (Index j = 0; j < across; ++j)
    for (Index i = 0; i < around; ++i) {
      const Index a = j * around + i, b = j * around + (i + 1) % around;
      facets.triangles.push_back({a, a + around, b + around});
      facets.triangles.push_back({a, b + around, b});
    }
  facets = shapes::finished(facets);
  const auto flat = flatten(facets);
  ASSERT_TRUE(flat) << flat.error().message;
  expect_no_flips(facets, *flat);
  double low = 1e9, high = 0;
  for (const Index v : facets.loops[0]) {
    low = std::min(low, norm(flat->positions[v]));
    high = std::max(high, norm(flat->positions[v]));
  }
  EXPECT_NEAR(low, high, 0.01);
  EXPECT_GT(low, 70);
}

TEST(Flatten, ArcOfALongBeadOpensAsFarAsItMust) {
  // The section of an arc bead is wider on the surface than in plan; so the arc opens (by about the mean
  // cosine of its walls), whatever sweeps that takes: the result is converged.
  const Facets facets = shapes::sheet(160, 16, [](double s, double t) {
    const double a = 3 * s, r = 60 - 8 * (2 * t - 1), z = 5 * std::pow(std::cos((2 * t - 1) * pi / 2), 2);
    return Vec3{r * std::cos(a), r * std::sin(a), z};
  });
  const auto flat = flatten(facets);
  FlattenOptions exact;
  exact.convergence = 1e-12;
  exact.iterations = 100000;
  const auto best = flatten(facets, exact);
  ASSERT_TRUE(flat && best);
  double worst = 0;
  for (std::size_t v = 0; v < facets.points.size(); ++v)
    worst = std::max(worst, distance(flat->positions[v], best->positions[v]));
  EXPECT_LT(worst, 0.01);
}

TEST(Flatten, DiscWithManyHolesOnACylinder) {
  const Facets facets = shapes::sheet(
      60, 60,
      [](double s, double t) {
        const double a = 1.2 * (s - 0.5);
        return Vec3{200 * std::sin(a), 240 * t, 200 * std::cos(a)};
      },
      [](double s, double t) { return int(s * 60) % 6 != 3 || int(t * 60) % 6 != 3; });
  ASSERT_EQ(facets.loops.size(), 101u);
  const auto flat = flatten(facets);
  ASSERT_TRUE(flat) << flat.error().message;
  EXPECT_LT(greatest_length_error(facets, *flat), 1e-5);
}

TEST(Flatten, SliversDoNoHarm) {
  std::mt19937 random(7);
  for (int run = 0; run < 20; ++run) {
    Facets facets = shapes::cylinder(25, 2, 80, 12, 6);
    // Splits triangles by points on, or a hair beside, an edge or a corner.
    const std::size_t count = facets.triangles.size();
    for (std::size_t t = 0; t < count; t += 3) {
      const Triangle old = facets.triangles[t];
      const double tiny = std::pow(10.0, -static_cast<double>(random() % 12)) / 3;
      const double other = random() % 2 ? tiny : 0.3;
      const Vec3 p = facets.points[old[0]] * (1 - tiny - other) + facets.points[old[1]] * tiny +
                     facets.points[old[2]] * other;
      const auto v = static_cast<Index>(facets.points.size());
      facets.points.push_back(p);
      facets.triangles[t] = {old[0], old[1], v};
      facets.triangles.push_back({old[1], old[2], v});
      facets.triangles.push_back({old[2], old[0], v});
    }
    const auto flat = flatten(facets);
    ASSERT_TRUE(flat) << flat.error().message;
    EXPECT_LT(greatest_length_error(facets, *flat), 1e-3);
  }
}

TEST(Flatten, FacetWithoutAreaIsCarriedAlong) {
  Facets facets = shapes::cylinder(25, 2, 80, 12, 6);
  const Triangle old = facets.triangles[10];
  const auto v = static_cast<Index>(facets.points.size());
  facets.points.push_back(lerp(facets.points[old[0]], facets.points[old[1]], 0.5));
  facets.triangles[10] = {old[0], old[1], v};  // no area
  facets.triangles.push_back({old[1], old[2], v});
  facets.triangles.push_back({old[2], old[0], v});
  const auto flat = flatten(facets);
  ASSERT_TRUE(flat) << flat.error().message;
  EXPECT_NEAR(norm(flat->positions[v] - lerp(flat->positions[old[0]], flat->positions[old[1]], 0.5)), 0,
              1e-3);
}

TEST(Flatten, ResultTurnsWithThePiece) {
  const Facets facets = shapes::stadium_dome(70, 16, 5);
  const Facets turned = shapes::turned(facets, normalized(Vec3{1, -2, 0.7}), 1.1);
  const auto a = flatten(facets), b = flatten(turned);
  ASSERT_TRUE(a && b);
  for (std::size_t v = 0; v + 9 < facets.points.size(); v += 9)
    EXPECT_NEAR(distance(a->positions[v], a->positions[v + 9]),
                distance(b->positions[v], b->positions[v + 9]), 1e-3);
}

TEST(Flatten, SameBitsTwice) {
  const Facets facets = shapes::stadium_dome(70, 16, 5);
  EXPECT_EQ(flatten(facets)->positions, flatten(facets)->positions);
}

TEST(Flatten, RefusesTooMuchDistortion) {
  FlattenOptions strict;
  strict.max_distortion = 1.01;
  const auto flat = flatten(shapes::stadium_dome(70, 16, 5), strict);
  ASSERT_FALSE(flat);
  EXPECT_EQ(flat.error().code, "flatten.distortion");
}

TEST(Flatten, AlmostClosedSphereIsAnErrorOrWithoutFlips) {
  const Facets facets = shapes::sheet(24, 24, [](double s, double t) {
    const double x = 2 * s - 1, y = 2 * t - 1;
    const double u = x * std::sqrt(1 - y * y / 2), v = y * std::sqrt(1 - x * x / 2),
                 a = 2.9 * std::hypot(u, v);
    const double c = a > 0 ? std::sin(a) / std::hypot(u, v) : 0;
    return Vec3{c * u, c * v, std::cos(a)};
  });
  const auto flat = flatten(facets);
  if (flat)
    expect_no_flips(facets, *flat);
  else
    EXPECT_TRUE(flat.error().code == "flatten.distortion" || flat.error().code == "flatten.flip");
}

}  // namespace
}  // namespace beadmesh
