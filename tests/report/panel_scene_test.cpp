#include "beadmesh/report/panel_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "beadmesh/report/packed_numbers.h"
#include "report/synthetic_panel.h"

namespace beadmesh {
namespace {

using Json = nlohmann::json;

std::vector<std::int32_t> numbers(const Json& json) {
  return unpacked({json["rows"], json["stride"], json["bytes"],
                   json["differences"] ? Packing::differences : Packing::plain, json["text"]});
}

class PanelScene : public testing::Test {
 protected:
  PanelScene() : made(test::synthetic_panel(90)) {
    scene = Json::parse(panel_scene(made.panel, made.mesh, {"t", {}, 2.5, criteria_of_sizes(5, 2.5)}));
  }

  test::SyntheticPanel made;
  Json scene;
};

TEST_F(PanelScene, HoldsNodesToAMillionthOfTheSize) {
  const auto steps = numbers(scene["mesh"]["nodes"]);
  const ShellMesh& mesh = made.mesh.mesh;
  ASSERT_EQ(steps.size(), 3 * mesh.nodes.size());
  const double step = scene["step"], size = 300;
  EXPECT_NEAR(step, size / 1e6, 1e-9);
  for (size_t i = 0; i < mesh.nodes.size(); ++i)
    EXPECT_NEAR(scene["origin"][0].get<double>() + steps[3 * i] * step, mesh.nodes[i].x, step / 2 + 1e-12);
}

TEST_F(PanelScene, HoldsElementsTheirFacesAndBeads) {
  const ShellMesh& mesh = made.mesh.mesh;
  const auto corners = numbers(scene["mesh"]["corners"]), runs = numbers(scene["mesh"]["runs"]);
  ASSERT_EQ(corners.size(), 4 * mesh.elements.size());
  for (size_t e = 0; e < mesh.elements.size(); ++e) {
    const MeshElement& nodes = mesh.elements[e].nodes;
    EXPECT_EQ(corners[4 * e + 2], nodes[2]);
    EXPECT_EQ(corners[4 * e + 3], nodes[3] == no_index ? nodes[2] : nodes[3]);
  }
  size_t e = 0;
  for (size_t r = 0; r < runs.size(); r += 3)
    for (int k = 0; k < runs[r + 2]; ++k, ++e) {
      EXPECT_EQ(runs[r], mesh.elements[e].face);
      EXPECT_EQ(runs[r + 1], mesh.elements[e].bead);
    }
  EXPECT_EQ(e, mesh.elements.size());
}

TEST_F(PanelScene, HoldsLinesOfEveryBead) {
  for (const char* name : {"crests", "axes", "blocks"}) {
    const auto counts = numbers(scene[name]["counts"]), beads = numbers(scene[name]["beads"]);
    ASSERT_EQ(counts.size(), beads.size());
    std::int32_t all = 0;
    for (const auto count : counts) all += count;
    EXPECT_EQ(numbers(scene[name]["points"]).size(), 3 * all) << name;
    EXPECT_EQ(std::count(beads.begin(), beads.end(), 3) > 0, true) << name;
  }
  EXPECT_EQ(numbers(scene["axes"]["thickness"]).size(), numbers(scene["axes"]["points"]).size() / 3);
  // The ring is closed: its first point comes again.
  const auto counts = numbers(scene["crests"]["counts"]);
  EXPECT_EQ(counts.back(), 91);
}

TEST_F(PanelScene, NamesTheFailingElements) {
  for (const Json& measure : scene["mesh"]["measures"]) {
    const auto values = numbers(measure["values"]);
    EXPECT_EQ(values.size(), made.mesh.mesh.elements.size());
    EXPECT_EQ(*std::max_element(values.begin(), values.end()), measure["low"] < measure["high"] ? 65535 : 0);
    if (measure["name"] == "min length") {  // cells of 3.33 mm
      EXPECT_TRUE(numbers(measure["failing"]).empty());
    }
    if (measure["name"] == "min angle") {
      EXPECT_EQ(measure["limit"], 40);
    }
  }
}

TEST(PanelSceneAlone, StandsInAScriptElement) {
  test::SyntheticPanel made = test::synthetic_panel(60);
  made.mesh.table.beads[0].shape = "</script>\xff";
  const std::string text = panel_scene(made.panel, made.mesh, {"<!--", {}});
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(Json::parse(text)["title"], "<!--");
}

}  // namespace
}  // namespace beadmesh
