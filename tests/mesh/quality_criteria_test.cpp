#include "beadmesh/mesh/quality_criteria.h"

#include <gtest/gtest.h>

#include <cmath>

#include "beadmesh/mesh/criteria_text.h"

namespace beadmesh {
namespace {

using enum QualityMeasure;

const MeshElement quad{0, 1, 2, 3};
const MeshElement triangle{0, 1, 2, no_index};

double value(const std::vector<Vec3>& nodes, const MeshElement& element, QualityMeasure measure) {
  const auto found = measured(nodes, element, measure);
  EXPECT_TRUE(found) << name_of(measure);
  return found.value_or(-1);
}

TEST(QualityMeasures, OfARectangle) {
  const std::vector<Vec3> nodes = {{0, 0, 0}, {8, 0, 0}, {8, 2, 0}, {0, 2, 0}};
  EXPECT_DOUBLE_EQ(value(nodes, quad, min_length), 2);
  EXPECT_DOUBLE_EQ(value(nodes, quad, max_length), 8);
  EXPECT_DOUBLE_EQ(value(nodes, quad, aspect_ratio), 4);
  EXPECT_NEAR(value(nodes, quad, warpage), 0, 1e-9);
  EXPECT_NEAR(value(nodes, quad, min_angle_quad), 90, 1e-9);
  EXPECT_NEAR(value(nodes, quad, max_angle_quad), 90, 1e-9);
  EXPECT_NEAR(value(nodes, quad, skew), 0, 1e-9);
  EXPECT_NEAR(value(nodes, quad, jacobian), 1, 1e-12);
}

TEST(QualityMeasures, SkewOfARhombusIsWhatItsAngleLacks) {
  const double a = radians(50);
  const std::vector<Vec3> nodes = {
      {0, 0, 0}, {1, 0, 0}, {1 + std::cos(a), std::sin(a), 0}, {std::cos(a), std::sin(a), 0}};
  EXPECT_NEAR(value(nodes, quad, skew), 40, 1e-9);
  EXPECT_NEAR(value(nodes, quad, min_angle_quad), 50, 1e-9);
  EXPECT_NEAR(value(nodes, quad, max_angle_quad), 130, 1e-9);
  EXPECT_NEAR(value(nodes, quad, jacobian), 1, 1e-12) << "a parallelogram maps linearly";
}

TEST(QualityMeasures, JacobianOfATrapezium) {
  // Sides 2 and 1, height 1: the determinant falls linearly from 2 to 1 along the height.
  const std::vector<Vec3> nodes = {{0, 0, 0}, {2, 0, 0}, {1.5, 1, 0}, {0.5, 1, 0}};
  const double g = 1 / std::sqrt(3.0);
  EXPECT_NEAR(value(nodes, quad, jacobian), (3 - g) / (3 + g), 1e-12);
}

TEST(QualityMeasures, WarpageOfAFoldedQuad) {
  const double fold = radians(20);
  const std::vector<Vec3> nodes = {{0, 0, 0}, {1, -1, 0}, {2, 0, 0}, {1, std::cos(fold), std::sin(fold)}};
  EXPECT_NEAR(value(nodes, quad, warpage), 20, 1e-6);
}

TEST(QualityMeasures, OfTriangles) {
  const std::vector<Vec3> even = {{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}};
  EXPECT_NEAR(value(even, triangle, skew), 0, 1e-9);
  EXPECT_NEAR(value(even, triangle, min_angle_tria), 60, 1e-9);
  EXPECT_EQ(value(even, triangle, jacobian), 1);
  EXPECT_FALSE(measured(even, triangle, warpage));
  EXPECT_FALSE(measured(even, triangle, min_angle_quad));
  EXPECT_FALSE(measured(even, triangle, chordal_deviation));
  // The worst corner is that at (0, 3): the line of its middles is level, the median falls by 3 over 2.
  const std::vector<Vec3> right = {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}};
  EXPECT_NEAR(value(right, triangle, skew), 90 - degrees(std::atan(1.5)), 1e-9);
}

TEST(QualityMeasures, ACollapsedQuadIsTheWorst) {
  const std::vector<Vec3> nodes = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const auto criteria = criteria_of_preset("crash");
  ASSERT_TRUE(criteria);
  EXPECT_TRUE((*criteria)[min_length].fails(value(nodes, quad, min_length)));
  EXPECT_TRUE((*criteria)[aspect_ratio].fails(value(nodes, quad, aspect_ratio)));
  EXPECT_TRUE((*criteria)[jacobian].fails(value(nodes, quad, jacobian)));
}

TEST(QualityCriteria, LimitsOfThePresets) {
  const auto crash = criteria_of_preset("crash"), nvh = criteria_of_preset("nvh");
  ASSERT_TRUE(crash && nvh && criteria_of_preset("durability"));
  EXPECT_FALSE(criteria_of_preset("cfd"));
  EXPECT_EQ((*crash)[min_length].fail, 2.5);
  EXPECT_EQ((*nvh)[max_length].fail, 20);
  EXPECT_EQ((*crash)[jacobian].fail, 0.6);
  EXPECT_FALSE((*crash)[jacobian].large_is_bad());
  EXPECT_TRUE((*crash)[skew].large_is_bad());
  EXPECT_FALSE((*crash)[min_length].fails(2.5)) << "the limit itself is allowed";
  EXPECT_TRUE((*crash)[min_length].fails(2.499));
}

TEST(QualityCriteria, LimitsOfSizesAreThoseOfThePresetOfTheseSizes) {
  for (const auto& [name, size, min_edge] :
       {std::tuple{"crash", 5.0, 2.5}, {"nvh", 10.0, 4.0}, {"durability", 5.0, 1.5}}) {
    const auto preset = *criteria_of_preset(name), same = criteria_of_sizes(size, min_edge);
    for (int m = 0; m < measure_count; ++m) {
      EXPECT_EQ(same.of[m].fail, preset.of[m].fail) << name << " " << m;
      EXPECT_EQ(same.of[m].on, preset.of[m].on) << name << " " << m;
    }
  }
  EXPECT_EQ(criteria_of_sizes(3, 1)[min_length].fail, 1);
  EXPECT_EQ(criteria_of_sizes(3, 1)[max_length].fail, 6);
}

TEST(QualityCriteria, CountsEachElementOnceAndNamesTheWorst) {
  // Two squares of 5 mm, one narrow quad, one triangle.
  const std::vector<Vec3> nodes = {{0, 0, 0}, {5, 0, 0},  {10, 0, 0}, {11, 0, 0}, {0, 5, 0},
                                   {5, 5, 0}, {10, 5, 0}, {11, 5, 0}, {14, 2, 0}};
  const std::vector<MeshElement> elements = {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 8, 7, no_index}};
  const auto criteria = criteria_of_preset("crash");
  const CriteriaFindings all = judge(nodes, elements, *criteria).parts[0].findings;
  EXPECT_EQ(all.elements, 4);
  EXPECT_EQ(all.failing, 1) << "short and slender, but one element";
  EXPECT_EQ(all[min_length].failed, 1);
  EXPECT_EQ(all[min_length].extreme_element, 2);
  EXPECT_DOUBLE_EQ(*all[min_length].extreme, 1);
  EXPECT_DOUBLE_EQ(*all[triangle_share].extreme, 25);
  EXPECT_EQ(all[triangle_share].failed, 1);
  EXPECT_NEAR(*all[chordal_deviation].extreme, 0, 1e-12);
  const JudgedMesh parts =
      judge(nodes, elements, *criteria, {{"good", {0, 1}}, {"rest", {2, 3}}}, {{"bead 1", {2}}});
  ASSERT_EQ(parts.parts.size(), 3);
  EXPECT_EQ(parts.parts[1].name, "good");
  EXPECT_TRUE(parts.parts[1].findings.holds());
  EXPECT_EQ(parts.parts[2].findings.failing, 1);
  EXPECT_DOUBLE_EQ(*parts.parts[2].findings[triangle_share].extreme, 50);
  ASSERT_EQ(parts.beads.size(), 1);
  EXPECT_EQ(parts.beads[0].findings.failing, 1);
  QualityCriteria off = *criteria;
  off[min_length].on = off[triangle_share].on = false;
  const CriteriaFindings loose = judge(nodes, elements, off).parts[0].findings;
  EXPECT_EQ(loose.failing, 0);
  EXPECT_DOUBLE_EQ(*loose[min_length].extreme, 1) << "measured all the same";
}

