// Example panels and broken inputs as STEP files (AP214, mm). All return false where the file cannot be
// written.
#pragma once

#include <filesystem>

#include "examples/panel_design.h"

namespace beadmesh::examples {

bool write_panel(const PanelDesign& design, const std::filesystem::path& path);
/// A flat face inside a bow tie of four straight edges.
bool write_bow_tie(const std::filesystem::path& path);
/// A flat face inside one smooth edge that runs as a figure of eight.
bool write_figure_of_eight(const std::filesystem::path& path);
/// An edge on its own: a valid file without a face.
bool write_lone_edge(const std::filesystem::path& path);

}  // namespace beadmesh::examples
