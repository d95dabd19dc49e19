// The regular inside of a wide face: cells of a lattice that keep a distance from every loop. Internal to the
// room.
#pragma once

#include "beadmesh/mesh/mesh_draft.h"
#include "beadmesh/mesh/node_loop.h"

namespace beadmesh {

/// A square lattice fitted to a face.
struct Lattice {
  Vec2 origin, first, second;  ///< the two steps, at right angles
};

/// Direction: the loops' edges vote (fourfold symmetric mean). Steps and origin: near the size, such that the
/// nodes of edges along the lattice, most of all a rectangular outline, fall on lattice points.
Lattice fit_lattice(const MeshDraft& draft, const std::vector<NodeLoop>& loops);

/// Adds the cells inside all loops (outer one first) that keep `clearance` steps from every loop edge,
/// without cells that touch the others by a corner only or stick out alone. Returns the outlines of what was
/// added with the cells on their right, so that they are loops of what is left over (face on the left).
std::vector<NodeLoop> add_lattice_core(MeshDraft& draft, const std::vector<NodeLoop>& loops,
                                       const Lattice& lattice, double clearance);

}  // namespace beadmesh
