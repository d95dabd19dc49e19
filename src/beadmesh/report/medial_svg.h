// A picture of medial objects in their flattened planes.
#pragma once

#include <string>
#include <vector>

#include "beadmesh/medial/face_medial.h"

namespace beadmesh {

/// A whole SVG file: boundary, axis coloured by thickness with its scale, vertices marked by type with their
/// inscribed circles and touching points. Several faces are laid side by side at one scale.
std::string medial_svg(const std::vector<FaceMedial>& faces, const std::string& title);

}  // namespace beadmesh
