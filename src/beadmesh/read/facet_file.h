// Inside the read room: files of loose triangles: STL, OBJ, PLY.
#pragma once

#include <filesystem>

#include "beadmesh/core/result.h"
#include "beadmesh/read/input_file.h"
#include "beadmesh/read/panel_reader.h"

namespace beadmesh {

/// Welds, orients, and cuts the skin into sheet and features. Faces have no evaluators.
Result<Panel> read_facet_panel(const std::filesystem::path& path, FileKind kind, const ReadOptions& options);

}  // namespace beadmesh
