// Inside the read room: sampling of edges, once for all the faces around them.
#pragma once

#include <optional>
#include <vector>

#include "beadmesh/core/context.h"
#include "beadmesh/read/cad_topology.h"
#include "beadmesh/read/facet_size.h"

namespace beadmesh {

/// The plane in which a face is facetted: its parameters, stretched to about mm, with the facet size wanted
/// there.
struct FaceSpace {
  Vec2 stretch;
  SizeField sizes;

  Vec2 stretched(Vec2 uv) const { return {uv.x * stretch.x, uv.y * stretch.y}; }
  Vec2 plain(Vec2 st) const { return {st.x / stretch.x, st.y / stretch.y}; }
};

/// Per face; none where the face is broken.
using FaceSpaces = std::vector<std::optional<FaceSpace>>;

FaceSpaces face_spaces(const CadTopology& topology, const FacetSize& size, const Context& context);

/// Fills parameters and points of all edges: sizes wanted by curve and faces, then finer where another edge
/// of the same face is near, or a neighbour along the loop is much shorter.
void sample_edges(CadTopology& topology, const FaceSpaces& spaces, const FacetSize& size);

/// Fills parameters and points of all edges from their own curvature alone, within `chord`.
void sample_edges_by_curve(CadTopology& topology, double chord);

/// Mean stretch over the box of the loops' parameters.
Vec2 face_stretch(const CadFace& face);

}  // namespace beadmesh
