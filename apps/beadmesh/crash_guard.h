// A crash of the CAD kernel while it reads a damaged file, as a refusal of that file.
#pragma once

#include <filesystem>

#include "beadmesh/read/panel_reader.h"

namespace beadmesh::app {

/// read_panel(). A fault of the process (segmentation, bus, arithmetic, abort) meanwhile ends it with exit
/// status 2 and one line that names the file; before and after, faults are what they were. One call at a
/// time.
Result<Panel> read_guarded(const std::filesystem::path& path, const ReadOptions& options,
                           const Context& context);

}  // namespace beadmesh::app