/// Strips of 5 mm on cylinders: the sagitta over a chord c on radius r is c^2 / (8 r).
TEST(ChordalDeviation, IsTheSagittaOnACylinder) {
  for (const double radius : {20.0, 50.0, 200.0}) {
    std::vector<Vec3> nodes;
    std::vector<MeshElement> elements;
    for (int i = 0; i <= 8; ++i)
      for (int j = 0; j <= 3; ++j)
        nodes.push_back({radius * std::sin(5 * i / radius), 5.0 * j, radius * std::cos(5 * i / radius)});
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < 3; ++j)
        elements.push_back({4 * i + j, 4 * i + 4 + j, 4 * i + 5 + j, 4 * i + 1 + j});
    const auto found = chordal_deviations(nodes, elements);
    const double chord = distance(nodes[0], nodes[4]);
    for (const int e : {7, 10, 13}) EXPECT_NEAR(found[e], chord * chord / 8 / radius, 0.02 * found[e]);
  }
}

TEST(ChordalDeviation, ASharpEdgeIsNoBow) {
  const std::vector<Vec3> nodes = {{0, 0, 0}, {5, 0, 0}, {5, 5, 0}, {0, 5, 0}, {5, 0, 5}, {5, 5, 5}};
  for (const double d : chordal_deviations(nodes, {{0, 1, 2, 3}, {1, 4, 5, 2}})) EXPECT_NEAR(d, 0, 1e-12);
}

