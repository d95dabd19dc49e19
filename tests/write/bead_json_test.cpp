#include "beadmesh/write/bead_json.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "write/bead_plate.h"

namespace beadmesh {
namespace {

using nlohmann::json;
using test::plate;
using test::plate_panel;
using test::plate_table;

TEST(BeadJson, FollowsTheSchema) {
  const json object = json::parse(bead_json(plate_panel(), plate_table()));
  EXPECT_EQ(object["schema"], "beadmesh.beads/1");
  EXPECT_EQ(object["input"], "plate.step");
  EXPECT_EQ(object["unit"], "mm");
  ASSERT_EQ(object["beads"].size(), 1);
  const json& bead = object["beads"][0];
  EXPECT_EQ(bead["id"], 1);
  EXPECT_EQ(bead["kind"], "I");
  EXPECT_EQ(bead["shape"], "I");
  EXPECT_EQ(bead["faces"], json::array({2}));
  EXPECT_EQ(bead["point"], json::array({50.0, 25.0, 4.0}));
  EXPECT_EQ(bead["length"], 40.0);
  EXPECT_EQ(bead["confidence"], 1.0);
  EXPECT_EQ(bead["ends"], 2);
  EXPECT_EQ(bead["ridge"], json::parse("[[[30.0, 25.0, 4.0], [70.0, 25.0, 4.0]]]"));
  EXPECT_FALSE(bead.contains("mesh"));
  EXPECT_FALSE(object.contains("mesh"));
  EXPECT_EQ(object["faces_not_beads"], json::parse(R"([{"face": 1, "reason": "aspect ratio 1.1 < 2.0"}])"));
  EXPECT_EQ(object["diagnostics"], json::array());
}

TEST(BeadJson, SaysHowTheBeadsWereMeshed) {
  const json object = json::parse(bead_json(plate_panel(), plate()));
  EXPECT_EQ(object["beads"][0]["mesh"],
            json::parse(R"({"method": "blocks", "elements": 48, "elements_across": 4,
      "size": 5.0, "min_edge": 2.5, "notes": []})"));
  EXPECT_EQ(object["mesh"]["nodes"], 231);
  EXPECT_EQ(object["mesh"]["quads"], 200);
  EXPECT_EQ(object["mesh"]["trias"], 0);
  EXPECT_EQ(object["mesh"]["quality"]["scaled_jacobian_min"], 0.83);
}

TEST(BeadJson, FacesKeepTheirNumbersWhenOneWasLeftOut) {
  Panel panel = plate_panel();
  panel.faces[1].number = 12;
  EXPECT_EQ(json::parse(bead_json(panel, plate_table()))["beads"][0]["faces"], json::array({12}));
}

TEST(BeadJson, AClosedRidgeEndsWhereItBegan) {
  BeadTable table = plate_table();
  table.beads[0].ridge = {{{{0, 0}, {1, 0}, {0, 1}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, true}};
  const json ridge = json::parse(bead_json(plate_panel(), table))["beads"][0]["ridge"][0];
  ASSERT_EQ(ridge.size(), 4);
  EXPECT_EQ(ridge.front(), ridge.back());
}

TEST(BeadJson, ListsTheDiagnostics) {
  BeadTable table = plate_table();
  table.diagnostics = {{"read.face", Severity::warning, 3, "", "left out", "repair it"},
                       {"bead.medial", Severity::note, no_index, "loop 2", "skipped", ""}};
  const json list = json::parse(bead_json(plate_panel(), table))["diagnostics"];
  ASSERT_EQ(list.size(), 2);
  EXPECT_EQ(list[0], json::parse(R"({"code": "read.face", "severity": "warning", "face": 3, "entity": "",
                                     "message": "left out", "hint": "repair it"})"));
  EXPECT_TRUE(list[1]["face"].is_null());
}

TEST(BeadJson, RoundsAndSurvivesOddValues) {
  Panel panel = plate_panel();
  panel.input = "caf\xE9 \"x\".step";  // Latin-1, no UTF-8
  BeadTable table = plate_table();
  table.beads[0].length = 1.0 / 3;
  table.beads[0].width = std::numeric_limits<double>::quiet_NaN();
  table.beads[0].point = {-1e-9, 1e-9, 0.1 + 0.2};
  const std::string text = bead_json(panel, table);
  const json bead = json::parse(text)["beads"][0];
  EXPECT_EQ(bead["length"].dump(), "0.333333");
  EXPECT_TRUE(bead["width"].is_null());
  EXPECT_EQ(bead["point"].dump(), "[0.0,0.0,0.3]");
  EXPECT_EQ(text, bead_json(panel, table));
}

}  // namespace
}  // namespace beadmesh
