// Small panels made by hand, for the tests of several rooms.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "beadmesh/panel/panel.h"

namespace beadmesh::test {

/// Adds a face of `triangles` (indices into panel.points) with loops in the order and phase of `loops`.
inline void add_face(Panel& panel, const std::vector<Triangle>& triangles,
                     std::vector<std::vector<EdgeUse>> loops) {
  const Index id = static_cast<Index>(panel.faces.size());
  PanelFace face;
  face.facets = facets_of_triangles(panel.points, triangles);
  face.facets.triangle_surface.assign(triangles.size(), 0);
  face.number = id + 1;
  face.facets.loops.clear();
  for (const std::vector<EdgeUse>& loop : loops) {
    std::vector<Index> vertices;
    for (const EdgeUse use : loop) {
      std::vector<Index> points = panel.edges[use.edge].points;
      if (use.reversed) std::reverse(points.begin(), points.end());
      points.pop_back();
      for (const Index p : points)
        for (std::size_t v = 0; v < face.facets.panel_points.size(); ++v)
          if (face.facets.panel_points[v] == p) vertices.push_back(static_cast<Index>(v));
      panel.edges[use.edge].faces.push_back(id);
    }
    face.facets.loops.push_back(vertices);
  }
  face.loops = std::move(loops);
  panel.faces.push_back(std::move(face));
}

inline void add_edge(Panel& panel, std::vector<Index> points) {
  PanelEdge edge;
  edge.points = std::move(points);
  panel.edges.push_back(std::move(edge));
}

/// Two unit squares side by side, sharing edge 0 from (1, 0) to (1, 1). The outer border of the left one is
/// edges 1 to 3, of the right one 4 to 6; both counter-clockwise. The right one is lifted at its far end by
/// `lift`.
inline Panel two_squares(double lift = 0) {
  Panel panel;
  panel.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, lift}, {2, 1, lift}};
  for (std::vector<Index> points : {std::vector<Index>{1, 2}, {2, 3}, {3, 0}, {0, 1}, {1, 4}, {4, 5}, {5, 2}})
    add_edge(panel, points);
  add_face(panel, {{0, 1, 2}, {0, 2, 3}}, {{{0, false}, {1, false}, {2, false}, {3, false}}});
  add_face(panel, {{1, 4, 5}, {1, 5, 2}}, {{{4, false}, {5, false}, {6, false}, {0, true}}});
  return panel;
}

/// A disc of radius 1 in a ring of outer radius 2: the circle between them is two half circles (edges 0 and
/// 1) of n / 2 segments each, the outer circle one closed edge (2).
inline Panel disc_in_ring(int n = 24) {
  Panel panel;
  for (const double radius : {1.0, 2.0})
    for (int i = 0; i < n; ++i)
      panel.points.push_back({radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n), 0});
  panel.points.push_back({0, 0, 0});
  std::vector<std::vector<Index>> edges(3);
  for (int i = 0; i <= n / 2; ++i) edges[0].push_back(i);
  for (int i = n / 2; i <= n; ++i) edges[1].push_back(i % n);
  for (int i = 0; i <= n; ++i) edges[2].push_back(n + i % n);
  for (const std::vector<Index>& points : edges) add_edge(panel, points);
  std::vector<Triangle> disc, ring;
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    disc.push_back({i, j, 2 * n});
    ring.push_back({i, n + i, n + j});
    ring.push_back({i, n + j, j});
  }
  add_face(panel, disc, {{{0, false}, {1, false}}});
  add_face(panel, ring, {{{2, false}}, {{1, true}, {0, true}}});
  return panel;
}

}  // namespace beadmesh::test
