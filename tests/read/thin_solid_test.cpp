#include "beadmesh/panel/thin_solid.h"

#include <gtest/gtest.h>

#include "beadmesh/read/panel_reader.h"
#include "read/cad_shapes.h"

namespace beadmesh {
namespace {

Panel read_back(const TopoDS_Shape& shape, Skin skin) {
  const test::TemporaryFolder folder;
  test::write_shape(shape, folder / "solid.step");
  ReadOptions options;
  options.skin = skin;
  const Result<Panel> panel = read_panel(folder / "solid.step", options);
  EXPECT_TRUE(panel) << (panel ? "" : panel.error().message);
  if (!panel) return {};
  EXPECT_EQ(verify_panel(*panel), std::vector<std::string>{});
  return *panel;
}

std::vector<std::string> codes_of(const Panel& panel) {
  std::vector<std::string> codes;
  for (const Diagnostic& d : panel.diagnostics) codes.push_back(d.code);
  return codes;
}

TEST(ThinSolid, APlateBecomesOneOfItsSides) {
  for (const auto& [skin, faces] : {std::pair{Skin::outer, 1u}, {Skin::inner, 1u}, {Skin::whole, 6u}}) {
    const Panel panel = read_back(test::box(100, 60, 1.5), skin);
    ASSERT_EQ(panel.faces.size(), faces);
    EXPECT_NEAR(panel.faces[0].thickness, skin == Skin::whole ? 0 : 1.5, 1e-9);
  }
}

TEST(ThinSolid, TheMiddleSkinLiesHalfwayBetweenTheSides) {
  const Panel panel = read_back(test::box(100, 60, 1.5), Skin::middle);
  ASSERT_EQ(panel.faces.size(), 1u);
  for (const Vec3 p : panel.points) EXPECT_NEAR(p.z, 0.75, 1e-9);
  EXPECT_EQ(codes_of(panel), std::vector<std::string>{"read.skin"});
}

/// A bent sheet: two flat walls, a rounded bend between them; outside 4 mm, inside 2.5 mm.
TEST(ThinSolid, ABentSheetKeepsItsBend) {
  const Panel outer = read_back(test::bent_sheet(60, 40, 4, 1.5), Skin::outer);
  const Panel inner = read_back(test::bent_sheet(60, 40, 4, 1.5), Skin::inner);
  const Panel middle = read_back(test::bent_sheet(60, 40, 4, 1.5), Skin::middle);
  ASSERT_EQ(outer.faces.size(), 3u);
  ASSERT_EQ(inner.faces.size(), 3u);
  const auto area_of = [](const Panel& panel) {
    double sum = 0;
    for (const PanelFace& face : panel.faces) {
      sum += area(face.facets);
      EXPECT_NEAR(face.thickness, 1.5, 0.01);
    }
    return sum;
  };
  const double flat = 40 * (60 - 4) * 2, quarter = 40 * pi / 2;
  EXPECT_NEAR(area_of(outer), flat + quarter * 4, 2);
  EXPECT_NEAR(area_of(inner), flat + quarter * 2.5, 2);
  EXPECT_NEAR(area_of(middle), flat + quarter * 3.25, 2);
}

TEST(ThinSolid, WhatIsNoSheetStaysWholeAndIsNamed) {
  for (const TopoDS_Shape& shape : {test::box(30, 20, 10), test::cylinder(8, 20)}) {
    const Panel panel = read_back(shape, Skin::outer);
    EXPECT_GE(panel.faces.size(), 3u);
    EXPECT_EQ(codes_of(panel), std::vector<std::string>{"read.solid"});
    for (const PanelFace& face : panel.faces) EXPECT_EQ(face.thickness, 0);
  }
}

TEST(ThinSolid, AnOpenSkinStaysAsItIs) {
  const Panel panel = read_back(test::plate_with_hole(), Skin::middle);
  EXPECT_EQ(panel.faces.size(), 1u);
  EXPECT_TRUE(panel.diagnostics.empty());
  for (const Vec3 p : panel.points) EXPECT_EQ(p.z, 0);
}

}  // namespace
}  // namespace beadmesh
