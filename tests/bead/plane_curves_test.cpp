#include "beadmesh/bead/plane_curves.h"

#include <gtest/gtest.h>

#include <cmath>

#include "panel/panel_shapes.h"

namespace beadmesh {
namespace {

class UnitCircle : public CurveEvaluator {
 public:
  Vec3 point(double t) const override { return {std::cos(t), std::sin(t), 0}; }
  SpaceCurvePoint at(double t) const override {
    return {point(t), {-std::sin(t), std::cos(t), 0}, -point(t)};
  }
};

/// Face 0 of disc_in_ring(24) is the disc; its boundary is two half circles.
Panel disc_with_curves() {
  Panel panel = test::disc_in_ring(24);
  for (int e = 0; e < 2; ++e) {
    panel.edges[e].curve = std::make_shared<UnitCircle>();
    for (int i = 0; i <= 12; ++i) panel.edges[e].parameters.push_back(pi * e + pi * i / 12);
  }
  return panel;
}

Index disc_of(const Panel& panel) {
  for (std::size_t f = 0; f < panel.faces.size(); ++f)
    if (panel.faces[f].loops.size() == 1) return static_cast<Index>(f);
  return no_index;
}

TEST(PlaneCurves, APlaneFaceKeepsTheCurvesOfItsEdges) {
  const Panel panel = disc_with_curves();
  const auto study = study_opened_face(panel, disc_of(panel));
  ASSERT_TRUE(study) << study.error().message;
  const PlanarRegion& region = (*study)->region;
  ASSERT_EQ(region.curves.size(), 2u);
  ASSERT_EQ(region.loops[0].curve.size(), 24u);
  EXPECT_TRUE(checked_region(region)) << "curves pass the points";
  const auto medial = medial_object(region);
  ASSERT_TRUE(medial);
  ASSERT_EQ(medial->vertices.size(), 1u);
  EXPECT_NEAR(medial->vertices[0].radius, 1, 1e-12) << "of the circle, not of its facets";
}

TEST(PlaneCurves, NoneWhereTheFaceIsCurvedOrAnEdgeHasNoCurve) {
  Panel bent = disc_with_curves();
  for (Vec3& p : bent.faces[disc_of(bent)].facets.points) p.z = 0.1 * p.x * p.x;
  const auto of_bent = study_opened_face(bent, disc_of(bent));
  ASSERT_TRUE(of_bent);
  EXPECT_TRUE((*of_bent)->region.curves.empty());
  Panel without = disc_with_curves();
  without.edges[1].curve = nullptr;
  const auto of_without = study_opened_face(without, disc_of(without));
  ASSERT_TRUE(of_without);
  EXPECT_TRUE((*of_without)->region.curves.empty());
  EXPECT_TRUE((*of_without)->region.loops[0].curve.empty());
}

}  // namespace
}  // namespace beadmesh
