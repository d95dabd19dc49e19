// Internal to the room: short ways over the facets of a piece.
#pragma once

#include <vector>

#include "beadmesh/panel/facets.h"

namespace beadmesh {

/// A stop of a way over facets: a vertex, or a point between the ends of an edge.
struct PathStop {
  Index from = no_index, to = no_index;  ///< the edge's vertices, from < to; equal: the vertex
  double at = 0;                         ///< 0 to 1 along the edge

  bool is_vertex() const { return from == to; }
  friend bool operator==(const PathStop&, const PathStop&) = default;
};

/// The shortest way from any of `sources` to any of `targets` (vertices): Dijkstra over the vertices and some
/// points of every edge, then drawn straight within the triangles it crosses. Empty where there is none.
/// Consecutive stops lie on one triangle. Ways touch boundary loops at their ends only, where they can.
std::vector<PathStop> shortest_path(const Facets& facets, const std::vector<Index>& sources,
                                    const std::vector<Index>& targets);

/// The vertex farthest from `sources` along edges.
Index farthest_vertex(const Facets& facets, const std::vector<Index>& sources);

}  // namespace beadmesh
