// Inside the read room: lines between the parts of a deck.
#pragma once

#include <vector>

#include "beadmesh/read/facet_mesh.h"

namespace beadmesh {

/// Splits sheets (faces that are no features) where two parts meet, so that each keeps its property. Pieces
/// narrower than 5 mm (twice the area per circumference) stay with the neighbour beside which they lie
/// longest: many programs give each strip of a fillet a property. New numbers follow those in use.
void split_by_parts(const FacetMesh& mesh, const std::vector<bool>& is_feature, std::vector<Index>& face);

/// The part that most of the area of each face belongs to; no_index: none.
std::vector<Index> parts_of_faces(const FacetMesh& mesh, const std::vector<Index>& face);

}  // namespace beadmesh
