#include "examples/example_panels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "examples/clearance.h"
#include "examples/truth.h"

namespace beadmesh::examples {
namespace {

TEST(ExamplePanels, FeaturesKeepClearOfEachOtherAndOfTheEdge) {
  for (const std::string& name : example_names()) expect_clear(*example_panel(name), name);
}

TEST(ExamplePanels, BasicHasEveryKindAndWhatIsNoBead) {
  const PanelDesign panel = basic_panel();
  EXPECT_EQ(panel.count("I"), 2);
  EXPECT_EQ(panel.count("generic"), 1);
  EXPECT_EQ(panel.count("annular"), 1);
  EXPECT_EQ(panel.count(""), 2);
}

TEST(ExamplePanels, FloorShowsEveryShape) {
  const PanelDesign panel = floor_panel();
  for (const char* shape :
       {"I", "arc",  "S",       "T",      "Y",    "X",    "L",    "J",      "U",       "G",
        "H", "comb", "trident", "ladder", "ring", "hole", "slot", "emboss", "plateau", "pad"})
    EXPECT_TRUE(std::any_of(panel.features.begin(), panel.features.end(), [&](const Feature& f) {
      return f.shape == shape;
    })) << shape;
}

TEST(ExamplePanels, UnknownNameIsNoPanel) {
  EXPECT_FALSE(example_panel("flor"));
}

TEST(Truth, KnowsWhereAFeatureLies) {
  const std::vector<FeatureTruth> truth = truth_of(basic_panel());
  ASSERT_EQ(truth.size(), 6);
  EXPECT_TRUE(truth[0].contains({-68, 72}));
  EXPECT_FALSE(truth[0].contains({64, 68}));
  EXPECT_FALSE(truth[3].contains({70, -34})) << "the middle of the ring is sheet";
  EXPECT_DOUBLE_EQ(truth[0].length, 84);
  EXPECT_DOUBLE_EQ(truth[0].width, 18);
}

}  // namespace
}  // namespace beadmesh::examples
