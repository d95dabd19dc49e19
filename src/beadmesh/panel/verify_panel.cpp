#include <algorithm>
#include <map>
#include <string>

#include "beadmesh/panel/panel.h"

namespace beadmesh {
namespace {

class PanelChecker {
 public:
  explicit PanelChecker(const Panel& panel) : panel_(panel), tolerance_(1e-6 * diagonal(panel) + 1e-3) {}

  std::vector<std::string> check() {
    for (Index e = 0; e < size_of(panel_.edges); ++e) check_edge(e);
    if (!violations_.empty()) return std::move(violations_);  // later checks need sound indices
    uses_.resize(panel_.edges.size());
    for (Index f = 0; f < size_of(panel_.faces); ++f) check_face(f);
    for (Index e = 0; e < size_of(panel_.edges); ++e) check_uses(e);
    return std::move(violations_);
  }

 private:
  template <class T>
  static Index size_of(const std::vector<T>& v) {
    return static_cast<Index>(v.size());
  }
  template <class T>
  static bool is_index(Index i, const std::vector<T>& v) {
    return i >= 0 && i < size_of(v);
  }

  void report(const std::string& what) { violations_.push_back(what); }

  void check_edge(Index e) {
    const PanelEdge& edge = panel_.edges[e];
    const std::string name = "edge " + std::to_string(e);
    if (edge.points.size() < 2) return report(name + " has fewer than 2 points");
    for (const Index p : edge.points)
      if (!is_index(p, panel_.points)) return report(name + " names a point that does not exist");
    for (const Index f : edge.faces)
      if (!is_index(f, panel_.faces)) return report(name + " names a face that does not exist");
    if (!edge.curve) return;
    if (edge.parameters.size() != edge.points.size()) return report(name + " lacks parameters");
    const bool rising = edge.parameters.back() > edge.parameters.front();
    for (std::size_t i = 0; i < edge.points.size(); ++i) {
      if (i > 0 && (edge.parameters[i] > edge.parameters[i - 1]) != rising)
        return report(name + " has parameters that are not monotone");
      if (distance(edge.curve->point(edge.parameters[i]), panel_.points[edge.points[i]]) > 10 * tolerance_)
        return report(name + " has point " + std::to_string(i) + " off its curve");
    }
  }

  void check_face(Index f) {
    const PanelFace& face = panel_.faces[f];
    const std::string name = "face " + std::to_string(face.number);
    if (!check_arrays(name, f)) return;
    check_manifold(name, face.facets);
    if (face.loops.size() != face.facets.loops.size()) return report(name + ": loops and facet loops differ");
    for (std::size_t l = 0; l < face.loops.size(); ++l) check_loop(name, f, l);
    if (!face.loops.empty() && outer_loop(face.facets) != 0)
      report(name + ": the outer loop is not the first");
  }

  bool check_arrays(const std::string& name, Index f) {
    const Facets& facets = panel_.faces[f].facets;
    const std::size_t before = violations_.size();
    if (facets.triangles.empty()) report(name + " has no triangles");
    if (facets.points.size() != facets.panel_points.size()) report(name + ": points and panel_points differ");
    if (facets.triangle_surface.size() != facets.triangles.size())
      report(name + ": triangle_surface is incomplete");
    if (!facets.triangle_uv.empty() && facets.triangle_uv.size() != facets.triangles.size())
      report(name + ": triangle_uv is incomplete");
    for (const Index surface : facets.triangle_surface)
      if (surface != 0 && !is_index(surface, facets.surfaces))
        return report(name + ": triangle_surface names no surface"), false;
    for (const Triangle& t : facets.triangles)
      for (const Index v : t)
        if (!is_index(v, facets.points)) return report(name + ": a triangle names no vertex"), false;
    for (std::size_t v = 0; v < facets.panel_points.size(); ++v)
      if (!is_index(facets.panel_points[v], panel_.points) ||
          facets.points[v] != panel_.points[facets.panel_points[v]])
        return report(name + ": vertex " + std::to_string(v) + " differs from its panel point"), false;
    for (const std::vector<Index>& loop : facets.loops)
      for (const Index v : loop)
        if (!is_index(v, facets.points)) return report(name + ": a loop names no vertex"), false;
    return violations_.size() == before;
  }

