// Parts of a quad mesh: the elements around one, their outline, and what is left of a mesh after edits.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "beadmesh/mesh/quad_connectivity.h"

namespace beadmesh {

/// The element and `rings` of neighbours over nodes, ascending.
std::vector<Index> elements_within(const QuadConnectivity& mesh, Index element, int rings);

/// Directed edges with the elements on their left and none of them on their right, ascending.
std::vector<std::array<Index, 2>> outline_of(const std::vector<MeshElement>& elements);

/// The outline as one closed line that meets every node once, counter-clockwise; none where it is not so.
std::optional<std::vector<Index>> closed_loop(const std::vector<std::array<Index, 2>>& outline);

/// The mesh without elements and nodes that are gone, in the same order, at the given places. `number` gets
/// the new number per node, no_index for those without elements.
PlanarMesh living_part(const QuadConnectivity& mesh, const std::vector<Vec2>& places,
                       const std::vector<NodeFreedom>& freedom, std::vector<Index>& number);

}  // namespace beadmesh
