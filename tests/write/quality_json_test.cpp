#include "beadmesh/write/quality_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace beadmesh {
namespace {

TEST(QualityJson, HoldsTheMeshObjectOfTheBeadSchema) {
  QualitySummary quality;
  quality.nodes = 9, quality.quads = 4, quality.warpage_max = 1.5, quality.edges_below_min = 2;
  const auto object = nlohmann::json::parse(quality_json("a.bdf", quality, 5, 0));
  EXPECT_EQ(object["schema"], "beadmesh.check/1");
  EXPECT_EQ(object["input"], "a.bdf");
  EXPECT_EQ(object["size"], 5.0);
  EXPECT_TRUE(object["min_edge"].is_null());
  EXPECT_EQ(object["mesh"]["nodes"], 9);
  EXPECT_EQ(object["mesh"]["quality"]["warpage_max"], 1.5);
  EXPECT_EQ(object["mesh"]["quality"]["edges_below_min"], 2);
}

TEST(QualityJson, PartsAndBeadsWithNumbersOfTheDeck) {
  const std::vector<Vec3> nodes = {{0, 0, 0}, {5, 0, 0}, {5, 5, 0}, {0, 5, 0}, {5, 1, 0}, {0, 1, 0}};
  const std::vector<MeshElement> elements = {{0, 1, 2, 3}, {0, 1, 4, 5}};
  const JudgedMesh judged =
      judge(nodes, elements, *criteria_of_preset("crash"), {{"property 7", {0, 1}}}, {{"bead 3", {1}}});
  const auto object = nlohmann::json::parse(quality_json("a.bdf", {}, 5, 0, judged, {901, 905}));
  ASSERT_EQ(object["parts"].size(), 2);
  EXPECT_EQ(object["parts"][0]["measures"][0]["element"], 905);
  EXPECT_EQ(object["parts"][1]["failing"], 1);
  ASSERT_EQ(object["beads"].size(), 1);
  EXPECT_EQ(object["beads"][0]["name"], "bead 3");
  EXPECT_EQ(object["beads"][0]["elements"], 1);
  EXPECT_TRUE(object["parts"][0]["measures"][11]["element"].is_null());
}

}  // namespace
}  // namespace beadmesh
