#include "beadmesh/mesh/element_quality.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <algorithm>
#include <cmath>

#include "mesh/sample_quads.h"

namespace beadmesh {
namespace {

const MeshElement quad = {0, 1, 2, 3}, tria = {0, 1, 2, no_index};

TEST(ScaledJacobian, IsOneForSquareAndRectangle) {
  EXPECT_DOUBLE_EQ(scaled_jacobian({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, quad), 1);
  EXPECT_DOUBLE_EQ(scaled_jacobian({{0, 0, 0}, {7, 0, 0}, {7, 1, 0}, {0, 1, 0}}, quad), 1);
}

TEST(ScaledJacobian, IsSineOfRhombusAngle) {
  const double a = radians(60);
  const std::vector<Vec3> rhombus = {
      {0, 0, 0}, {1, 0, 0}, {1 + std::cos(a), std::sin(a), 0}, {std::cos(a), std::sin(a), 0}};
  EXPECT_NEAR(scaled_jacobian(rhombus, quad), std::sin(a), 1e-12);
}

TEST(ScaledJacobian, IsOneForEquilateralTriangle) {
  EXPECT_NEAR(scaled_jacobian({{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}}, tria), 1, 1e-12);
}

TEST(ScaledJacobian, IsNegativeForArrowHead) {
  EXPECT_LT(scaled_jacobian({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}, quad), 0);
}

TEST(ScaledJacobian, IsNoGreaterThanZeroForPointAndLine) {
  EXPECT_LE(scaled_jacobian({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, quad), 0);
  EXPECT_LE(scaled_jacobian({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, quad), 0);
}

RC_GTEST_PROP(ScaledJacobian, DoesNotDependOnPlaceSizeAndFirstCorner, ()) {
  const auto value = [] { return *rc::gen::inRange(-1000, 1000) / 100.0; };
  std::vector<Vec3> nodes;
  for (int i = 0; i < 4; ++i) nodes.push_back({value(), value(), value()});
  const double before = scaled_jacobian(nodes, quad), scale = *rc::gen::inRange(1, 50) / 7.0;
  const Vec3 shift = {value(), value(), value()};
  for (Vec3& node : nodes) node = node * scale + shift;
  RC_ASSERT(std::abs(scaled_jacobian(nodes, {1, 2, 3, 0}) - before) < 1e-6);
}

TEST(CornerAngles, AreThoseOfTrapezium) {
  const auto [least, greatest] = corner_angles({{0, 0, 0}, {3, 0, 0}, {2, 1, 0}, {1, 1, 0}}, quad);
  EXPECT_NEAR(least, radians(45), 1e-12);
  EXPECT_NEAR(greatest, radians(135), 1e-12);
}

TEST(Warpage, IsZeroInThePlaneAndForTriangles) {
  EXPECT_DOUBLE_EQ(warpage({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, quad), 0);
  EXPECT_DOUBLE_EQ(warpage({{0, 0, 0}, {1, 0, 0}, {1, 1, 5}}, tria), 0);
}

TEST(Warpage, IsTheFoldOverADiagonal) {
  // Two right triangles folded by 30 degrees about the diagonal 0-2.
  const double fold = radians(30), half = std::sqrt(0.5);
  const Vec3 middle = {0.5, 0.5, 0}, away = {-half, half, 0};
  const Vec3 lifted = middle + half * (std::cos(fold) * away + Vec3{0, 0, std::sin(fold)});
  const std::vector<Vec3> nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, lifted};
  EXPECT_GE(warpage(nodes, quad), fold - 1e-12);
  EXPECT_LT(warpage(nodes, quad), 1.1 * fold);
}

TEST(SideLengths, AreShortestAndLongest) {
  const auto [shortest, longest] = side_lengths({{0, 0, 0}, {3, 0, 0}, {3, 4, 0}}, tria);
  EXPECT_DOUBLE_EQ(shortest, 3);
  EXPECT_DOUBLE_EQ(longest, 5);
}

TEST(Summary, CountsGrid) {
  const PlanarMesh mesh = sample::grid(4, 3, 2.0);
  const QualitySummary summary = summarise(sample::lifted(mesh), mesh.elements, 2.0);
  EXPECT_EQ(summary.nodes, 20);
  EXPECT_EQ(summary.quads, 12);
  EXPECT_EQ(summary.trias, 0);
  EXPECT_DOUBLE_EQ(summary.scaled_jacobian_min, 1);
  EXPECT_DOUBLE_EQ(summary.scaled_jacobian_mean, 1);
  EXPECT_DOUBLE_EQ(summary.edge_min, 2);
  EXPECT_DOUBLE_EQ(summary.edge_max, 2);
  EXPECT_EQ(summary.edges_below_min, 0);
  EXPECT_EQ(summary.irregular, 0);
  EXPECT_EQ(summary.inverted, 0);
}

/// Determinants of the bilinear map at the four Gauss points, written out.
TEST(JacobianRatio, IsThatOfTheGaussPoints) {
  const std::vector<Vec3> nodes = {{0, 0, 0}, {7, 1, 0}, {5, 6, 0}, {-1, 3, 0}, {2, 2, 0}};
  const double gauss = 1 / std::sqrt(3.0);
  double least = 1e300, largest = 0;
  for (const double u : {-gauss, gauss})
    for (const double v : {-gauss, gauss}) {
      const Vec3 along_u = (nodes[1] - nodes[0]) * (1 - v) + (nodes[2] - nodes[3]) * (1 + v);
      const Vec3 along_v = (nodes[3] - nodes[0]) * (1 - u) + (nodes[2] - nodes[1]) * (1 + u);
      least = std::min(least, cross(along_u, along_v).z);
      largest = std::max(largest, cross(along_u, along_v).z);
    }
  EXPECT_NEAR(jacobian_ratio(nodes, {0, 1, 2, 3}), least / largest, 1e-12);
  EXPECT_EQ(jacobian_ratio(nodes, {0, 1, 2, no_index}), 1);
  EXPECT_LE(jacobian_ratio(nodes, {0, 1, 4, 3}), jacobian_ratio(nodes, {0, 1, 2, 3}));
  EXPECT_EQ(jacobian_ratio(nodes, {3, 2, 1, 0}), jacobian_ratio(nodes, {0, 1, 2, 3}))
      << "seen along its own normal";
}

TEST(Summary, CountsEdgesBelowMinimumOnce) {
  const PlanarMesh mesh = sample::grid(4, 3, 2.0);
  EXPECT_EQ(summarise(sample::lifted(mesh), mesh.elements, 2.5).edges_below_min, 4 * 4 + 5 * 3);
}

TEST(Summary, CountsIrregularNodesOfCutTriangles) {
  // Of one cell: centres of two triangles have three quads, the middle of their common side has four.
  const PlanarMesh mesh = sample::cut_triangles(1, 10);
  EXPECT_EQ(summarise(sample::lifted(mesh), mesh.elements, 1).irregular, 2);
}

TEST(Summary, CountsNodesAtTriangleAsIrregular) {
  PlanarMesh mesh = sample::grid(3, 3, 2.0);
  const MeshElement cell = mesh.elements[4];
  mesh.elements[4] = {cell[0], cell[1], cell[2], no_index};
  mesh.elements.push_back({cell[0], cell[2], cell[3], no_index});
  const QualitySummary summary = summarise(sample::lifted(mesh), mesh.elements, 1);
  EXPECT_EQ(summary.trias, 2);
  EXPECT_EQ(summary.irregular, 4);
}

TEST(Summary, CountsInvertedAndWarped) {
  const std::vector<Vec3> nodes = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}, {0.1, 0.1, 0}};
  EXPECT_EQ(summarise(nodes, {{0, 1, 2, 3}}, 0.1).warped_over_15, 1);
  EXPECT_EQ(summarise(nodes, {{1, 2, 3, 4}, {0, 1, 4, 3}}, 0.1).inverted, 1);
}

}  // namespace
}  // namespace beadmesh
