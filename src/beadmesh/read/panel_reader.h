// Files in, panels out.
#pragma once

#include <filesystem>

#include "beadmesh/core/context.h"
#include "beadmesh/core/result.h"
#include "beadmesh/panel/panel.h"
#include "beadmesh/panel/thin_solid.h"

namespace beadmesh {

struct ReadOptions {
  double chord = 0.05;  ///< default 0.05 mm: distance of facets from the surface, the worst up to twice that
  double angle = radians(12);   ///< default 12 degrees: largest turn of a facet edge
  double max_facet = 0;         ///< default 0 = none: longest facet edge, mm
  double sew_tolerance = 0.01;  ///< default 0.01 mm: free edges closer than this are one
  double feature_angle =
      radians(40);          ///< default 40 degrees: STL facets that turn by more are different faces
  Skin skin = Skin::outer;  ///< default outer: what a thin solid of a CAD file becomes
  std::string unit = "mm";  ///< default mm: unit of files that carry none (STL, BREP)
};

/// Does the name end as one of a panel file (any case)?
bool has_panel_ending(const std::filesystem::path& path);

/// Reads STEP, IGES, BREP or STL by ending (.step .stp .igs .iges .brep .stl; any case). Fails with read.*:
/// no such file, a directory, empty, truncated, no faces, unknown ending. One bad face is left out and named
/// in Panel::diagnostics.
Result<Panel> read_panel(const std::filesystem::path& path, const ReadOptions& options = {},
                         const Context& context = {});

}  // namespace beadmesh
