#include "beadmesh/read/cad_model.h"

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <XSControl_WorkSession.hxx>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>

#include "beadmesh/read/cad_raw_loops.h"
#include "beadmesh/read/cad_step_parts.h"
#include "beadmesh/read/input_file.h"

namespace beadmesh {
namespace {

class SilencedOutput {
 public:
  SilencedOutput() : before_(std::cout.rdbuf(nullptr)) {}
  ~SilencedOutput() {
    std::cout.rdbuf(before_);
    std::cout.clear();
  }
  SilencedOutput(const SilencedOutput&) = delete;
  SilencedOutput& operator=(const SilencedOutput&) = delete;

 private:
  std::streambuf* before_;
};

Failure truncated(const std::filesystem::path& path, std::string message) {
  return fail("read.truncated", std::move(message), "export the file again", path.filename().string());
}

Failure unreadable(const std::filesystem::path& path, std::string message) {
  return fail("read.unreadable", std::move(message), {}, path.filename().string());
}

void list_faces(const TopoDS_Shape& shape, CadModel& model) {
  TopTools_MapOfShape seen;
  for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next()) {
    if (!seen.Add(at.Current())) continue;
    model.faces.push_back(TopoDS::Face(at.Current()));
    model.names.emplace_back();
    model.numbers.push_back(static_cast<Index>(model.faces.size()));
    model.part_of_face.push_back(no_index);
  }
}

/// OpenCASCADE reports references that lead nowhere or to the wrong kind of entity, then follows them and
/// crashes.
std::optional<std::string> damaged_entity(const Handle(Interface_InterfaceModel) & model) {
  for (int i = 1; i <= model->NbEntities(); ++i) {
    if (!model->IsErrorEntity(i)) continue;
    const std::string type = model->Value(i)->DynamicType()->Name();
    if (type.starts_with("StepGeom_") || type.starts_with("StepShape_") || type.starts_with("IGESGeom_"))
      return model->StringLabel(model->Value(i))->ToCString();
  }
  return {};
}

Result<CadModel> load_step(const std::filesystem::path& path) {
  if (!tail_contains(path, "END-ISO-10303-21"))
    return truncated(path, "the file ends before END-ISO-10303-21");
  STEPControl_Reader reader;
  const RawLoopWatch watch;  // the first reader of a process sets up its own
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  if (reader.ReadFile(path.string().c_str()) != IFSelect_RetDone)
    return unreadable(path, "the file is not a readable STEP file");
  if (const auto entity = damaged_entity(reader.WS()->Model()))
    return unreadable(path, "entity " + *entity + " refers to what is not there, or is of the wrong kind");
  CadModel model;
  TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
  reader.FileUnits(lengths, angles, solid_angles);
  if (!lengths.IsEmpty()) model.unit = lengths.First().ToCString();
  reader.TransferRoots();
  if (watch.defect()) return Failure(*watch.defect());
  const TopoDS_Shape shape = reader.OneShape();
  if (shape.IsNull()) return model;
  list_step_faces(shape, reader.WS(), model);
  return model;
}

Result<CadModel> load_iges(const std::filesystem::path& path) {
  IGESControl_Reader reader;
  const RawLoopWatch watch;
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  if (!iges_is_complete(path)) return truncated(path, "the file has no terminate section");
  if (reader.ReadFile(path.string().c_str()) != IFSelect_RetDone)
    return unreadable(path, "the file is not a readable IGES file");
  CadModel model;
  const Handle(IGESData_IGESModel) file = reader.IGESModel();
  if (file.IsNull()) return unreadable(path, "the file is not a readable IGES file");
  if (!file->GlobalSection().UnitName().IsNull()) model.unit = file->GlobalSection().UnitName()->ToCString();
  reader.TransferRoots();
  if (watch.defect()) return Failure(*watch.defect());
  const TopoDS_Shape shape = reader.OneShape();
  if (!shape.IsNull()) list_faces(shape, model);
  return model;
}

Result<CadModel> load_brep(const std::filesystem::path& path, const std::string& unit) {
  const std::optional<double> factor = millimetres_per(unit);
  if (!factor)
    return fail("read.unit", "the unit '" + unit + "' is unknown", "use mm, cm, m, um, in or ft",
                path.filename().string());
  TopoDS_Shape shape;
  std::ifstream stream(path, std::ios::binary);
  if (head_contains(path, "Open CASCADE Topology")) {
    BinTools::Read(shape, stream);
  } else {
    if (!head_contains(path, "DBRep_DrawableShape") && !head_contains(path, "CASCADE Topology"))
      return unreadable(path, "the file is not a BREP file");
    // OpenCASCADE reads on for ever where a section is missing, and complains on the standard output.
    if (!brep_is_complete(path)) return truncated(path, "the file ends before the last shape");
    const SilencedOutput silence;
    stream.exceptions(std::ios::failbit | std::ios::badbit);
    BRepTools::Read(shape, stream, BRep_Builder());
  }
  if (shape.IsNull()) return truncated(path, "the file holds no whole shape");
  if (*factor != 1) {
    gp_Trsf scale;
    scale.SetScale(gp_Pnt(0, 0, 0), *factor);
    shape = BRepBuilderAPI_Transform(shape, scale, true).Shape();
  }
  CadModel model;
  model.unit = unit;
  list_faces(shape, model);
  return model;
}

}  // namespace

Result<CadModel> load_cad_model(const std::filesystem::path& path, const ReadOptions& options) {
  const FileKind kind = file_kind(path);
  Result<CadModel> model = kind == FileKind::step   ? load_step(path)
                           : kind == FileKind::iges ? load_iges(path)
                                                    : load_brep(path, options.unit);
  if (model && model->faces.empty())
    return fail("read.no_faces", "the file has no faces", "export the surfaces, not only curves or products",
                path.filename().string());
  return model;
}

}  // namespace beadmesh
