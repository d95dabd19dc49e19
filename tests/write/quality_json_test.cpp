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

}  // namespace
}  // namespace beadmesh
