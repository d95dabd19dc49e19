#include "beadmesh/mesh/bead_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace beadmesh {
namespace {

/// A bead whose face is one square of side 10 in the plane z = 0, with its corner at (x, 0).
PanelFace square_at(double x) {
  PanelFace face;
  face.facets.points = {{x, 0, 0}, {x + 10, 0, 0}, {x + 10, 10, 0}, {x, 10, 0}};
  face.facets.triangles = {{0, 1, 2}, {0, 2, 3}};
  return face;
}

struct ThreeBeads {
  ThreeBeads() {
    for (const auto& [x, kind] : {std::pair{0.0, BeadKind::I}, std::pair{20.0, BeadKind::generic},
                                  std::pair{40.0, BeadKind::annular}}) {
      Bead bead;
      bead.id = Index(table.beads.size()) + 1;
      bead.kind = kind;
      bead.faces = {Index(panel.faces.size())};
      bead.width = 8;
      panel.faces.push_back(square_at(x));
      table.beads.push_back(bead);
    }
  }
  Result<std::vector<BeadMeshControl>> resolve(const BeadControls& controls) const {
    return controls_of_beads(controls, panel, table, 5, 2.5);
  }

  Panel panel;
  BeadTable table;
};

BeadMeshControl across(int m) {
  BeadMeshControl control;
  control.elements_across = m;
  return control;
}

TEST(BeadControl, TheSpecialWinsOverTheGeneralAndTheLaterOverTheEarlier) {
  BeadControls controls;
  controls.all = across(2);
  controls.all.clamp_rows = 3;
  controls.of(BeadKind::generic) = across(4);
  controls.single = {{{3, {}}, across(6)}, {{3, {}}, across(8)}};
  const auto resolved = ThreeBeads().resolve(controls);
  ASSERT_TRUE(resolved) << resolved.error().message;
  EXPECT_EQ((*resolved)[0].elements_across, 2);
  EXPECT_EQ((*resolved)[1].elements_across, 4);
  EXPECT_EQ((*resolved)[2].elements_across, 8);
  for (const BeadMeshControl& control : *resolved)
    EXPECT_EQ(control.clamp_rows, 3) << "what is not set stays";
}

TEST(BeadControl, APointMeansTheBeadWhoseFaceIsNearest) {
  const ThreeBeads beads;
  for (const auto& [point, bead] : {std::pair{Vec3{25, 5, 3}, 1}, std::pair{Vec3{31, 12, 0}, 1},
                                    std::pair{Vec3{39, 5, 0}, 2}, std::pair{Vec3{-2, -2, -2}, 0}}) {
    BeadControls controls;
    controls.single = {{{0, point}, across(6)}};
    const auto resolved = beads.resolve(controls);
    ASSERT_TRUE(resolved) << resolved.error().message;
    for (int b = 0; b < 3; ++b) EXPECT_EQ((*resolved)[b].elements_across.has_value(), b == bead) << point.x;
  }
}

TEST(BeadControl, ASelectionThatMeansNoBeadIsAnError) {
  for (const BeadSelection& selection : {BeadSelection{4, {}}, BeadSelection{0, {25, 5, 4.1}}}) {
    BeadControls controls;
    controls.single = {{selection, across(6)}};
    const auto resolved = ThreeBeads().resolve(controls);
    ASSERT_FALSE(resolved);
    EXPECT_EQ(resolved.error().code, "control.bead");
    EXPECT_FALSE(resolved.error().hint.empty());
  }
  BeadControls controls;
  controls.single = {{{0, {}}, across(6)}};
  EXPECT_FALSE(controls_of_beads(controls, Panel{}, BeadTable{}, 5, 2.5)) << "no beads at all";
}

std::string fault_of(const BeadMeshControl& control) {
  const auto good = check_control(control, 5, 2.5);
  return good ? "" : good.error().code;
}

TEST(BeadControl, ValuesThatMakeNoSenseAreRefused) {
  for (const int m : {0, -2, 3, 7, 1000}) EXPECT_EQ(fault_of(across(m)), "control.elements_across") << m;
  for (const int m : {1, 2, 4, 20}) EXPECT_EQ(fault_of(across(m)), "") << m;
  const auto fault = [](auto member, auto value) {
    BeadMeshControl control;
    control.*member = value;
    return fault_of(control);
  };
  EXPECT_EQ(fault(&BeadMeshControl::elements_along, 0), "control.elements_along");
  EXPECT_EQ(fault(&BeadMeshControl::clamp_rows, -1), "control.clamp_rows");
  for (const double size : {0.0, -1.0, std::nan(""), HUGE_VAL, 2.4})
    EXPECT_EQ(fault(&BeadMeshControl::size, size), "control.size") << size;
  EXPECT_EQ(fault(&BeadMeshControl::size, 2.5), "");
  EXPECT_EQ(fault(&BeadMeshControl::min_edge, 2.4), "control.min_edge") << "that of the panel is hard";
  EXPECT_EQ(fault(&BeadMeshControl::min_edge, 6.0), "control.size") << "above the size of the panel";
  EXPECT_EQ(fault(&BeadMeshControl::min_edge, 4.0), "");
}

TEST(BeadControl, LayersThatDoNotFitTogetherAreRefused) {
  BeadControls controls;
  controls.all.size = 3;
  controls.of(BeadKind::I).min_edge = 4;
  const auto resolved = ThreeBeads().resolve(controls);
  ASSERT_FALSE(resolved);
  EXPECT_EQ(resolved.error().code, "control.size");
}

TEST(BeadControl, MethodsHaveNames) {
  EXPECT_EQ(bead_method_of("automatic"), BeadMethod::automatic);
  EXPECT_EQ(bead_method_of("blocks"), BeadMethod::blocks);
  EXPECT_EQ(bead_method_of("ridge"), BeadMethod::ridge);
  EXPECT_EQ(bead_method_of("face"), BeadMethod::face);
  EXPECT_FALSE(bead_method_of("paint"));
}

}  // namespace
}  // namespace beadmesh
