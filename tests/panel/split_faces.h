// Panels whose faces are cut into many, as CAD systems hand them over.
#pragma once

#include <algorithm>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "beadmesh/panel/panel.h"

namespace beadmesh::test {

/// The same panel with an edge for every segment; exact curves are left out.
inline Panel with_segment_edges(Panel panel) {
  std::vector<PanelEdge> edges;
  std::vector<std::vector<Index>> parts;
  for (const PanelEdge& edge : panel.edges) {
    parts.emplace_back();
    for (std::size_t i = 1; i < edge.points.size(); ++i) {
      parts.back().push_back(static_cast<Index>(edges.size()));
      edges.push_back({{edge.points[i - 1], edge.points[i]}, {}, nullptr, edge.faces});
    }
  }
  for (PanelFace& face : panel.faces)
    for (auto& loop : face.loops) {
      std::vector<EdgeUse> uses;
      for (const EdgeUse use : loop) {
        std::vector<Index> of_use = parts[use.edge];
        if (use.reversed) std::reverse(of_use.begin(), of_use.end());
        for (const Index e : of_use) uses.push_back({e, use.reversed});
      }
      loop = uses;
    }
  panel.edges = std::move(edges);
  return panel;
}

/// Cuts a face between triangles whose centres have different colours; a colour may make several faces. The
/// first takes the face's place, the others come last. Needs an edge for every segment.
class FaceSplitter {
 public:
  FaceSplitter(Panel& panel, Index face) : panel_(panel), face_(face), whole_(panel.faces[face]) {
    for (std::size_t e = 0; e < panel.edges.size(); ++e) {
      const auto& p = panel.edges[e].points;
      edge_of_[std::minmax(p[0], p[1])] = static_cast<Index>(e);
      auto& faces = panel_.edges[e].faces;
      faces.erase(std::remove(faces.begin(), faces.end(), face), faces.end());
    }
  }

  void split(const std::function<int(Vec3)>& colour) {
    const auto part = parts(colour);
    const int count = 1 + *std::max_element(part.begin(), part.end());
    for (int k = 0; k < count; ++k) add_part(part, k);
  }

 private:
  std::vector<Index> panel_triangle(std::size_t t) const {
    std::vector<Index> points;
    for (const Index v : whole_.facets.triangles[t]) points.push_back(whole_.facets.panel_points[v]);
    return points;
  }

  /// Per triangle: which connected piece of one colour it belongs to.
  std::vector<int> parts(const std::function<int(Vec3)>& colour) const {
    const Facets& facets = whole_.facets;
    std::map<std::pair<Index, Index>, std::vector<std::size_t>> sides;
    std::vector<int> colours, part(facets.triangles.size(), -1);
    for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
      const Triangle& v = facets.triangles[t];
      colours.push_back(colour((facets.points[v[0]] + facets.points[v[1]] + facets.points[v[2]]) / 3));
      for (int k = 0; k < 3; ++k) sides[std::minmax(v[k], v[(k + 1) % 3])].push_back(t);
    }
    int count = 0;
    for (std::size_t seed = 0; seed < part.size(); ++seed) {
      if (part[seed] >= 0) continue;
      std::vector<std::size_t> stack{seed};
      for (part[seed] = count; !stack.empty();) {
        const Triangle& v = facets.triangles[stack.back()];
        stack.pop_back();
        for (int k = 0; k < 3; ++k)
          for (const std::size_t t : sides[std::minmax(v[k], v[(k + 1) % 3])])
            if (part[t] < 0 && colours[t] == colours[seed]) part[t] = count, stack.push_back(t);
      }
      ++count;
    }
    return part;
  }

  void add_part(const std::vector<int>& part, int k) {
    std::vector<Triangle> triangles;
    PanelFace face;
    std::vector<std::array<Vec2, 3>> uv;
    for (std::size_t t = 0; t < part.size(); ++t) {
      if (part[t] != k) continue;
      const auto points = panel_triangle(t);
      triangles.push_back({points[0], points[1], points[2]});
      if (!whole_.facets.triangle_uv.empty()) uv.push_back(whole_.facets.triangle_uv[t]);
    }
    face.facets = facets_of_triangles(panel_.points, triangles);
    face.facets.triangle_uv = uv;
    face.facets.triangle_surface.assign(triangles.size(), 0);
    face.facets.surfaces = whole_.facets.surfaces;
    const Index id = k == 0 ? face_ : static_cast<Index>(panel_.faces.size());
    face.number = id + 1;
    for (const auto& loop : face.facets.loops) face.loops.push_back(uses_of(face.facets, loop, id));
    if (k == 0)
      panel_.faces[face_] = std::move(face);
    else
      panel_.faces.push_back(std::move(face));
  }

  std::vector<EdgeUse> uses_of(const Facets& facets, const std::vector<Index>& loop, Index face) {
    std::vector<EdgeUse> uses;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index a = facets.panel_points[loop[i]], b = facets.panel_points[loop[(i + 1) % loop.size()]];
      const auto [at, is_new] =
          edge_of_.try_emplace(std::minmax(a, b), static_cast<Index>(panel_.edges.size()));
      if (is_new) panel_.edges.push_back({{a, b}, {}, nullptr, {}});
      PanelEdge& edge = panel_.edges[at->second];
      edge.faces.push_back(face);
      uses.push_back({at->second, edge.points[0] != a});
    }
    return uses;
  }

  Panel& panel_;
  Index face_;
  PanelFace whole_;
  std::map<std::pair<Index, Index>, Index> edge_of_;
};

}  // namespace beadmesh::test
