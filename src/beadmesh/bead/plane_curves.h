// The exact curves of a plane face's boundary, in the plane of its flat image.
#pragma once

#include <functional>
#include <optional>

#include "beadmesh/bead/face_study.h"

namespace beadmesh {

/// The segment of an edge's polyline under a segment of the boundary.
struct EdgeSegment {
  Index edge = no_index;  ///< in Panel::edges
  Index step = 0;         ///< from the edge's point `step` to the next one, or back
  bool reversed = false;
};

/// Which edge a segment of the flat boundary lies on; nothing on a cut.
using EdgeOfSegment = std::function<std::optional<EdgeSegment>(std::size_t loop, std::size_t segment)>;

/// Gives the region of a study its exact curves where the face is plane, so that its flat image is the face
/// itself, and every edge has a curve that passes its points. Segments on which the curve is straight stay
/// straight. Joints that turn by more than `corner_angle` (radians) become corners. False, and nothing done,
/// on any other face.
bool add_plane_curves(FaceStudy& study, const Panel& panel, const EdgeOfSegment& edge_of,
                      double corner_angle = radians(2));

}  // namespace beadmesh