  /// Every directed half-edge once; those without an opposite are exactly the loops' segments; one connected
  /// piece.
  void check_manifold(const std::string& name, const Facets& facets) {
    std::map<std::pair<Index, Index>, Index> half_edges;
    for (Index t = 0; t < size_of(facets.triangles); ++t)
      for (int k = 0; k < 3; ++k)
        if (!half_edges.emplace(std::pair{facets.triangles[t][k], facets.triangles[t][(k + 1) % 3]}, t)
                 .second)
          return report(name + ": two triangles run the same way along an edge");
    std::vector<std::pair<Index, Index>> boundary, loops;
    for (const auto& [edge, t] : half_edges)
      if (!half_edges.count({edge.second, edge.first})) boundary.push_back(edge);
    for (const std::vector<Index>& loop : facets.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) loops.push_back({loop[i], loop[(i + 1) % loop.size()]});
    std::sort(loops.begin(), loops.end());
    if (loops != boundary) report(name + ": the loops are not the boundary of the triangles");
    check_connected(name, facets, half_edges);
  }

  void check_connected(const std::string& name, const Facets& facets,
                       const std::map<std::pair<Index, Index>, Index>& half_edges) {
    std::vector<bool> seen(facets.triangles.size(), false);
    std::vector<Index> stack{0};
    Index count = 0;
    while (!stack.empty()) {
      const Index t = stack.back();
      stack.pop_back();
      if (seen[t]) continue;
      seen[t] = true;
      ++count;
      for (int k = 0; k < 3; ++k) {
        const auto other = half_edges.find({facets.triangles[t][(k + 1) % 3], facets.triangles[t][k]});
        if (other != half_edges.end()) stack.push_back(other->second);
      }
    }
    if (count != size_of(facets.triangles)) report(name + ": the triangles are not connected");
  }

  void check_loop(const std::string& name, Index f, std::size_t l) {
    const PanelFace& face = panel_.faces[f];
    std::vector<Index> points;
    for (const EdgeUse use : face.loops[l]) {
      if (!is_index(use.edge, panel_.edges)) return report(name + ": a loop names no edge");
      uses_[use.edge].push_back({f, use.reversed});
      std::vector<Index> run = panel_.edges[use.edge].points;
      if (use.reversed) std::reverse(run.begin(), run.end());
      if (!points.empty() && points.back() != run.front())
        return report(name + ": loop " + std::to_string(l) + " is not head to tail");
      points.insert(points.end(), run.begin() + (points.empty() ? 0 : 1), run.end());
    }
    if (points.empty() || points.front() != points.back())
      return report(name + ": loop " + std::to_string(l) + " is not closed");
    points.pop_back();
    std::vector<Index> facet_points;
    for (const Index v : face.facets.loops[l]) facet_points.push_back(face.facets.panel_points[v]);
    if (points != facet_points)
      report(name + ": loop " + std::to_string(l) + " and its facets run through different points");
  }

  void check_uses(Index e) {
    const std::string name = "edge " + std::to_string(e);
    std::vector<Index> faces = panel_.edges[e].faces, found;
    for (const auto& [f, reversed] : uses_[e]) found.push_back(f);
    std::sort(faces.begin(), faces.end());
    std::sort(found.begin(), found.end());
    if (faces != found) report(name + ": its faces are not those whose loops use it");
    if (uses_[e].size() == 2 && uses_[e][0].second == uses_[e][1].second)
      report(name + ": its two faces are not oriented alike");
  }

  const Panel& panel_;
  double tolerance_;
  std::vector<std::vector<std::pair<Index, bool>>> uses_;  // per edge: (face, reversed)
  std::vector<std::string> violations_;
};

}  // namespace

std::vector<std::string> verify_panel(const Panel& panel) {
  return PanelChecker(panel).check();
}

}  // namespace beadmesh
