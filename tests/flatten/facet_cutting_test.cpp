#include "beadmesh/flatten/facet_cutting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "flatten/facet_shapes.h"

namespace beadmesh {
namespace {

using namespace shapes;

CutFacets uncut(Facets facets) {
  CutFacets piece{std::move(facets), {}};
  piece.origin.resize(piece.facets.points.size());
  std::iota(piece.origin.begin(), piece.origin.end(), 0);
  return piece;
}

Facets plane() {
  Facets facets = sheet(6, 4, [](double s, double t) { return Vec3{60 * s, 40 * t, 0}; });
  for (const Triangle& t : facets.triangles) {
    std::array<Vec2, 3>& uv = facets.triangle_uv.emplace_back();
    for (int k = 0; k < 3; ++k) uv[k] = {facets.points[t[k]].x, facets.points[t[k]].y};
  }
  return facets;
}

Index vertex_at(const Facets& facets, Vec3 p) {
  return static_cast<Index>(std::find(facets.points.begin(), facets.points.end(), p) - facets.points.begin());
}

TEST(FacetCutting, ACutFromSideToSideMakesTwoPieces) {
  CutFacets piece = uncut(plane());
  const double whole = area(piece.facets);
  const auto way = shortest_path(piece.facets, {vertex_at(piece.facets, {20, 0, 0})},
                                 {vertex_at(piece.facets, {30, 40, 0})});
  ASSERT_TRUE(cut_along(piece, way));
  EXPECT_NEAR(area(piece.facets), whole, 1e-9) << "nothing is lost";
  EXPECT_EQ(piece.facets.loops.size(), 2) << "one loop a piece";
  const auto sides = cut_sides(piece.facets.loops, piece.origin);
  for (const auto& loop : sides)
    EXPECT_EQ(std::count(loop.begin(), loop.end(), true), static_cast<long>(way.size()) - 1);
}

TEST(FacetCutting, ASlitStaysOnePiece) {
  CutFacets piece = uncut(plane());
  const std::size_t before = piece.facets.loops[0].size();
  const auto way = shortest_path(piece.facets, {vertex_at(piece.facets, {30, 20, 0})},
                                 {vertex_at(piece.facets, {60, 30, 0})});
  ASSERT_TRUE(cut_along(piece, way));
  ASSERT_EQ(piece.facets.loops.size(), 1);
  EXPECT_EQ(piece.facets.loops[0].size(), before + 2 * (way.size() - 1));
}

TEST(FacetCutting, ParametersComeAlong) {
  CutFacets piece = uncut(plane());
  const auto way = shortest_path(piece.facets, {vertex_at(piece.facets, {0, 10, 0})},
                                 {vertex_at(piece.facets, {60, 30, 0})});
  ASSERT_TRUE(cut_along(piece, way));
  ASSERT_EQ(piece.facets.triangle_uv.size(), piece.facets.triangles.size());
  for (std::size_t t = 0; t < piece.facets.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vec3 p = piece.facets.points[piece.facets.triangles[t][k]];
      EXPECT_NEAR(distance(piece.facets.triangle_uv[t][k], {p.x, p.y}), 0, 1e-9);
    }
  EXPECT_EQ(piece.facets.triangle_surface.size(), piece.facets.triangles.size());
}

TEST(FacetCutting, SewingUndoesACut) {
  CutFacets piece = uncut(plane());
  const auto way = shortest_path(piece.facets, {vertex_at(piece.facets, {20, 0, 0})},
                                 {vertex_at(piece.facets, {30, 40, 0})});
  ASSERT_TRUE(cut_along(piece, way));
  const CutFacets whole = sewn(piece.facets, piece.origin);
  ASSERT_EQ(whole.facets.loops.size(), 1);
  for (const auto& loop : cut_sides(whole.facets.loops, whole.origin))
    EXPECT_EQ(std::count(loop.begin(), loop.end(), true), 0);
}

TEST(FacetCutting, AWayThroughATriangleTwiceIsRefused) {
  CutFacets piece = uncut(sheet(1, 1, [](double s, double t) { return Vec3{s, t, 0}; }));
  const Triangle t = piece.facets.triangles[0];
  const auto stop = [&](int a, int b, double at) {
    return t[a] < t[b] ? PathStop{t[a], t[b], at} : PathStop{t[b], t[a], 1 - at};
  };
  const std::size_t points = piece.facets.points.size();
  EXPECT_FALSE(cut_along(piece, {stop(0, 1, 0.5), stop(1, 2, 0.5), stop(0, 2, 0.5)}));
  EXPECT_FALSE(cut_along(piece, {}));
  EXPECT_EQ(piece.facets.points.size(), points);
}

}  // namespace
}  // namespace beadmesh
