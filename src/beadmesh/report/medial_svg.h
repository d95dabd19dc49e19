// A picture of medial objects in their flattened planes.
#pragma once

#include <string>
#include <vector>

#include "beadmesh/flatten/cut_open.h"
#include "beadmesh/medial/face_medial.h"

namespace beadmesh {

struct MedialPicture {
  bool feet = false;               ///< default false: lines from the axis to its touching points
  std::vector<PlaneImage> images;  ///< one a face, for the sides of cuts; or none at all
};

/// A whole SVG file: boundary, axis coloured by thickness with its scale in mm, vertices marked by type with
/// their counts and inscribed circles. Strokes and marks follow the spacing of the vertices, so that
/// thousands stay readable; what is finer than a pixel is left out. Several faces are laid side by side at
/// one scale.
std::string medial_svg(const std::vector<FaceMedial>& faces, const std::string& title,
                       const MedialPicture& picture = {});

}  // namespace beadmesh
