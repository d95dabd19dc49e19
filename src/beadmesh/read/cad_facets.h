// Inside the read room: the facets of every face, on shared edge points.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beadmesh/core/context.h"
#include "beadmesh/core/vector.h"
#include "beadmesh/read/cad_edges.h"
#include "beadmesh/read/cad_topology.h"

namespace beadmesh {

/// One passage of a loop along an edge: its nodes in the loop's direction, both ends included.
struct NodeRun {
  Index edge = no_index;    ///< in CadTopology::edges; no_index at a pole
  Index vertex = no_index;  ///< of a pole: all nodes are this vertex
  bool reversed = false;
  std::vector<Index> nodes;
};

/// Facets of one face in the parameters of its surface, oriented as the surface (not as the face).
struct FaceNodes {
  std::vector<Vec2> uv;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;          ///< empty where the face could not be facetted
  std::vector<std::vector<NodeRun>> loops;  ///< along each loop, face on the left
  std::string defect;                       ///< why there are no triangles
  std::optional<Vec3> crossing;             ///< set where a loop crosses itself or another
};

/// Facets one face. Boundary points come from the edges; inner points are spawned from the boundary inwards,
/// in hexagonal packing on the surface (after "Simultaneous spawning", Baudouin, Remacle et al. 2014), then
/// triangulated (constrained Delaunay in the stretched parameters), then edges are flipped to be Delaunay in
/// space.
FaceNodes facet_face(const CadTopology& topology, Index face, FaceSpace space, double chord);

/// Samples the edges of `topology` and facets all its faces.
std::vector<FaceNodes> facet_faces(CadTopology& topology, const ReadOptions& options, const Context& context);

}  // namespace beadmesh
