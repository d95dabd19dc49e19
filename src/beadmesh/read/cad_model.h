// Inside the read room: what a CAD file holds, as OpenCASCADE sees it.
#pragma once

#include <TopoDS_Face.hxx>
#include <filesystem>
#include <string>
#include <vector>

#include "beadmesh/core/result.h"
#include "beadmesh/read/panel_reader.h"

namespace beadmesh {

/// Faces in the file's order, each once, with their locations; coordinates in mm.
struct CadModel {
  std::vector<TopoDS_Face> faces;
  std::vector<std::string> names;   ///< per face; may be empty
  std::vector<Index> numbers;       ///< per face: 1-based, in the file's order
  std::vector<Index> part_of_face;  ///< per face: index in `parts`, or no_index
  std::vector<PanelPart> parts;
  std::string unit = "mm";
  std::vector<Diagnostic> diagnostics;
};

/// Reads STEP, IGES or BREP by the ending of `path`. May throw Standard_Failure.
Result<CadModel> load_cad_model(const std::filesystem::path& path, const ReadOptions& options);

/// Leaves out faces that lie on an earlier one of the same shape.
void drop_duplicates(CadModel& model, double tolerance);

/// Makes free edges of one part that coincide within `tolerance` one edge. Faces that share all they touch
/// are left as they are. Based on BRepBuilderAPI_Sewing.
void sew(CadModel& model, double tolerance);

}  // namespace beadmesh
