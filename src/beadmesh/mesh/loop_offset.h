// Lines beside the loops of a face. Internal to the room.
#pragma once

#include <vector>

#include "beadmesh/mesh/planar_mesh.h"

namespace beadmesh {

/// Moved into the face (on the left) by the same distance everywhere, along the bisectors of the corners.
std::vector<Vec2> offset_into_face(const std::vector<Vec2>& loop, double distance);

/// Every edge of `moved` is at least so long and runs the way of its partner.
bool edges_keep_length(const std::vector<Vec2>& loop, const std::vector<Vec2>& moved, double least);

double squared_distance_to_segment(Vec2 point, Vec2 a, Vec2 b);

}  // namespace beadmesh
