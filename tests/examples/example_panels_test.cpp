#include "examples/example_panels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "examples/truth.h"

namespace beadmesh::examples {
namespace {

/// Least distance between two loops; 0 where they coincide.
double clearance(const PlanLoop& a, const PlanLoop& b) {
  const BoundaryDistance to_b({b});
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2 p : sampled(a)) least = std::min(least, std::abs(to_b(p)));
  return least;
}

bool coincide(const PlanLoop& a, const PlanLoop& b) {
  return a.size() == b.size() && distance(a.front().centre, b.front().centre) < 1e-9 &&
         std::abs(a.front().radius - b.front().radius) < 1e-9;
}

TEST(ExamplePanels, FeaturesKeepClearOfEachOtherAndOfTheEdge) {
  for (const std::string& name : example_names()) {
    const PanelDesign panel = *example_panel(name);
    for (std::size_t i = 0; i < panel.features.size(); ++i)
      for (const PlanLoop& loop : panel.features[i].loops()) {
        EXPECT_GT(clearance(loop, panel.outline()), 5) << name << " feature " << i;
        for (std::size_t j = 0; j < i; ++j)
          for (const PlanLoop& other : panel.features[j].loops()) {
            if (coincide(loop, other)) continue;
            EXPECT_GT(clearance(loop, other), 5) << name << " features " << i << ", " << j;
          }
      }
  }
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
