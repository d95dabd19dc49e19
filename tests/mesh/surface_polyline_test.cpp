#include "beadmesh/mesh/surface_polyline.h"

#include <gtest/gtest.h>

#include "bead/studied_bead.h"
#include "examples/skeletons.h"

namespace beadmesh {
namespace {

using namespace shapes;

TEST(SurfacePolyline, OnAPlaneIsThePolyline) {
  const StudiedBead flat = studied_bead(examples::straight_bead(60, 30), 0);
  const SurfacePolyline line({{-20, 0}, {0, 0}, {0, 10}}, flat.map());
  EXPECT_NEAR(line.length(), 30, 1e-9);
  EXPECT_LT(distance(line.point_at(25), {0, 5}), 1e-9);
  EXPECT_NEAR(line.flat_share_at(10), 1.0 / 3, 1e-12);
  EXPECT_LT(distance(line.point_at(0), {-20, 0}), 1e-9);
  EXPECT_LT(distance(line.point_at(30), {0, 10}), 1e-9);
}

TEST(SurfacePolyline, IsClampedToItsEnds) {
  const StudiedBead flat = studied_bead(examples::straight_bead(60, 30), 0);
  const SurfacePolyline line({{-20, 0}, {20, 0}}, flat.map());
  EXPECT_LT(distance(line.point_at(-5), {-20, 0}), 1e-9);
  EXPECT_LT(distance(line.point_at(500), {20, 0}), 1e-9);
  EXPECT_NEAR(line.flat_share_at(500), 1, 1e-12);
}

TEST(SurfacePolyline, IsMeasuredOnTheSurface) {
  // Round the end of a bead the flat face is squeezed: flat and real length differ.
  const StudiedBead dome = studied_bead(examples::straight_bead(10, 40), 14, flat_base, {}, 1.5);
  const std::vector<Vec2> flat{{0, 0}, {0, 12}};
  const SurfacePolyline line(flat, dome.map());
  double truth = 0;
  constexpr int pieces = 2000;
  for (int i = 0; i < pieces; ++i)
    truth += distance(dome.study->lift(lerp(flat[0], flat[1], double(i) / pieces)),
                      dome.study->lift(lerp(flat[0], flat[1], (i + 1.0) / pieces)));
  EXPECT_NEAR(line.length(), truth, 0.02 * truth);
  const Vec2 half = line.point_at(line.length() / 2);
  EXPECT_NEAR(SurfacePolyline({flat[0], half}, dome.map()).length(), line.length() / 2, 0.02);
}

TEST(SurfacePolyline, ShareAndPointAgree) {
  const StudiedBead bead = studied_bead(examples::straight_bead(60, 16), 5);
  const std::vector<Vec2> flat{{-25, -7}, {25, 7}};
  const SurfacePolyline line(flat, bead.map());
  double before = -1;
  for (int i = 0; i <= 10; ++i) {
    const double arc = line.length() * i / 10, share = line.flat_share_at(arc);
    EXPECT_GT(share, before);
    EXPECT_LT(distance(line.point_at(arc), lerp(flat[0], flat[1], share)), 1e-9);
    before = share;
  }
}

TEST(SurfacePolyline, OfOnePointHasNoLength) {
  const StudiedBead flat = studied_bead(examples::straight_bead(60, 30), 0);
  const SurfacePolyline line({{1, 2}, {1, 2}}, flat.map());
  EXPECT_EQ(line.length(), 0);
  EXPECT_EQ(line.point_at(3), (Vec2{1, 2}));
}

}  // namespace
}  // namespace beadmesh
