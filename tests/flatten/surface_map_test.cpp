#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

#include "beadmesh/flatten/facet_search.h"
#include "beadmesh/flatten/flat_face.h"
#include "flatten/facet_shapes.h"

namespace beadmesh {
namespace {

constexpr double radius = 25;

/// u: angle, v: length along the axis.
class CylinderSurface : public SurfaceEvaluator {
 public:
  Vec3 point(Vec2 uv) const override { return {radius * std::sin(uv.x), uv.y, radius * std::cos(uv.x)}; }
  Vec3 normal(Vec2 uv) const override { return {std::sin(uv.x), 0, std::cos(uv.x)}; }
};

struct Piece {
  Facets facets;
  FlatFace flat;

  explicit Piece(Facets of, bool with_surface = false) : facets(std::move(of)) {
    if (with_surface) {
      facets.surfaces = {std::make_shared<CylinderSurface>()};
      for (const Triangle& t : facets.triangles) {
        std::array<Vec2, 3> uv;
        for (int k = 0; k < 3; ++k) {
          const Vec3 p = facets.points[t[k]];
          uv[k] = {std::atan2(p.x, p.z), p.y};
        }
        facets.triangle_uv.push_back(uv);
      }
    }
    flat = flatten(facets).value();
  }
};

Vec2 flat_of(const Piece& piece, const FacetPoint& at) {
  const Triangle& t = piece.facets.triangles[at.triangle];
  Vec2 p;
  for (int k = 0; k < 3; ++k) p += piece.flat.positions[t[k]] * at.weight[k];
  return p;
}

const Piece& dome() {
  static const Piece piece(shapes::stadium_dome(80, 16, 5));
  return piece;
}

RC_GTEST_PROP(SurfaceMap, LocateFindsTheFacetFromAnyHint, ()) {
  const SurfaceMap map(dome().facets, dome().flat);
  const auto count = static_cast<Index>(dome().facets.triangles.size());
  FacetPoint at;
  at.triangle = *rc::gen::inRange<Index>(0, count);
  const double a = *rc::gen::inRange(0, 101) / 100.0, b = *rc::gen::inRange(0, 101) / 100.0 * (1 - a);
  at.weight[0] = a, at.weight[1] = b, at.weight[2] = 1 - a - b;
  const Vec2 p = flat_of(dome(), at);
  const FacetPoint found = map.locate(p, *rc::gen::inRange<Index>(-1, count));
  RC_ASSERT(norm(flat_of(dome(), found) - p) < 1e-9);
  RC_ASSERT(norm(map.facet_point(found) - map.facet_point(at)) < 1e-9);
}

RC_GTEST_PROP(SurfaceMap, OutsideIsClampedToTheNearestPoint, ()) {
  const SurfaceMap map(dome().facets, dome().flat);
  const Vec2 p{*rc::gen::inRange(-700, 700) / 10.0, *rc::gen::inRange(-300, 300) / 10.0};
  const FacetPoint found = map.locate(p, *rc::gen::inRange<Index>(-1, 500));
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < dome().facets.triangles.size(); ++t) {
    const Triangle& v = dome().facets.triangles[t];
    const Vec2 a = dome().flat.positions[v[0]], b = dome().flat.positions[v[1]],
               c = dome().flat.positions[v[2]];
    const auto w = nearest_weights(a, b, c, p);
    least = std::min(least, norm(a * w[0] + b * w[1] + c * w[2] - p));
  }
  RC_ASSERT(std::abs(norm(flat_of(dome(), found) - p) - least) < 1e-9);
  RC_ASSERT(std::min({found.weight[0], found.weight[1], found.weight[2]}) >= 0);
  RC_ASSERT(std::abs(found.weight[0] + found.weight[1] + found.weight[2] - 1) < 1e-12);
}

TEST(SurfaceMap, RoundTripOverTheSurface) {
  const SurfaceMap map(dome().facets, dome().flat);
  const FacetSearch search(dome().facets);
  for (int i = -35; i <= 35; ++i)
    for (int j = -7; j <= 7; ++j) {
      const Vec2 p{static_cast<double>(i), static_cast<double>(j)};
      const FacetPoint at = map.locate(p);
      const FacetPoint back = search.nearest(map.facet_point(at));
      EXPECT_NEAR(norm(flat_of(dome(), back) - p), 0, 1e-6);
    }
}

TEST(SurfaceMap, ExactSurfaceAndNormal) {
  const Piece piece(shapes::cylinder(radius, 2, 80, 12, 4), true);
  const SurfaceMap map(piece.facets, piece.flat);
  double sagitta = 0;
  for (int i = -20; i <= 20; ++i) {
    const FacetPoint at = map.locate({static_cast<double>(i), 33.3});
    const Vec3 exact = map.surface_point(at), facet = map.facet_point(at), normal = map.normal(at);
    EXPECT_NEAR(std::hypot(exact.x, exact.z), radius, 1e-12);
    EXPECT_NEAR(exact.y, 33.3, 1e-5);
    EXPECT_NEAR(norm(normal - Vec3{exact.x, 0, exact.z} / radius), 0, 1e-12);
    sagitta = std::max(sagitta, norm(exact - facet));
  }
  EXPECT_GT(sagitta, 0.05);
  EXPECT_LT(sagitta, 0.12);
}

TEST(SurfaceMap, WithoutSurfaceTheFacetsServe) {
  const Piece piece(shapes::cylinder(radius, 2, 80, 40, 4));
  const SurfaceMap map(piece.facets, piece.flat);
  const FacetPoint at = map.locate({7.7, 20});
  EXPECT_EQ(map.surface_point(at), map.facet_point(at));
  const Vec3 p = map.facet_point(at);
  EXPECT_LT(degrees(angle_between(map.normal(at), Vec3{p.x, 0, p.z})), 2);
}

TEST(SurfaceMap, JumpingParametersFallBackToTheFacet) {
  Piece piece(shapes::cylinder(radius, 2, 80, 12, 4), true);
  piece.facets.triangle_uv[0][1].y += 1000;
  const SurfaceMap map(piece.facets, piece.flat);
  FacetPoint at;
  at.triangle = 0;
  at.weight[1] = 1;
  EXPECT_EQ(map.surface_point(at), map.facet_point(at));
}

TEST(SurfaceMap, StretchIsTheLengthOnTheSurface) {
  const Piece flat_piece(shapes::sheet(4, 4, [](double s, double t) { return Vec3{9 * s, 9 * t, 0}; }));
  const SurfaceMap plane(flat_piece.facets, flat_piece.flat);
  EXPECT_NEAR(plane.stretch(plane.locate({3, 4}), normalized(Vec2{1, 2})), 1, 1e-12);
  Piece doubled = flat_piece;
  for (Vec2& p : doubled.flat.positions) p.x *= 2;
  const SurfaceMap map(doubled.facets, doubled.flat);
  EXPECT_NEAR(map.stretch(map.locate({3, 4}), {1, 0}), 0.5, 1e-12);
  EXPECT_NEAR(map.stretch(map.locate({3, 4}), {0, 1}), 1, 1e-12);
}

TEST(SurfaceMap, SurvivesDegenerateFlatTriangles) {
  Piece piece(shapes::sheet(3, 3, [](double s, double t) { return Vec3{9 * s, 9 * t, 0}; }));
  for (Vec2& p : piece.flat.positions)
    if (p.x > 5) p = {6, 3};  // squashes a third of the image
  const SurfaceMap map(piece.facets, piece.flat);
  for (Index hint = -1; hint < 18; ++hint) {
    for (const Vec2 p : {Vec2{1, 1}, Vec2{6, 3}, Vec2{20, -5}, Vec2{8, 8}}) {
      const FacetPoint at = map.locate(p, hint);
      ASSERT_NE(at.triangle, no_index);
      EXPECT_TRUE(std::isfinite(norm(map.facet_point(at)) + map.stretch(at, {1, 0}) + norm(map.normal(at))));
    }
  }
  for (Vec2& p : piece.flat.positions) p = {1, 1};
  const SurfaceMap point(piece.facets, piece.flat);
  EXPECT_NE(point.locate({3, 3}, 4).triangle, no_index);
}

TEST(SurfaceMap, NoNumberIsNowhere) {
  const SurfaceMap map(dome().facets, dome().flat);
  EXPECT_EQ(map.locate({std::numeric_limits<double>::quiet_NaN(), 0}).triangle, no_index);
  const Facets none;
  const FlatFace nothing;
  EXPECT_EQ(SurfaceMap(none, nothing).locate({0, 0}).triangle, no_index);
}

}  // namespace
}  // namespace beadmesh
