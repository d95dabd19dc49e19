#include "beadmesh/bead/continued_sheet.h"

#include <gtest/gtest.h>

#include "bead/plan_panel.h"
#include "examples/skeletons.h"

namespace beadmesh {
namespace {

using namespace shapes;

/// The sheet around a bead, with the bead's loop as its second.
Panel sheet_around_bead(const Base& base) {
  PlanPanel plan(base, 1.5);
  const auto loops = plan.add_bead(examples::straight_bead(60, 16), 5);
  std::vector<Vec2> border;
  for (const Vec2 corner : {Vec2{-80, -50}, Vec2{80, -50}, Vec2{80, 50}, Vec2{-80, 50}})
    border.push_back(corner);
  plan.add_face(plan.add_loop(border, {0, 1, 2, 3}), loops, on(base), 6);
  return plan.take();
}

TEST(ContinuedSheet, FollowsPlanesCylindersAndSaddlesUnderTheBead) {
  const Base saddle = [](Vec2 p) { return p.x * p.x / 1500 - p.y * p.y / 1200 + 0.1 * p.x; };
  for (const Base& base : {Base(flat_base), cylinder_base(600), saddle}) {
    const Panel panel = sheet_around_bead(base);
    const ContinuedSheet sheet(panel.faces[1].facets, 1);
    for (double x = -30; x <= 30; x += 10) {
      const Vec3 on_base{x, 2, base({x, 2})};
      EXPECT_NEAR(sheet.height(on_base), 0, 0.05);
      EXPECT_NEAR(sheet.height(on_base + Vec3{0, 0, 4}), 4, 0.1);
      const double h = 1e-3;
      const Vec3 normal = normalized(Vec3{-(base({x + h, 2}) - base({x - h, 2})) / (2 * h),
                                          -(base({x, 2 + h}) - base({x, 2 - h})) / (2 * h), 1});
      EXPECT_LT(angle_between(sheet.normal(on_base), normal), radians(0.5));
    }
  }
}

TEST(ContinuedSheet, DoesNotDependOnTheDrawing) {
  const Panel panel = sheet_around_bead(cylinder_base(600));
  Facets turned = panel.faces[1].facets;
  turned.surfaces.clear();
  turned.triangle_uv.clear();
  const auto move = [](Vec3 p) { return Vec3{p.y + 7, p.z - 300, p.x + 40}; };
  const ContinuedSheet facets_only(turned, 1);
  for (Vec3& p : turned.points) p = move(p);
  const ContinuedSheet moved(turned, 1);
  for (const Vec3 p : panel.faces[0].facets.points)
    EXPECT_NEAR(moved.height(move(p)), facets_only.height(p), 1e-6);
}

}  // namespace
}  // namespace beadmesh
