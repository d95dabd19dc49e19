// Any flat panel as a CAD kernel makes it: vertical walls, with its own fillets at root and top.
#pragma once

#include <cstdint>
#include <filesystem>

#include "examples/panel_design.h"

namespace beadmesh::examples {

/// Makes the base flat and takes features out that cannot be made so (rings that share loops, sharp corners).
/// The footprints stay: walls stand inside them by the radius of the root fillet. Radii are left to chance.
void prepare_for_kernel(PanelDesign& panel, std::uint64_t seed);

/// STEP, mm; false where the kernel cannot make it, or it cannot be written.
bool write_kernel_panel(const PanelDesign& panel, const std::filesystem::path& path);

}  // namespace beadmesh::examples
