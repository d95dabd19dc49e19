#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "beadmesh/panel/panel.h"

namespace beadmesh {
namespace {

class FaceMerger {
 public:
  FaceMerger(const Panel& panel, const std::vector<std::vector<Index>>& groups)
      : panel_(panel), group_of_(panel.faces.size(), no_index) {
    for (const std::vector<Index>& group : groups) {
      if (group.size() < 2) continue;
      for (const Index f : group) group_of_[f] = static_cast<Index>(merged_.size());
      merged_.push_back(merged(group));
      if (merged_.back()) continue;
      for (const Index f : group) group_of_[f] = no_index;
    }
  }

  Panel run() {
    out_.points = panel_.points;
    out_.parts = panel_.parts;
    out_.input = panel_.input;
    out_.unit = panel_.unit;
    out_.diagnostics = panel_.diagnostics;
    new_edge_.assign(panel_.edges.size(), no_index);
    for (std::size_t f = 0; f < panel_.faces.size(); ++f) {
      if (group_of_[f] == no_index) {
        add_face(panel_.faces[f]);
      } else if (merged_[group_of_[f]]) {
        add_face(std::move(*merged_[group_of_[f]]));
        merged_[group_of_[f]].reset();
      }
    }
    return std::move(out_);
  }

 private:
  std::optional<PanelFace> merged(const std::vector<Index>& group) const {
    PanelFace face;
    face.facets = facets_of(panel_, group);
    face.numbers = input_numbers(panel_, group);
    face.number = face.numbers.front();
    face.name = panel_.faces[group.front()].name;
    face.part = panel_.faces[group.front()].part;
    face.thickness = mean_thickness(group);
    const auto runs = boundary_runs(group);
    for (std::vector<Index>& loop : face.facets.loops) {
      auto uses = uses_along(face.facets, loop, runs);
      if (uses.empty()) return std::nullopt;
      face.loops.push_back(std::move(uses));
    }
    return face;
  }

  /// By area, over the faces whose thickness is known; 0 where there is none.
  double mean_thickness(const std::vector<Index>& group) const {
    double sum = 0, known = 0;
    for (const Index f : group) {
      if (panel_.faces[f].thickness <= 0) continue;
      const double weight = area(panel_.faces[f].facets);
      sum += weight * panel_.faces[f].thickness;
      known += weight;
    }
    return known > 0 ? sum / known : 0;
  }

  using Runs = std::map<std::pair<Index, Index>, EdgeUse>;

  /// Uses of the group's edges that have no other side in it, by the first two points they run through.
  Runs boundary_runs(const std::vector<Index>& group) const {
    std::map<Index, std::vector<EdgeUse>> uses;
    for (const Index f : group)
      for (const auto& loop : panel_.faces[f].loops)
        for (const EdgeUse use : loop) uses[use.edge].push_back(use);
    Runs runs;
    for (const auto& [edge, of_edge] : uses) {
      if (of_edge.size() != 1) continue;
      const std::vector<Index>& p = panel_.edges[edge].points;
      const std::size_t n = p.size();
      runs[of_edge[0].reversed ? std::pair{p[n - 1], p[n - 2]} : std::pair{p[0], p[1]}] = of_edge[0];
    }
    return runs;
  }

  /// The edges that a loop of facets runs along; the loop is turned so that it starts with the first. Empty
  /// where it does not follow edges.
  std::vector<EdgeUse> uses_along(const Facets& facets, std::vector<Index>& loop, const Runs& runs) const {
    const std::size_t n = loop.size();
    const auto starting_at = [&](std::size_t i) {
      return runs.find({facets.panel_points[loop[i % n]], facets.panel_points[loop[(i + 1) % n]]});
    };
    std::size_t first = 0;
    while (first < n && starting_at(first) == runs.end()) ++first;
    std::vector<EdgeUse> uses;
    for (std::size_t i = 0; i < n;) {
      const auto run = starting_at(first + i);
      if (first == n || run == runs.end()) return {};
      uses.push_back(run->second);
      i += panel_.edges[run->second.edge].points.size() - 1;
      if (i > n) return {};
    }
    std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
    return uses;
  }

  void add_face(PanelFace face) {
    const Index id = static_cast<Index>(out_.faces.size());
    for (auto& loop : face.loops)
      for (EdgeUse& use : loop) {
        use.edge = edge(use.edge);
        out_.edges[use.edge].faces.push_back(id);
      }
    out_.faces.push_back(std::move(face));
  }

  Index edge(Index e) {
    if (new_edge_[e] == no_index) {
      new_edge_[e] = static_cast<Index>(out_.edges.size());
      out_.edges.push_back(panel_.edges[e]);
      out_.edges.back().faces.clear();
    }
    return new_edge_[e];
  }

  const Panel& panel_;
  std::vector<Index> group_of_;
  std::vector<std::optional<PanelFace>> merged_;
  std::vector<Index> new_edge_;
  Panel out_;
};

}  // namespace

Panel with_merged_faces(Panel panel, const std::vector<std::vector<Index>>& groups) {
  if (groups.empty()) return panel;
  return FaceMerger(panel, groups).run();
}

}  // namespace beadmesh
