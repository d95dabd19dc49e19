// Inside the read room: inner points of a face.
#pragma once

#include <vector>

#include "beadmesh/read/cad_facets.h"

namespace beadmesh {

/// Appends inner points to uv and points of `nodes`: from each point outwards in six directions at the wanted
/// distance, in order, where no other point is near. Based on: Baudouin, Remacle, Marchandise, Henrotte,
/// Geuzaine, "A frontal approach to hex-dominant mesh generation", 2014 (point spawning), with a hexagonal
/// pattern. False where the face would take more points than any sheet needs, as between a boundary and a
/// surface that do not belong together.
bool spawn_inner_points(const Geom_Surface& surface, const FaceSpace& space,
                        const std::vector<std::vector<Index>>& polygons, FaceNodes& nodes);

}  // namespace beadmesh
