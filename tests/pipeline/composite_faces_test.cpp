#include "beadmesh/bead/composite_faces.h"

#include <gtest/gtest.h>

#include "beadmesh/pipeline.h"
#include "mesh/bead_plates.h"
#include "panel/split_faces.h"

namespace beadmesh {
namespace {

using namespace shapes;

/// Foot, wall and crown apart, and all of them cut again every 25 mm: dozens of faces a bead.
int fillet_patch(Vec3 p, double height_over_sheet) {
  const int band = std::abs(height_over_sheet) < 1.2 ? 0 : std::abs(height_over_sheet) < 3.6 ? 1 : 2;
  return band + 3 * (int(std::floor(p.x / 25)) + 100 * int(std::floor(p.y / 25)));
}

Panel split_plate(Panel panel, const std::vector<Index>& faces, const Base& base) {
  panel = test::with_segment_edges(std::move(panel));
  for (const Index f : faces)
    test::FaceSplitter(panel, f).split([&](Vec3 p) { return fillet_patch(p, p.z - base({p.x, p.y})); });
  return panel;
}

TEST(CompositeFaces, BeadsOfManyFacesAreFoundAsThoseOfOne) {
  const Panel panel = split_plate(plate_of_every_kind(), {0, 1, 2}, cylinder_base(900));
  ASSERT_EQ(verify_panel(panel), std::vector<std::string>{});
  ASSERT_GT(panel.faces.size(), 60u);
  EXPECT_EQ(recognise_beads(panel).beads.size(), 0u) << "no bead without the composite faces";

  const Panel composed = compose_faces(panel);
  EXPECT_EQ(verify_panel(composed), std::vector<std::string>{});
  ASSERT_EQ(composed.faces.size(), 5u);
  const BeadTable table = recognise_beads(composed), whole = recognise_beads(plate_of_every_kind());
  ASSERT_EQ(table.beads.size(), 3u);
  for (size_t b = 0; b < 3; ++b) {
    EXPECT_EQ(table.beads[b].kind, whole.beads[b].kind);
    EXPECT_EQ(table.beads[b].shape, whole.beads[b].shape);
    EXPECT_NEAR(table.beads[b].length, whole.beads[b].length, 0.01 * whole.beads[b].length);
    EXPECT_NEAR(table.beads[b].width, whole.beads[b].width, 0.01 * whole.beads[b].width);
    EXPECT_GT(input_numbers(composed, table.beads[b].faces).size(), 10u);
  }
}

TEST(CompositeFaces, MeshOfABeadOfManyFacesHasNoNodesForcedByItsInnerEdges) {
  const Panel composed = compose_faces(split_plate(plate_of_every_kind(), {0, 1, 2}, cylinder_base(900)));
  const auto mesh = mesh_panel(composed, {});
  ASSERT_TRUE(mesh) << mesh.error().message;
  for (const BeadMeshing& bead : mesh->meshing) EXPECT_EQ(bead.method, "blocks");
  EXPECT_EQ(mesh->quality.edges_below_min, 0);
}

/// The sheet in six pieces, every bead cut by a line between them, and its faces many.
TEST(CompositeFaces, SheetCutByConstructionLinesIsOneFaceAgain) {
  Panel panel = split_plate(plate_of_every_kind(), {0, 1, 2}, cylinder_base(900));
  test::FaceSplitter(panel, 4).split([](Vec3 p) { return (p.x > -60) + (p.x > 55) + 3 * (p.y > 4); });
  ASSERT_EQ(verify_panel(panel), std::vector<std::string>{});
  const Panel composed = compose_faces(panel);
  EXPECT_EQ(verify_panel(composed), std::vector<std::string>{});
  EXPECT_EQ(composed.faces.size(), 5u);
  EXPECT_EQ(recognise_beads(composed).beads.size(), 3u);
}

/// The line at x = 90 passes no bead; the edge at (90, 40) is kept, and the others go.
TEST(CompositeFaces, AnEdgeThatTheUserKeepsStays) {
  BeadPlate plate(240, 120);
  plate.add(examples::straight_bead(60, 16), 5);
  Panel panel = test::with_segment_edges(plate.take());
  test::FaceSplitter(panel, 1).split([](Vec3 p) { return (p.x > 60) + (p.x > 90); });
  ASSERT_EQ(panel.faces.size(), 4u);
  const Vec3 on_edge = [&] {
    for (const PanelEdge& edge : panel.edges)
      for (const Index n : edge.points)
        if (edge.faces.size() == 2 && edge.faces[0] != 0 && edge.faces[1] != 0 && panel.points[n].x > 80)
          return panel.points[n];
    return Vec3{};
  }();
  ASSERT_GT(on_edge.x, 80);
  EXPECT_EQ(compose_faces(panel).faces.size(), 2u);
  const std::vector<Vec3> kept{on_edge};
  const Panel composed = compose_faces(panel, {}, {}, kept);
  EXPECT_EQ(composed.faces.size(), 3u);
  EXPECT_TRUE(composed.diagnostics.empty());
  const std::vector<Vec3> nowhere{{0, 0, 500.25}};
  const Panel missed = compose_faces(panel, {}, {}, nowhere);
  EXPECT_EQ(missed.faces.size(), 2u);
  ASSERT_EQ(missed.diagnostics.size(), 1u);
  EXPECT_EQ(missed.diagnostics[0].code, "control.keep_edge");
  EXPECT_NE(missed.diagnostics[0].message.find("(0, 0, 500.25)"), std::string::npos);
}

TEST(CompositeFaces, WhereEveryBeadIsOneFaceNothingIsJoined) {
  EXPECT_TRUE(composite_faces(plate_of_every_kind()).empty());
}

TEST(CompositeFaces, RingsThatShareALoopStayApart) {
  BeadPlate plate(160, 160);
  plate.add(examples::circular_ring(60, 14), 5);
  plate.add_ring_inside({0, 0}, 46, 14, -5);
  plate.add_ring_inside({0, 0}, 32, 14, 5);  // all three together would pass as one wide ring
  EXPECT_TRUE(composite_faces(plate.take()).empty());
}

TEST(CompositeFaces, RingsOfManyFacesThatShareALoopAreRingsOfTheirOwn) {
  BeadPlate plate(160, 160);
  plate.add(examples::circular_ring(60, 14), 5);
  plate.add_ring_inside({0, 0}, 46, 14, -5);
  plate.add_ring_inside({0, 0}, 32, 14, 5);
  const Panel panel = split_plate(plate.take(), {0, 1, 2}, flat_base);
  ASSERT_EQ(verify_panel(panel), std::vector<std::string>{});
  const BeadTable table = recognise_beads(compose_faces(panel));
  ASSERT_EQ(table.beads.size(), 3u);
  for (const Bead& bead : table.beads) {
    EXPECT_EQ(bead.kind, BeadKind::annular);
    EXPECT_NEAR(bead.width, 14, 0.5);
  }
}

TEST(CompositeFaces, AWideEmbossIsOneFaceButNoBead) {
  BeadPlate plate(160, 160);
  Footprint emboss;
  emboss.loops = {examples::circle(30)};
  emboss.half_width = 30;
  plate.add(emboss, 6);
  const Panel panel = split_plate(plate.take(), {0}, flat_base);
  const Panel composed = compose_faces(panel);
  EXPECT_EQ(composed.faces.size(), 2u);
  const BeadTable table = recognise_beads(composed);
  EXPECT_TRUE(table.beads.empty());
  EXPECT_EQ(table.faces_not_beads.size(), panel.faces.size()) << "each face of the input has its reason";
}

TEST(CompositeFaces, TheOrderOfFacesHasNoMeaning) {
  const Panel panel = split_plate(plate_of_every_kind(), {2, 1, 0}, cylinder_base(900));
  EXPECT_EQ(recognise_beads(compose_faces(panel)).beads.size(), 3u);
}

/// A pad whose wall stands on the sheet with a sharp edge, 60 degrees steep.
TEST(CompositeFaces, MaterialBehindASharpEdgeIsNoFeature) {
  PlanPanel plan(flat_base, 2);
  const auto inside = std::make_shared<examples::BoundaryDistance>(examples::straight_bead(60, 16).loops);
  const auto points = points_of(examples::straight_bead(60, 16).loops[0], 1.5);
  const int loop = plan.add_loop(points);
  plan.add_face(loop, {}, [=](Vec2 p) {
    return Vec3{p.x, p.y, std::min(5.0, 1.7 * std::max(0.0, (*inside)(p)))};
  });
  plan.add_face(plan.add_loop({{-80, -50}, {80, -50}, {80, 50}, {-80, 50}}, {0, 1, 2, 3}), {loop},
                on(flat_base), 6);
  Panel panel = test::with_segment_edges(plan.take());
  test::FaceSplitter(panel, 0).split([](Vec3 p) { return p.z > 4.5; });
  EXPECT_TRUE(composite_faces(panel).empty());
  const std::vector<GroupDecision> decisions = group_decisions(panel);
  ASSERT_EQ(decisions.size(), 1u);
  EXPECT_EQ(decisions[0].verdict, GroupVerdict::left);
  EXPECT_EQ(decisions[0].faces, (std::vector<Index>{0, 2}));
  EXPECT_NE(decisions[0].reason.find("degrees, over 25"), std::string::npos) << decisions[0].reason;
  CompositeOptions options;
  options.feature_angle = radians(80);
  EXPECT_EQ(composite_faces(panel, options).size(), 1u) << "nothing else keeps it apart";
}

}  // namespace
}  // namespace beadmesh
