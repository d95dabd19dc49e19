#include "examples/filleted_panel.h"

#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>

#include "examples/footprint.h"
#include "examples/skeletons.h"
#include "examples/step_shape.h"

namespace beadmesh::examples {
namespace {

constexpr double length = 320, width = 200, height = 6, thickness = 3;  // mm
constexpr double root_radius = 3, top_radius = 2;                       // mm
constexpr double on_plane = 1e-5;                                       // mm

gp_Pnt to_gp(Vec2 p) {
  return {p.x, p.y, -1};
}

TopoDS_Wire wire_of(const PlanLoop& loop) {
  BRepBuilderAPI_MakeWire wire;
  for (const PlanEdge& edge : loop) {
    const gp_Pnt a = to_gp(edge.point(0)), b = to_gp(edge.point(1));
    if (edge.is_arc())
      wire.Add(BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(a, to_gp(edge.point(0.5)), b).Value()).Edge());
    else
      wire.Add(BRepBuilderAPI_MakeEdge(a, b).Edge());
  }
  return wire.Wire();
}

/// The footprint from below the sheet's upper side to full height.
TopoDS_Shape block_of(const std::vector<PlanLoop>& loops) {
  BRepBuilderAPI_MakeFace face(wire_of(loops.front()), true);
  for (std::size_t i = 1; i < loops.size(); ++i) face.Add(wire_of(loops[i]));
  return BRepPrimAPI_MakePrism(face.Face(), gp_Vec(0, 0, height + 1)).Shape();
}

/// Both ends of the edge at this height; an edge of the sheet's border does not count.
bool lies_at(const TopoDS_Edge& edge, double z) {
  for (TopExp_Explorer at(edge, TopAbs_VERTEX); at.More(); at.Next()) {
    const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(at.Current()));
    if (std::abs(p.Z() - z) > on_plane) return false;
    if (std::abs(p.X()) > length / 2 - 1 || std::abs(p.Y()) > width / 2 - 1) return false;
  }
  return true;
}

TopoDS_Shape filleted(const TopoDS_Shape& solid) {
  BRepFilletAPI_MakeFillet fillets(solid);
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(solid, TopAbs_EDGE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(i));
    if (lies_at(edge, 0)) fillets.Add(root_radius, edge);
    if (lies_at(edge, height)) fillets.Add(top_radius, edge);
  }
  return fillets.Shape();
}

/// The faces of the upper side.
TopoDS_Shell skin_of(const TopoDS_Shape& solid) {
  BRep_Builder make;
  TopoDS_Shell shell;
  make.MakeShell(shell);
  for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next()) {
    bool is_above = true;
    for (TopExp_Explorer at(face.Current(), TopAbs_VERTEX); at.More(); at.Next())
      is_above = is_above && BRep_Tool::Pnt(TopoDS::Vertex(at.Current())).Z() > -on_plane;
    if (is_above) make.Add(shell, face.Current());
  }
  return shell;
}

std::vector<PlanLoop> placed(const Footprint& footprint, Vec2 origin, double angle) {
  std::vector<PlanLoop> loops;
  for (const PlanLoop& loop : footprint.loops) loops.push_back(placed(loop, origin, angle));
  return loops;
}

}  // namespace

bool write_filleted_panel(const std::filesystem::path& path) {
  const std::vector<std::vector<PlanLoop>> features{placed(straight_bead(80, 18), {-95, 65}, 0.2),
                                                    placed(arc_bead(70, 70, 16), {-60, -10}, -2.2),
                                                    placed(t_bead(120, 60, 14, 10), {45, 38}, 0),
                                                    placed(circular_ring(38, 15), {108, -52}, 0),
                                                    {placed(circle(24), {18, -62}, 0)}};
  try {
    TopoDS_Shape solid =
        BRepPrimAPI_MakeBox(gp_Pnt(-length / 2, -width / 2, -thickness), length, width, thickness).Shape();
    for (const auto& loops : features) solid = BRepAlgoAPI_Fuse(solid, block_of(loops)).Shape();
    return write_shape(skin_of(filleted(solid)), path);
  } catch (const Standard_Failure&) {
    return false;
  }
}

}  // namespace beadmesh::examples
