#include "read/cad_shapes.h"

#include <unistd.h>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <GeomAPI_PointsToBSplineSurface.hxx>
#include <Geom_BSplineSurface.hxx>
#include <IGESControl_Writer.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <STEPControl_Writer.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <cmath>
#include <fstream>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>
#include <iterator>

#include "beadmesh/core/vector.h"

namespace beadmesh::test {
namespace {

TopoDS_Compound compound(std::initializer_list<TopoDS_Shape> shapes) {
  TopoDS_Compound all;
  BRep_Builder builder;
  builder.MakeCompound(all);
  for (const TopoDS_Shape& shape : shapes) builder.Add(all, shape);
  return all;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  static int count = 0;
  path_ = std::filesystem::temp_directory_path() /
          ("beadmesh_read_" + std::to_string(getpid()) + "_" + std::to_string(count++));
  std::filesystem::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void write_shape(const TopoDS_Shape& shape, const std::filesystem::path& path) {
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  if (path.extension() == ".step") {
    STEPControl_Writer writer;
    writer.Transfer(shape, STEPControl_AsIs);
    writer.Write(path.c_str());
  } else if (path.extension() == ".igs") {
    IGESControl_Writer writer("MM", 0);
    writer.AddShape(shape);
    writer.ComputeModel();
    writer.Write(path.c_str());
  } else {
    BRepTools::Write(shape, path.c_str());
  }
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

TopoDS_Shape box(double x, double y, double z) {
  return BRepPrimAPI_MakeBox(x, y, z).Shape();
}
TopoDS_Shape cylinder(double radius, double height) {
  return BRepPrimAPI_MakeCylinder(radius, height).Shape();
}
TopoDS_Shape sphere(double radius) {
  return BRepPrimAPI_MakeSphere(radius).Shape();
}
TopoDS_Shape cone(double radius, double height) {
  return BRepPrimAPI_MakeCone(radius, 0, height).Shape();
}
TopoDS_Shape torus(double major, double minor) {
  return BRepPrimAPI_MakeTorus(major, minor).Shape();
}

TopoDS_Shape plate_with_hole(double radius, int edges) {
  BRepBuilderAPI_MakeFace face(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), -50, 50, -30, 30);
  const gp_Circ circle(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), radius);
  BRepBuilderAPI_MakeWire wire;
  for (int i = 0; i < edges; ++i)
    wire.Add(BRepBuilderAPI_MakeEdge(circle, 2 * pi * i / edges, 2 * pi * (i + 1) / edges).Edge());
  face.Add(TopoDS::Wire(wire.Wire().Reversed()));
  return face.Face();
}

TopoDS_Shape two_loose_squares() {
  BRepBuilderAPI_MakeFace one(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), 0, 10, 0, 10);
  BRepBuilderAPI_MakeFace two(gp_Pln(gp_Pnt(10, 0, 0), gp_Dir(0, 0, 1)), 0, 10, 0, 10);
  return compound({one.Face(), two.Face().Reversed()});
}

TopoDS_Shape bow_tie() {
  BRepBuilderAPI_MakePolygon polygon(gp_Pnt(0, 0, 0), gp_Pnt(10, 10, 0), gp_Pnt(10, 0, 0), gp_Pnt(0, 10, 0),
                                     true);
  return BRepBuilderAPI_MakeFace(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), polygon.Wire()).Face();
}

TopoDS_Shape dome() {
  constexpr int n = 31;
  TColgp_Array2OfPnt points(1, n, 1, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = -30 + 60.0 * i / (n - 1), y = -30 + 60.0 * j / (n - 1);
      points(i + 1, j + 1) = gp_Pnt(x, y, 5 * std::cos(M_PI * x / 60) * std::cos(M_PI * y / 60));
    }
  return BRepBuilderAPI_MakeFace(GeomAPI_PointsToBSplineSurface(points).Surface(), 1e-6).Face();
}

TopoDS_Shape bent_sheet(double length, double width, double radius, double thickness) {
  const double t = thickness, inside = radius - t;
  const auto at = [](double x, double z) { return gp_Pnt(x, 0, z); };
  const auto bend = [&](double r) {
    return gp_Circ(gp_Ax2(at(radius, radius), gp_Dir(0, -1, 0), gp_Dir(1, 0, 0)), r);
  };
  BRepBuilderAPI_MakeWire wire;
  const auto line = [&](gp_Pnt a, gp_Pnt b) { wire.Add(BRepBuilderAPI_MakeEdge(a, b).Edge()); };
  line(at(length, 0), at(length, t));
  line(at(length, t), at(radius, t));
  wire.Add(BRepBuilderAPI_MakeEdge(bend(inside), at(t, radius), at(radius, t)).Edge());
  line(at(t, radius), at(t, length));
  line(at(t, length), at(0, length));
  line(at(0, length), at(0, radius));
  wire.Add(BRepBuilderAPI_MakeEdge(bend(radius), at(0, radius), at(radius, 0)).Edge());
  line(at(radius, 0), at(length, 0));
  return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire(), true).Face(), gp_Vec(0, width, 0))
      .Shape();
}

TopoDS_Shape two_places() {
  const TopoDS_Shape plate = plate_with_hole();
  gp_Trsf shift;
  shift.SetTranslation(gp_Vec(100, 0, 0));
  return compound({plate, plate.Moved(TopLoc_Location(shift))});
}

}  // namespace beadmesh::test
