#include "examples/shape_panels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "examples/clearance.h"
#include "examples/shape_catalogue.h"
#include "examples/truth.h"

namespace beadmesh::examples {
namespace {

std::set<std::string> names_in(const PanelDesign& panel) {
  std::set<std::string> names;
  for (const Feature& feature : panel.features) names.insert(feature.name);
  return names;
}

TEST(ShapeCatalogue, HoldsEveryBeadOfTheTableAndEveryRing) {
  std::set<std::string> shapes, names;
  for (const CatalogueShape& shape : shape_catalogue()) {
    shapes.insert(shape.shape);
    EXPECT_TRUE(names.insert(shape.name).second) << shape.name << " is there twice";
  }
  for (const char* shape : {"I", "arc", "S", "T", "Y", "X", "L", "J", "U", "G", "H", "F", "trident", "comb",
                            "ladder", "tree", "ring"})
    EXPECT_TRUE(shapes.count(shape)) << shape;
  for (const char* name : {"straight", "tapered", "wavy", "curved-comb", "ladder-of-two", "circle", "oval",
                           "rectangle", "eccentric", "circle-in-oval", "corrugated"})
    EXPECT_TRUE(names.count(name)) << name;
}

TEST(ShapesPanel, HasEachShapeOnceAndTheRingsOfTheCluster) {
  const PanelDesign panel = *shapes_panel({});
  EXPECT_EQ(names_in(panel).size(), shape_catalogue().size());
  EXPECT_EQ(panel.features.size(), shape_catalogue().size() + 2);
  EXPECT_TRUE(panel.base.is_flat());
}

TEST(ShapesPanel, KeepsWhatItIsTold) {
  const ShapePanelOptions options{
      .width = 20, .height = -4, .base = BaseKind::saddle, .radius = 900, .only = {"T", "circle"}};
  const PanelDesign panel = *shapes_panel(options);
  EXPECT_EQ(names_in(panel), (std::set<std::string>{"T", "circle"}));
  for (const FeatureTruth& truth : truth_of(panel)) {
    EXPECT_DOUBLE_EQ(truth.width, 20);
    EXPECT_DOUBLE_EQ(truth.height, 4);
  }
  EXPECT_DOUBLE_EQ(panel.features.front().height, -4);
  EXPECT_DOUBLE_EQ(panel.base.xx, -1 / 1800.0);
  EXPECT_GT(panel.base.yy, 0);
  EXPECT_FALSE(shapes_panel({.only = {"T", "Q"}}));
}

TEST(ShapesPanel, BeadsKeepClearAtEveryWidth) {
  for (const double width : {8.0, 16.0, 40.0}) {
    expect_clear(*shapes_panel({.width = width}), "shapes");
    expect_clear(*shapes_panel({.width = width, .seed = 11}), "turned shapes");
  }
}

TEST(ShapesPanel, SeedTurnsAndStretches) {
  const Feature plain = shapes_panel({.only = {"T"}})->features.front();
  const Feature turned = shapes_panel({.seed = 4, .only = {"T"}})->features.front();
  EXPECT_DOUBLE_EQ(plain.angle, 0);
  EXPECT_NE(turned.angle, 0);
  EXPECT_NE(turned.footprint.centreline_length, plain.footprint.centreline_length);
  EXPECT_NEAR(turned.footprint.centreline_length / plain.footprint.centreline_length, 1, 0.12);
}

TEST(RandomPanel, IsTheSameForTheSameSeedOnly) {
  EXPECT_EQ(truth_json(random_panel({.seed = 2})), truth_json(random_panel({.seed = 2})));
  EXPECT_NE(truth_json(random_panel({.seed = 2})), truth_json(random_panel({.seed = 3})));
}

TEST(RandomPanel, KeepsClearAndWithinItsLimits) {
  std::set<std::string> shapes;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const PanelDesign panel = random_panel({.seed = seed});
    expect_clear(panel, panel.name);
    EXPECT_GE(panel.features.size(), 10);
    for (const Feature& feature : panel.features) {
      shapes.insert(feature.shape);
      if (feature.profile != Profile::bead) continue;
      EXPECT_GE(std::abs(feature.height), 2);
      EXPECT_LE(std::abs(feature.height), 10);
      EXPECT_GT(feature.footprint.mean_width, 7.9);
      EXPECT_LT(feature.footprint.mean_width, 60);  // an oval round a circle is wider at its ends
    }
  }
  EXPECT_GT(shapes.size(), 12);
  EXPECT_TRUE(shapes.count("hole") && shapes.count("slot"));
}

TEST(RandomPanel, ArmsOfOneFeatureKeepClear) {
  // Had a G of 9 mm width whose end came to 2.25 mm from its own side.
  const PanelDesign panel =
      random_panel({.seed = 56, .beads = 12, .base = BaseKind::saddle, .length = 293.9, .width = 229.2});
  for (const Feature& feature : panel.features) {
    const PlanLoop loop = feature.loops().front();
    const BoundaryDistance inside({loop});
    const std::vector<Vec2> points = sampled(loop);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 along =
          normalized(points[(i + 1) % points.size()] - points[(i + points.size() - 1) % points.size()]);
      EXPECT_LE(inside(points[i] + Vec2{along.y, -along.x} * 4.5), 0) << feature.shape;
    }
  }
}

TEST(RandomPanel, BaseIsAsAsked) {
  EXPECT_TRUE(random_panel({.seed = 1, .base = BaseKind::flat}).base.is_flat());
  EXPECT_GT(random_panel({.seed = 1, .base = BaseKind::cylinder}).base.radius, 0);
}

}  // namespace
}  // namespace beadmesh::examples
