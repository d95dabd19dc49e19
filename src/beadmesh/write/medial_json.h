// Medial objects as JSON, schema beadmesh.medial/1.
#pragma once

#include <iosfwd>
#include <vector>

#include "beadmesh/flatten/cut_open.h"
#include "beadmesh/medial/face_medial.h"

namespace beadmesh {

/// Lengths in mm, angles in degrees; the touching points of an edge's points lie left and right of its
/// direction. Feet that are known in the plane only are written as [u, v, 0]. `images` (one a face, or none
/// at all) adds how each face came into the plane: its distortion, and the sides of the cuts that opened it
/// as intervals of arc length along the loops.
void write_medial_json(std::ostream& out, const std::vector<FaceMedial>& faces,
                       const std::vector<PlaneImage>& images = {});

}  // namespace beadmesh
