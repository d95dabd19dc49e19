#include "beadmesh/bead/face_study.h"

#include <gtest/gtest.h>

#include <algorithm>

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

}  // namespace
}  // namespace beadmesh
