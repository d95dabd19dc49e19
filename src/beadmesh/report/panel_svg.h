// A picture of a meshed panel: its beads by kind, their crest lines and medial axes, the mesh.
#pragma once

#include <string>

#include "beadmesh/mesh/panel_mesh.h"

namespace beadmesh {

struct PanelPictureOptions {
  Vec3 view;            ///< default 0: along the mean normal of the mesh; direction from the panel to the eye
  double width = 1400;  ///< default 1400: of the drawing, pixels
  bool labels = true;   ///< default true: id and shape at every bead
};

/// A whole SVG file. About 40 bytes an element; colours that are told apart with any colour vision (Okabe and
/// Ito 2008).
std::string panel_svg(const PanelMesh& panel, const PanelPictureOptions& options = {});

}  // namespace beadmesh
