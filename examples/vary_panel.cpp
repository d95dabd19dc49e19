// vary_panel: writes a STEP panel once more as another system might hand it over: another format and unit,
// turned in space, mirrored, its faces in another order, turned over, loose or doubled, or with thickness.
#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepOffset_MakeOffset.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Bnd_Box.hxx>
#include <CLI/CLI.hpp>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "examples/chance.h"

namespace {

using beadmesh::examples::Chance;

struct Variant {
  std::string input, output, unit = "mm";
  std::uint64_t seed = 1;
  bool is_turned = false, is_mirrored = false, is_shuffled = false, is_flipped = false;
  double sliver = 0;     ///< mm, width of strips that a cut along two planes leaves
  double gap = 0;        ///< mm, up to which faces are moved apart
  int doubled = 0;       ///< how many faces come twice
  double thickness = 0;  ///< mm; the panel as a solid
  int copies = 1;        ///< side by side; several make an assembly
};

void add_options(CLI::App& app, Variant& v) {
  app.add_option("input", v.input, "STEP file")->required();
  app.add_option("output", v.output, "file to write: .step, .igs or .brep")->required();
  app.add_option("--unit", v.unit, "of the file: mm, inch, m (mm)")
      ->check(CLI::IsMember({"mm", "inch", "m"}));
  app.add_option("--seed", v.seed, "of all that is left to chance (1)");
  app.add_flag("--turn", v.is_turned, "turn and shift it in space");
  app.add_flag("--mirror", v.is_mirrored, "mirror it");
  app.add_flag("--shuffle", v.is_shuffled, "faces in another order");
  app.add_flag("--flip", v.is_flipped, "turn half of the faces over");
  app.add_option("--sliver", v.sliver, "cut along two planes so many mm apart: narrow faces, short edges");
  app.add_option("--gap", v.gap, "loose faces, each moved by up to half of so many mm");
  app.add_option("--double", v.doubled, "so many faces twice");
  app.add_option("--copies", v.copies, "so many panels above each other, an assembly");
  app.add_option("--thickness", v.thickness, "a solid of this thickness, mm; negative: to the other side");
}

TopoDS_Shape transformed(const TopoDS_Shape& shape, const gp_Trsf& by) {
  return BRepBuilderAPI_Transform(shape, by, true).Shape();
}

gp_Trsf shift(gp_Vec by) {
  gp_Trsf move;
  move.SetTranslation(by);
  return move;
}

TopoDS_Shape placed(TopoDS_Shape shape, const Variant& v, Chance& chance) {
  if (v.is_mirrored) {
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(3, -7, 11), gp_Dir(0.3, 0.8, -0.2)));
    shape = transformed(shape, mirror);
  }
  if (v.is_turned) {
    const gp_Dir axis(chance.between(0.1, 1), chance.between(0.1, 1), chance.between(-1, -0.1));
    gp_Trsf turn;
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), axis), chance.between(0.5, 5.5));
    shape = transformed(transformed(shape, turn), shift({chance.between(-2000, 2000), 831, -377}));
  }
  if (v.thickness == 0) return shape;
  BRepOffset_MakeOffset solid(shape, v.thickness, 1e-4, BRepOffset_Skin, false, false, GeomAbs_Arc, true);
  if (!solid.IsDone()) throw Standard_Failure("no solid of this thickness");
  return solid.Shape();
}

/// All faces cut along two upright planes that lie askew through the middle.
TopoDS_Shape with_slivers(const TopoDS_Shape& shape, double width) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box);
  const gp_Pnt low = box.CornerMin(), high = box.CornerMax();
  const gp_Dir normal(1, 0.37, 0);
  TopTools_ListOfShape whole, planes;
  whole.Append(shape);
  for (const double at : {0.0, width}) {
    const gp_Pnt middle = gp_Pnt((low.XYZ() + high.XYZ()) / 2).Translated(gp_Vec(normal) * at);
    planes.Append(BRepBuilderAPI_MakeFace(gp_Pln(middle, normal), -1e4, 1e4, -1e4, 1e4).Face());
  }
  BRepAlgoAPI_Splitter splitter;
  splitter.SetArguments(whole);
  splitter.SetTools(planes);
  splitter.Build();
  if (!splitter.IsDone()) throw Standard_Failure("cannot be cut");
  return splitter.Shape();
}

