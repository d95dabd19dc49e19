// Medial objects as JSON, schema beadmesh.medial/1.
#pragma once

#include <string>
#include <vector>

#include "beadmesh/medial/face_medial.h"

namespace beadmesh {

/// Lengths in mm, angles in degrees; the touching points of an edge's points lie left and right of its
/// direction. Feet that are known in the plane only are written as [u, v, 0].
std::string medial_json(const std::vector<FaceMedial>& faces);

}  // namespace beadmesh
