// Inside the read room: STL, ASCII and binary.
#pragma once

#include <filesystem>

#include "beadmesh/core/result.h"
#include "beadmesh/read/panel_reader.h"

namespace beadmesh {

/// Welds the corners, orients, and splits the skin into one face per smooth region. Faces have no evaluators.
Result<Panel> read_stl_panel(const std::filesystem::path& path, const ReadOptions& options);

}  // namespace beadmesh