/// One shell where nothing is loose, else a compound of faces.
TopoDS_Shape varied(const TopoDS_Shape& shape, const Variant& v, Chance& chance) {
  if (!v.is_shuffled && !v.is_flipped && v.gap == 0 && v.doubled == 0) return shape;
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next()) faces.push_back(at.Current());
  if (v.is_shuffled)
    for (std::size_t i = faces.size(); i > 1; --i) std::swap(faces[i - 1], faces[chance.below(int(i))]);
  for (int i = 0; i < v.doubled; ++i)
    faces.push_back(transformed(faces[chance.below(int(faces.size()))], shift({1e-5, 0, 0})));
  BRep_Builder make;
  TopoDS_Compound all;
  make.MakeCompound(all);
  for (TopoDS_Shape face : faces) {
    const auto some = [&] { return chance.between(-v.gap, v.gap) / 2 / std::sqrt(3.0); };
    if (v.gap > 0) face = transformed(face, shift({some(), some(), some()}));
    if (v.is_flipped && chance.below(2) == 0) face.Reverse();
    make.Add(all, face);
  }
  return all;
}

TopoDS_Shape copied(const TopoDS_Shape& shape, const Variant& v) {
  if (v.copies < 2) return shape;
  BRep_Builder make;
  TopoDS_Compound all;
  make.MakeCompound(all);
  for (int i = 0; i < v.copies; ++i) make.Add(all, transformed(shape, shift({0, 0, 100.0 * i})));
  return all;
}

bool write(const TopoDS_Shape& shape, const Variant& v) {
  const std::string ending = std::filesystem::path(v.output).extension().string();
  const std::map<std::string, std::pair<const char*, double>> units{
      {"mm", {"MM", 1}}, {"inch", {"INCH", 25.4}}, {"m", {"M", 1000}}};
  const auto [name, length] = units.at(v.unit);
  // The IGES writer converts, the others write the numbers as they are.
  gp_Trsf scale;
  scale.SetScale(gp_Pnt(0, 0, 0), 1 / length);
  const TopoDS_Shape scaled = length == 1 || ending == ".igs" ? shape : transformed(shape, scale);
  if (ending == ".igs") {
    IGESControl_Writer writer(name, 1);
    writer.AddShape(scaled);
    writer.ComputeModel();
    return writer.Write(v.output.c_str());
  }
  if (ending == ".brep") return BRepTools::Write(scaled, v.output.c_str());
  STEPControl_Writer writer;
  Interface_Static::SetCVal("write.step.unit", name);
  Interface_Static::SetIVal("write.step.assembly", v.copies > 1 ? 1 : 0);
  return writer.Transfer(scaled, STEPControl_AsIs) == IFSelect_RetDone &&
         writer.Write(v.output.c_str()) == IFSelect_RetDone;
}

int run(const Variant& v) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPControl_Reader reader;
  if (reader.ReadFile(v.input.c_str()) != IFSelect_RetDone) {
    std::cerr << "cannot read " << v.input << "\n";
    return 2;
  }
  reader.TransferRoots();
  Chance chance(v.seed);
  TopoDS_Shape shape = reader.OneShape();
  if (v.sliver > 0) shape = with_slivers(shape, v.sliver);
  if (write(copied(varied(placed(shape, v, chance), v, chance), v), v)) return 0;
  std::cerr << "cannot write " << v.output << "\n";
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Writes a STEP panel as another system might hand it over."};
  Variant variant;
  add_options(app, variant);
  try {
    app.parse(argc, argv);
    return run(variant);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const Standard_Failure& failure) {
    std::cerr << failure.GetMessageString() << "\n";
    return 2;
  }
}
