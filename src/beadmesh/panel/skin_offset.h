// Inside the panel room: a skin moved along its normals.
#pragma once

#include <vector>

#include "beadmesh/panel/panel.h"

namespace beadmesh {

/// Moves each face against its normal by its own distance (mm, one a face); points between faces go where the
/// moved faces meet. Edges lose their exact curves; a face with a sharp edge loses its surface, since where
/// moved faces meet is not above the old edge.
void move_inwards(Panel& panel, const std::vector<double>& distances);

}  // namespace beadmesh
