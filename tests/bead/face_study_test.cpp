#include "beadmesh/bead/face_study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bead/studied_bead.h"
#include "beadmesh/panel/panel.h"
#include "examples/skeletons.h"

namespace beadmesh {
namespace {

using namespace shapes;

/// A sheet 120 x 60 with a stadium bead in it: faces 0 (bead) and 1 (sheet).
Panel plate() {
  PlanPanel plan;
  const auto bead = plan.add_bead(examples::straight_bead(60, 16), 4);
  const int outline =
      plan.add_loop({{-60, -30}, {0, -30}, {60, -30}, {60, 30}, {0, 30}, {-60, 30}}, {0, 2, 3, 5});
  plan.add_face(outline, bead, on(flat_base));
  return plan.take();
}

TEST(FaceStudy, PlansAreSoundPanels) {
  EXPECT_EQ(verify_panel(plate()), std::vector<std::string>{});
}

TEST(FaceStudy, RegionFollowsTheFacetsLoops) {
  const Panel panel = plate();
  const auto study = study_faces(panel, {0});
  ASSERT_TRUE(study);
  const FaceStudy& s = **study;
  ASSERT_EQ(s.region.loops.size(), 1);
  ASSERT_EQ(s.region.loops[0].points.size(), s.facets.loops[0].size());
  for (size_t i = 0; i < s.facets.loops[0].size(); ++i)
    EXPECT_EQ(s.region.loops[0].points[i], s.flat.positions[s.facets.loops[0][i]]);
  EXPECT_GT(signed_area(s.region.loops[0]), 0);
}

TEST(FaceStudy, LiftsToTheExactSurface) {
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 16), 5, flat_base, {}, 3);
  const Lift exact = raised(examples::straight_bead(84, 16).loops, 8, 5);
  for (const Vec2 p : {Vec2{0, 0}, Vec2{20, 4}, Vec2{-30, -6}}) {
    const Vec3 q = bead.study->lift(p);
    EXPECT_LT(distance(q, exact({q.x, q.y})), 1e-6);
  }
}

TEST(FaceStudy, CornersAreTaggedWhereEdgesMeetAtAnAngle) {
  const auto study = study_faces(plate(), {1});
  ASSERT_TRUE(study);
  const auto& loops = (*study)->region.loops;
  ASSERT_EQ(loops.size(), 2);
  EXPECT_EQ(std::count(loops[0].corner.begin(), loops[0].corner.end(), true), 4);
  EXPECT_EQ(std::count(loops[1].corner.begin(), loops[1].corner.end(), true), 0);
  for (size_t i = 0; i < loops[0].points.size(); ++i)
    EXPECT_NEAR((*study)->joint_angles[0][i], loops[0].corner[i] ? pi / 2 : 0, 1e-6);
}

TEST(FaceStudy, JoinsFacesToOnePiece) {
  const auto study = study_faces(plate(), {0, 1});
  ASSERT_TRUE(study);
  EXPECT_EQ((*study)->region.loops.size(), 1) << "the bead's boundary lies inside";
  EXPECT_NEAR(signed_area((*study)->region.loops[0]), 120 * 60, 250);
}

TEST(FaceStudy, FaceWithoutFacetsIsRefused) {
  Panel panel = plate();
  panel.faces[0].facets.triangles.clear();
  const auto study = study_faces(panel, {0});
  ASSERT_FALSE(study);
  EXPECT_EQ(study.error().code.substr(0, 8), "flatten.");
}

/// A tube about z, radius 10 and height 30, of one face: two closed edges and the seam between them.
Panel tube() {
  constexpr Index columns = 24, rows = 6;
  Panel panel;
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const double a = 2 * pi * i / columns;
      panel.points.push_back({10 * std::cos(a), 10 * std::sin(a), 30.0 * j / rows});
    }
  panel.edges.resize(3);
  for (Index i = 0; i <= columns; ++i) {
    panel.edges[0].points.push_back(i % columns);
    panel.edges[1].points.push_back(rows * columns + i % columns);
  }
  for (Index j = 0; j <= rows; ++j) panel.edges[2].points.push_back(j * columns);
  panel.edges[0].faces = panel.edges[1].faces = {0};
  panel.edges[2].faces = {0, 0};
  PanelFace face;
  face.number = 1;
  face.loops = {{{0, false}, {2, false}, {1, true}, {2, true}}};
  Facets& facets = face.facets;
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i <= columns; ++i) {
      facets.panel_points.push_back(j * columns + i % columns);
      facets.points.push_back(panel.points[facets.panel_points.back()]);
    }
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const Index a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
      facets.triangles.push_back({a, b, d});
      facets.triangles.push_back({a, d, c});
    }
  facets.triangle_surface.assign(facets.triangles.size(), 0);
  std::vector<Index>& loop = facets.loops.emplace_back();
  for (Index i = 0; i < columns; ++i) loop.push_back(i);
  for (Index j = 0; j < rows; ++j) loop.push_back(j * (columns + 1) + columns);
  for (Index i = columns; i > 0; --i) loop.push_back(rows * (columns + 1) + i);
  for (Index j = rows; j > 0; --j) loop.push_back(j * (columns + 1));
  panel.faces.push_back(std::move(face));
  return panel;
}

TEST(FaceStudy, OpenedTubeHasFourCornersAndTheSidesOfItsCut) {
  const Panel panel = tube();
  ASSERT_EQ(verify_panel(panel), std::vector<std::string>{});
  const auto study = study_opened_face(panel, 0);
  ASSERT_TRUE(study);
  const FaceStudy& s = **study;
  EXPECT_NEAR(cut_length(s), 30, 1e-9);
  ASSERT_EQ(s.region.loops.size(), 1);
  const auto& corner = s.region.loops[0].corner;
  EXPECT_EQ(std::count(corner.begin(), corner.end(), true), 4);
  EXPECT_EQ(std::count(s.cut_sides[0].begin(), s.cut_sides[0].end(), true), 2 * 6);
  for (size_t i = 0; i < corner.size(); ++i) EXPECT_NEAR(s.joint_angles[0][i], corner[i] ? pi / 2 : 0, 0.02);
}

TEST(FaceStudy, OpenedFaceWithoutASeamIsTheStudiedOne) {
  const Panel panel = plate();
  for (const Index face : {0, 1}) {
    const auto opened = study_opened_face(panel, face), plain = study_faces(panel, {face});
    ASSERT_TRUE(opened && plain);
    EXPECT_TRUE((*opened)->cut_sides.empty());
    EXPECT_EQ((*opened)->flat.positions, (*plain)->flat.positions);
    EXPECT_EQ((*opened)->joint_angles, (*plain)->joint_angles);
    for (size_t l = 0; l < (*plain)->region.loops.size(); ++l)
      EXPECT_EQ((*opened)->region.loops[l].corner, (*plain)->region.loops[l].corner);
  }
}

}  // namespace
}  // namespace beadmesh
