#include "beadmesh/report/element_measures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace beadmesh {
namespace {

/// A square of 5 mm, a bar of 10 by 2 mm, a triangle.
ShellMesh three_elements() {
  ShellMesh mesh;
  mesh.nodes = {{0, 0, 0}, {5, 0, 0}, {5, 5, 0}, {0, 5, 0}, {15, 0, 0}, {15, 2, 0}, {5, 2, 0}, {0, 10, 0}};
  mesh.elements = {{{0, 1, 2, 3}, 0, 1, 0}, {{1, 4, 5, 6}, 0, 1, 0}, {{3, 2, 7, no_index}, 0, 1, 0}};
  return mesh;
}

const ElementMeasure& named(const std::vector<ElementMeasure>& all, const std::string& name) {
  for (const ElementMeasure& measure : all)
    if (measure.name == name) return measure;
  ADD_FAILURE() << "no " << name;
  return all.front();
}

TEST(ElementMeasures, AreThoseOfTheElements) {
  const auto all = element_measures(three_elements(), criteria_of_sizes(5, 2.5));
  EXPECT_EQ(all.size(), 9);
  EXPECT_NEAR(*named(all, "scaled Jacobian").values[0], 1, 1e-12);
  const ElementMeasure& shortest = named(all, "min length");
  EXPECT_NEAR(*shortest.values[1], 2, 1e-12);
  EXPECT_NEAR(shortest.low, 2, 1e-12);
  EXPECT_NEAR(shortest.high, 5, 1e-12);
  EXPECT_NEAR(*named(all, "aspect ratio").values[1], 5, 1e-12);
  EXPECT_FALSE(named(all, "warpage").values[2].has_value());
}

TEST(ElementMeasures, FailAsTheCriteriaSay) {
  const auto all = element_measures(three_elements(), criteria_of_sizes(5, 2.5));
  EXPECT_EQ(named(all, "min length").failing, (std::vector<bool>{false, true, false}));
  EXPECT_EQ(named(all, "max length").failing, (std::vector<bool>{false, false, false}));
  EXPECT_EQ(*named(all, "min length").limit, 2.5);
}

TEST(ElementMeasures, AnglesOfTrianglesHaveTheLimitsOfTriangles) {
  QualityCriteria criteria = criteria_of_sizes(5, 2.5);
  criteria[QualityMeasure::min_angle_tria].fail = 46;
  EXPECT_TRUE(named(element_measures(three_elements(), criteria), "min angle").failing[2]);
  criteria[QualityMeasure::min_angle_tria].on = false;
  EXPECT_FALSE(named(element_measures(three_elements(), criteria), "min angle").failing[2]);
}

TEST(ElementMeasures, WithoutLimitsOnlyInversionFails) {
  ShellMesh mesh = three_elements();
  std::swap(mesh.nodes[2], mesh.nodes[3]);  // the square crosses itself
  const auto all = element_measures(mesh, std::nullopt);
  EXPECT_TRUE(named(all, "scaled Jacobian").failing[0]);
  for (const ElementMeasure& measure : all)
    EXPECT_EQ(measure.limit.has_value(), measure.name == "scaled Jacobian") << measure.name;
}

TEST(ElementMeasures, ValuesAreFinite) {
  ShellMesh mesh = three_elements();
  mesh.nodes[4] = mesh.nodes[1];
  for (const ElementMeasure& measure : element_measures(mesh, criteria_of_sizes(5, 2.5)))
    for (const auto& value : measure.values)
      EXPECT_TRUE(!value || (std::isfinite(*value) && std::abs(*value) <= 1e6)) << measure.name;
}

}  // namespace
}  // namespace beadmesh
