// Internal to the room: facets cut open along a way.
#pragma once

#include <vector>

#include "beadmesh/flatten/surface_path.h"

namespace beadmesh {

/// Facets with a mark per vertex that says which vertices were one before any cut.
struct CutFacets {
  Facets facets;
  std::vector<Index> origin;  ///< per point; equal for the copies of one point on either side of a cut
};

/// Splits the triangles the way crosses and cuts the piece along it; loops are traced anew. `way` as from
/// shortest_path; a triangle it crosses twice makes this fail (false, and `piece` stays).
bool cut_along(CutFacets& piece, const std::vector<PathStop>& way);

/// Per loop and segment: is there a partner that runs the other way over the same origins.
std::vector<std::vector<bool>> cut_sides(const std::vector<std::vector<Index>>& loops,
                                         const std::vector<Index>& origin);

/// The piece with points of equal origin made one: its cuts and seams closed, loops traced anew.
CutFacets sewn(const Facets& facets, const std::vector<Index>& origin);

}  // namespace beadmesh
