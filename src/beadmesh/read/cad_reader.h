// Inside the read room: the way to OpenCASCADE, without its headers.
#pragma once

#include <filesystem>

#include "beadmesh/core/context.h"
#include "beadmesh/core/result.h"
#include "beadmesh/read/panel_reader.h"

namespace beadmesh {

/// STEP, IGES or BREP into a panel; catches every exception of OpenCASCADE.
Result<Panel> read_cad_panel(const std::filesystem::path& path, const ReadOptions& options,
                             const Context& context);

}  // namespace beadmesh
