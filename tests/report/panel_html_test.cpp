#include "beadmesh/report/panel_html.h"

#include <gtest/gtest.h>

#include <string>

#include "report/well_formed.h"
#include "write/bead_plate.h"

namespace beadmesh {
namespace {

using test::plate;
using test::plate_panel;

TEST(PanelHtml, HoldsPictureTablesAndSettings) {
  PanelMesh mesh = plate();
  mesh.table.diagnostics = {{"read.face", Severity::warning, 3, "", "left out <now>", "repair it"}};
  mesh.meshing[0] = {"fallback", 48, {"end cap too short"}};
  const std::string html = panel_html(plate_panel(), mesh, {"plate.step", {{"size", "5 mm"}}});
  for (const char* part :
       {"<title>plate.step</title>", "size <b>5 mm</b>", "<svg ", "aspect ratio 1.1 &lt; 2.0",
        "end cap too short", "left out &lt;now&gt;", "class=\"fallback\"", "<b>231</b><small>nodes</small>"})
    EXPECT_NE(html.find(part), std::string::npos) << part;
}

TEST(PanelHtml, NeedsNoNetwork) {
  const std::string html = panel_html(plate_panel(), plate(), {"plate", {}});
  EXPECT_EQ(test::count(html, "http"), 1);  // the name space of SVG
  EXPECT_EQ(html.find(" src="), std::string::npos);
  EXPECT_EQ(html.find("<link"), std::string::npos);
}

TEST(PanelHtml, SaysNoneWhereThereIsNothing) {
  EXPECT_EQ(test::count(panel_html(Panel{}, PanelMesh{}, {"empty", {}}), "None."), 3);
}

}  // namespace
}  // namespace beadmesh
