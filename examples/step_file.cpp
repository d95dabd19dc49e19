#include "examples/step_file.h"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Writer.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Wire.hxx>
#include <cmath>
#include <gp_Pln.hxx>

#include "examples/panel_builder.h"
#include "examples/step_shape.h"

namespace beadmesh::examples {
namespace {

bool write_as(const TopoDS_Shape& shape, STEPControl_StepModelType type, const std::filesystem::path& path) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPControl_Writer writer;
  Interface_Static::SetCVal("write.step.unit", "MM");
  if (writer.Transfer(shape, type) != IFSelect_RetDone) return false;
  return writer.Write(path.c_str()) == IFSelect_RetDone;
}

bool write_flat_face(const TopoDS_Wire& boundary, const std::filesystem::path& path) {
  const gp_Pln plane(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1));
  return write_shape(BRepBuilderAPI_MakeFace(plane, boundary).Face(), path);
}

}  // namespace

bool write_shape(const TopoDS_Shape& shape, const std::filesystem::path& path) {
  return write_as(shape, STEPControl_AsIs, path);
}

bool write_panel(const PanelDesign& design, const std::filesystem::path& path) {
  return write_shape(build_panel(design), path);
}

bool write_bow_tie(const std::filesystem::path& path) {
  BRepBuilderAPI_MakePolygon polygon(gp_Pnt(0, 0, 0), gp_Pnt(60, 40, 0), gp_Pnt(60, 0, 0), gp_Pnt(0, 40, 0),
                                     true);
  return write_flat_face(polygon.Wire(), path);
}

bool write_figure_of_eight(const std::filesystem::path& path) {
  constexpr int count = 24;
  Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, count);
  for (int i = 0; i < count; ++i) {
    const double t = 2 * pi * i / count;
    points->SetValue(i + 1, gp_Pnt(50 * std::cos(t), 30 * std::sin(2 * t), 0));
  }
  GeomAPI_Interpolate curve(points, true, 1e-7);
  curve.Perform();
  const Handle(Geom_Curve) eight(curve.Curve());
  return write_flat_face(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(eight).Edge()).Wire(), path);
}

bool write_lone_edge(const std::filesystem::path& path) {
  const TopoDS_Shape edge = BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(50, 0, 0)).Edge();
  return write_as(edge, STEPControl_GeometricCurveSet, path);
}

}  // namespace beadmesh::examples
