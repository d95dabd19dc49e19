#include "examples/panel_builder.h"

#include <gtest/gtest.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>

#include "examples/example_panels.h"
#include "examples/shape_panels.h"

namespace beadmesh::examples {
namespace {

struct SeamStudy {
  int faces = 0, border_edges = 0, shared_edges = 0, crowded_edges = 0;
  double widest_gap = 0;     // mm
  double sharpest_bend = 0;  // degrees, over the shared edges
};

/// Point and normal of a face at fraction t of an edge.
std::pair<gp_Pnt, gp_Vec> on_face(const TopoDS_Edge& edge, const TopoDS_Face& face, double t) {
  double first, last;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  const gp_Pnt2d uv = curve->Value(first + (last - first) * t);
  gp_Pnt at;
  gp_Vec du, dv;
  BRep_Tool::Surface(face)->D1(uv.X(), uv.Y(), at, du, dv);
  return {at, du.Crossed(dv)};
}

SeamStudy study(const TopoDS_Shape& shell) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shell, TopAbs_FACE, faces);
  TopTools_IndexedDataMapOfShapeListOfShape edges;
  TopExp::MapShapesAndAncestors(shell, TopAbs_EDGE, TopAbs_FACE, edges);
  SeamStudy result;
  result.faces = faces.Extent();
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopTools_ListOfShape& around = edges(i);
    if (around.Extent() != 2) {
      ++(around.Extent() == 1 ? result.border_edges : result.crowded_edges);
      continue;
    }
    ++result.shared_edges;
    for (int k = 0; k <= 50; ++k) {
      const TopoDS_Edge edge = TopoDS::Edge(edges.FindKey(i));
      const auto [p, n] = on_face(edge, TopoDS::Face(around.First()), k / 50.0);
      const auto [q, m] = on_face(edge, TopoDS::Face(around.Last()), k / 50.0);
      result.widest_gap = std::max(result.widest_gap, p.Distance(q));
      result.sharpest_bend = std::max(result.sharpest_bend, degrees(n.Angle(m)));
    }
  }
  return result;
}

TEST(PanelBuilder, EveryExampleIsAValidShellThatIsSmoothAcrossEverySeam) {
  for (const std::string& name : example_names()) {
    const TopoDS_Shell shell = build_panel(*example_panel(name));
    EXPECT_TRUE(BRepCheck_Analyzer(shell).IsValid()) << name;
    const SeamStudy seams = study(shell);
    EXPECT_EQ(seams.crowded_edges, 0) << name;
    EXPECT_LT(seams.widest_gap, 0.005) << name;
    EXPECT_LT(seams.sharpest_bend, 0.5) << name;
  }
}

TEST(PanelBuilder, PanelsMadeToOrderAreAsGood) {
  const ShapePanelOptions narrow{
      .width = 8, .height = -3, .base = BaseKind::saddle, .only = {"wavy", "F", "curved-comb", "eccentric"}};
  const ShapePanelOptions wide{.width = 40,
                               .height = 10,
                               .base = BaseKind::cylinder,
                               .seed = 5,
                               .only = {"tapered", "tree", "circle-in-oval"}};
  for (const PanelDesign& design :
       {*shapes_panel(narrow), *shapes_panel(wide), random_panel({.seed = 3, .beads = 3})}) {
    const TopoDS_Shell shell = build_panel(design);
    EXPECT_TRUE(BRepCheck_Analyzer(shell).IsValid()) << design.name;
    const SeamStudy seams = study(shell);
    EXPECT_EQ(seams.crowded_edges, 0) << design.name;
    EXPECT_LT(seams.widest_gap, 0.005) << design.name;
    EXPECT_LT(seams.sharpest_bend, 0.5) << design.name;
  }
}

TEST(PanelBuilder, BasicHasAFaceAFeatureAndTheIslandInTheRing) {
  const SeamStudy seams = study(build_panel(basic_panel()));
  EXPECT_EQ(seams.faces, 1 + 5 + 1);     // sheet, features but the hole, island
  EXPECT_EQ(seams.border_edges, 8 + 1);  // outline, hole
  EXPECT_EQ(seams.shared_edges,
            4 + 4 + 13 + 4 + 2);  // I, taper, T, ring, emboss
}

TEST(PanelBuilder, RingsOfAClusterShareTheirLoops) {
  PanelDesign panel = curved_panel();
  std::erase_if(panel.features, [](const Feature& f) { return f.shape != "ring"; });
  const SeamStudy seams = study(build_panel(panel));
  EXPECT_EQ(seams.faces, 1 + 4 + 2);
  EXPECT_EQ(seams.shared_edges, 2 * 8 + 4 * 2);
}

}  // namespace
}  // namespace beadmesh::examples
