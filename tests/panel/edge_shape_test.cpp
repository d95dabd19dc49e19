#include "beadmesh/panel/edge_shape.h"

#include <gtest/gtest.h>

#include <cmath>

#include "panel/panel_shapes.h"

namespace beadmesh {
namespace {

TEST(EdgeShape, TurnBetweenTwoSquares) {
  for (const double lift : {0.0, 0.1, 1.0}) {
    const auto shapes = edge_shapes(test::two_squares(lift));
    EXPECT_NEAR(shapes[0].turn, std::atan(lift), 1e-12);
    EXPECT_NEAR(shapes[0].bend, 0, 1e-12) << "both are flat";
  }
}

TEST(EdgeShape, FreeEdgesHaveNone) {
  const auto shapes = edge_shapes(test::two_squares(0.1));
  for (std::size_t e = 1; e < shapes.size(); ++e) {
    EXPECT_TRUE(std::isinf(shapes[e].turn));
    EXPECT_TRUE(std::isinf(shapes[e].bend));
  }
}

/// A cylinder about the y axis; its parameters are angle and y.
class Cylinder : public SurfaceEvaluator {
 public:
  explicit Cylinder(double radius) : radius_(radius) {}
  Vec3 point(Vec2 uv) const override { return {radius_ * std::sin(uv.x), uv.y, radius_ * std::cos(uv.x)}; }
  Vec3 normal(Vec2 uv) const override { return {std::sin(uv.x), 0, std::cos(uv.x)}; }

 private:
  double radius_;
};

TEST(EdgeShape, BendOfACylinderIsItsCurvature) {
  constexpr double radius = 40;
  const Cylinder cylinder(radius);
  Panel panel = test::two_squares();
  for (Vec3& p : panel.points) p = cylinder.point({p.x / radius, p.y});
  for (PanelFace& face : panel.faces) {
    Facets& facets = face.facets;
    for (std::size_t v = 0; v < facets.points.size(); ++v)
      facets.points[v] = panel.points[facets.panel_points[v]];
    facets.surfaces = {std::make_shared<Cylinder>(radius)};
    for (const Triangle& t : facets.triangles) {
      facets.triangle_uv.emplace_back();
      for (int k = 0; k < 3; ++k) {
        const Vec3 p = facets.points[t[k]];
        facets.triangle_uv.back()[k] = {std::atan2(p.x, p.z), p.y};
      }
    }
  }
  const auto shapes = edge_shapes(panel);
  EXPECT_NEAR(shapes[0].turn, 0, 1e-12);
  EXPECT_LE(shapes[0].bend, 1 / radius * 1.01);
  EXPECT_GE(shapes[0].bend, 0.6 / radius) << "away from the edge the triangles run at an angle";
}

}  // namespace
}  // namespace beadmesh