TEST(CriteriaText, ComesBackAsItWas) {
  for (const char* preset : {"crash", "nvh", "durability"}) {
    const auto criteria = criteria_of_preset(preset);
    const auto back = parse_criteria(criteria_text(*criteria));
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_TRUE(back->ignored.empty());
    for (int m = 0; m < measure_count; ++m) {
      EXPECT_EQ(back->criteria.of[m].on, criteria->of[m].on);
      for (const auto limit : {&Criterion::weight, &Criterion::ideal, &Criterion::good, &Criterion::warn,
                               &Criterion::fail, &Criterion::worst})
        EXPECT_NEAR(back->criteria.of[m].*limit, criteria->of[m].*limit, 1e-5);
    }
  }
}

TEST(CriteriaText, ReadsATableOfAnotherProgram) {
  const auto read = parse_criteria(
      "# Criterion        On  Wt   Ideal    Good    Warn    Fail   Worst\r\n"
      " 0 penalty value            0.00   0.00    0.80    1.00   10.00\r\n"
      " 1\tMin Size    \t1  1.0   10.0  8.0  6.0  4.0  1.0\r\n"
      "\r\n"
      " 5 max angle quad  0 1   90 110 130 140 180\r\n"
      "13 Curvature\t0 1 1 2 3 4 5\r\n");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->criteria[min_length].fail, 4);
  EXPECT_TRUE(read->criteria[min_length].on);
  EXPECT_FALSE(read->criteria[max_angle_quad].on);
  EXPECT_FALSE(read->criteria[skew].on) << "no row, no limit";
  EXPECT_EQ(read->ignored, std::vector<std::string>{"curvature"});
}

TEST(CriteriaText, SaysWhatIsWrong) {
  const auto code = [](std::string_view text) { return parse_criteria(text).error().code; };
  EXPECT_EQ(code(""), "criteria.empty");
  EXPECT_EQ(code("# nothing\n 0 penalty value 0 0 0.8 1 10\n"), "criteria.empty");
  EXPECT_EQ(code("1 min length 1 1 5 4 3\n"), "criteria.row");
  EXPECT_EQ(code("1 min length 1 1 5 4 3 2.5 x\n"), "criteria.row");
  EXPECT_EQ(code("min length 1 1 5 4 3 2.5 0\n"), "criteria.row");
  EXPECT_EQ(code("1 min length 1 1 5 4 4.5 2.5 0\n"), "criteria.order");
  EXPECT_EQ(code("1 min length 1 1 nan 4 3 2.5 0\n"), "criteria.row");
  EXPECT_EQ(code(std::string(300, '\0')), "criteria.row");
}

}  // namespace
}  // namespace beadmesh
