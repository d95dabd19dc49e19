#include "beadmesh/report/panel_svg.h"

#include <gtest/gtest.h>

#include <string>

#include "report/well_formed.h"
#include "write/bead_plate.h"

namespace beadmesh {
namespace {

using test::count;
using test::plate;

TEST(PanelSvg, IsWellFormedAndSaysWhatItShows) {
  PanelMesh panel = plate();
  panel.mesh.title = "a <b> & \"c\".step";
  const std::string svg = panel_svg(panel);
  EXPECT_EQ(test::first_fault(svg), "");
  EXPECT_NE(svg.find("a &lt;b&gt; &amp; &quot;c&quot;.step"), std::string::npos);
  EXPECT_NE(svg.find("1 beads, 231 nodes, 200 quads, 0 triangles"), std::string::npos);
  EXPECT_NE(svg.find(">1 I</text>"), std::string::npos);
  EXPECT_NE(svg.find("I bead"), std::string::npos);
  EXPECT_EQ(svg.find("annular bead"), std::string::npos);
  EXPECT_NE(svg.find("id=\"crests\""), std::string::npos);
}

TEST(PanelSvg, PaintsEveryElementOnceInFewPaths) {
  const std::string svg = panel_svg(plate());
  const std::string mesh =
      svg.substr(svg.find("<g id=\"mesh\""), svg.find("</g>") - svg.find("<g id=\"mesh\""));
  EXPECT_EQ(count(mesh, "z"), 200);
  EXPECT_LE(count(mesh, "<path"), 14);
}

TEST(PanelSvg, MarksTheFallback) {
  PanelMesh panel = plate();
  panel.meshing[0].method = "fallback";
  EXPECT_NE(panel_svg(panel).find("bead, fallback"), std::string::npos);
}

TEST(PanelSvg, FiftyThousandQuadsStayUnderEightMegabytes) {
  PanelMesh panel = plate();
  panel.mesh = test::plate_mesh(250, 200);
  EXPECT_LT(panel_svg(panel).size(), 8'000'000);
}

TEST(PanelSvg, LooksAlongTheGivenDirection) {
  PanelPictureOptions side;
  side.view = {0, -1, 0};  // the plate is 100 mm long and 4 mm high from there
  const std::string top = panel_svg(plate()), front = panel_svg(plate(), side);
  const auto height = [](const std::string& svg) { return std::stod(svg.substr(svg.find("height=\"") + 8)); };
  EXPECT_GT(height(top), 700);
  EXPECT_LT(height(front), 300);
}

TEST(PanelSvg, ATurnedMeshIsDrawnFromTheSameSide) {
  PanelMesh turned = plate();
  for (ShellElement& element : turned.mesh.elements) std::swap(element.nodes[1], element.nodes[3]);
  const auto label = [](const std::string& svg) {
    return svg.substr(svg.find("<text", svg.find("id=\"labels\"")), 40);
  };
  EXPECT_EQ(label(panel_svg(turned)), label(panel_svg(plate())));
}

TEST(PanelSvg, AnEmptyMeshStillIsAPicture) {
  EXPECT_EQ(test::first_fault(panel_svg(PanelMesh{})), "");
}

}  // namespace
}  // namespace beadmesh
