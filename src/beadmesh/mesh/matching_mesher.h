// Quads inside fixed node loops from a field-aligned triangulation whose triangles are married pairwise.
#pragma once

#include "beadmesh/flatten/flat_face.h"
#include "beadmesh/mesh/planar_mesh.h"

namespace beadmesh {

struct MatchingOptions {
  double size = 5;        ///< default 5 mm: target edge length, measured on the surface
  double min_edge = 2.5;  ///< default 2.5 mm: minimum element length; aimed at here, enforced by the smoothing
};

/// A cross field aligned with the loops, points laid in fronts along it (after Remacle et al., "A frontal Delaunay quad mesh
/// generator using the L-infinity norm", 2013), constrained Delaunay, triangles married by a minimum-cost matching that is
/// made perfect by augmenting paths. Same contract as mesh_by_subdivision: all quads where the total number of loop nodes is
/// even, otherwise one triangle; loop nodes keep their indices and are fixed; `map` null: the plane is the surface.
Result<PlanarMesh> mesh_by_matching(const NodeLoops& loops, const SurfaceMap* map, const MatchingOptions& options = {});

}  // namespace beadmesh
