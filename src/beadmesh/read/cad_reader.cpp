#include "beadmesh/read/cad_reader.h"

#include <BRepBndLib.hxx>
#include <Bnd_Box.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <cmath>
#include <exception>
#include <ios>
#include <mutex>
#include <string>
#include <utility>

#include "beadmesh/read/cad_facets.h"
#include "beadmesh/read/cad_model.h"
#include "beadmesh/read/cad_panel.h"
#include "beadmesh/read/face_boundary.h"

namespace beadmesh {
namespace {

/// OpenCASCADE's readers keep process-wide settings, so only one may read at a time.
std::mutex& reader_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// Every failure of a reader says which file it is about.
Failure named(Diagnostic diagnostic, const std::filesystem::path& path) {
  if (diagnostic.entity.empty()) diagnostic.entity = path.filename().string();
  return Failure(std::move(diagnostic));
}

/// Diagonal of a box around the faces, mm; 0 where there is none.
double size_of(const CadModel& model) {
  Bnd_Box box;
  for (const TopoDS_Face& face : model.faces) BRepBndLib::Add(face, box, false);
  return box.IsVoid() || box.IsOpen() ? 0 : std::sqrt(box.SquareExtent());
}

/// Lengths in mm that a file calls metres would take all time and memory.
Result<void> check_size(const CadModel& model) {
  constexpr double most = 50000;  // mm
  const double size = size_of(model);
  if (size <= most) return {};
  return fail("read.too_large",
              "the panel would be " + std::to_string(std::lround(std::min(size / 1000, 1e9))) +
                  " m across, over 50 m",
              "check its unit, which is " + model.unit);
}

Result<Panel> read_unguarded(const std::filesystem::path& path, const ReadOptions& options,
                             const Context& context) {
  const std::lock_guard lock(reader_mutex());
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  context.report("read", 0);
  Result<CadModel> model = load_cad_model(path, options);
  if (!model) return named(model.error(), path);
  if (const Result<void> good = check_size(*model); !good) return named(good.error(), path);
  drop_duplicates(*model, std::max(options.sew_tolerance, 1e-6));
  sew(*model, options.sew_tolerance);
  context.report("facets", 0);
  CadTopology topology = topology_of(*model);
  const std::vector<FaceNodes> faces = facet_faces(topology, options, context);
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (faces[f].crossing) return named(crossing_defect(*faces[f].crossing, model->numbers[f]), path);
  Panel panel = assemble_panel(*model, topology, faces);
  panel.input = path.filename().string();
  if (panel.faces.empty())
    return fail("read.no_sound_face",
                model->faces.size() == 1 && !faces.front().defect.empty()
                    ? "the only face cannot be facetted: " + faces.front().defect
                    : "none of the " + std::to_string(model->faces.size()) + " faces can be facetted",
                "repair the faces in the CAD system", path.filename().string());
  context.report("facets", 1);
  return panel;
}

}  // namespace

Result<Panel> read_cad_panel(const std::filesystem::path& path, const ReadOptions& options,
                             const Context& context) {
  std::string what;
  try {
    return read_unguarded(path, options, context);
  } catch (const Standard_Failure& failure) {
    what = failure.GetMessageString();
    if (what.empty()) what = failure.DynamicType()->Name();
  } catch (const std::ios_base::failure&) {
    what = "it is damaged or ends too early";
  } catch (const std::exception& failure) {
    what = failure.what();
  }
  return fail("read.unreadable", "the file cannot be read: " + what.substr(0, what.find('\n')), {},
              path.filename().string());
}

}  // namespace beadmesh
