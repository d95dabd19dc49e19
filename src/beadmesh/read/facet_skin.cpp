#include "beadmesh/read/facet_skin.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "beadmesh/read/facet_curve.h"
#include "beadmesh/read/facet_grouping.h"
#include "beadmesh/read/feature_confidence.h"
#include "beadmesh/read/outline_straightening.h"
#include "beadmesh/read/part_lines.h"
#include "beadmesh/read/sheet_band.h"

namespace beadmesh {
namespace {

/// A smooth outline of a narrow bead turns by 50 degrees from one coarse element to the next.
constexpr double coarse_corner = radians(65);
/// Outlines run along facet edges and have teeth.
constexpr double outline_corner = radians(65);
constexpr double corner_reach = 3;  // mm
constexpr double unsure = 0.4;      // confidence that is worth a note

class SkinBuilder {
 public:
  SkinBuilder(FacetMesh mesh, double feature_angle) : feature_angle_(feature_angle), mesh_(std::move(mesh)) {
    corner_angle_ = is_coarse(mesh_) ? coarse_corner : feature_angle;
    panel_.is_facetted = true;
    panel_.diagnostics = mesh_.repairs;
  }

  Panel build() {
    FacetGroupingOptions options;
    options.feature_angle = feature_angle_;
    FacetGroups groups = group_facets(mesh_, grow_sheets(mesh_), options);
    straighten_outlines(mesh_, groups);
    panel_.points = mesh_.points;
    const std::vector<double> sure = confidences(mesh_, groups);
    face_ = std::move(groups.face);
    is_feature_ = groups.is_feature;
    mark_lines();
    const std::vector<Index> parts = parts_of_faces(mesh_, face_);
    std::vector<std::vector<Triangle>> faces(parts.size());
    for (Index t = 0; t < mesh_.triangle_count(); ++t) faces[face_[t]].push_back(mesh_.triangles[t]);
    for (std::size_t f = 0; f < faces.size(); ++f) add_face(faces[f], parts[f], sure[f]);
    return std::move(panel_);
  }

 private:
  /// Half-edges that have their own region on one side only are lines; points where lines end, branch or bend
  /// are corners.
  bool is_line(Index h) const {
    return mesh_.partner[h] == no_index || face_[mesh_.partner[h] / 3] != face_[h / 3];
  }

  void mark_lines() {
    std::map<std::pair<Index, Index>, int> seen;
    for (Index h = 0; h < 3 * mesh_.triangle_count(); ++h) {
      if (!is_line(h)) continue;
      const auto key = std::minmax({mesh_.tail(h), mesh_.head(h)});
      if (seen[std::pair{key.first, key.second}]++ > 0) continue;
      line_ends_[mesh_.tail(h)].push_back(mesh_.head(h));
      line_ends_[mesh_.head(h)].push_back(mesh_.tail(h));
      const bool is_outline =
          mesh_.partner[h] != no_index && (is_feature_[face_[h / 3]] || is_feature_[face_[mesh_.beyond(h)]]);
      outline_ends_[mesh_.tail(h)] += is_outline ? 1 : 0;
      outline_ends_[mesh_.head(h)] += is_outline ? 1 : 0;
    }
    is_corner_.assign(panel_.points.size(), false);
    for (const auto& [p, others] : line_ends_) {
      const double limit = outline_ends_[p] == 2 ? outline_corner : corner_angle_;
      is_corner_[p] =
          others.size() != 2 || angle_between(way_along(p, others[0]), -way_along(p, others[1])) > limit;
    }
  }

  /// Direction from a point of a line to where the line is `corner_reach` away: a tooth smaller than that is
  /// no corner.
  Vec3 way_along(Index from, Index next) const {
    Index before = from;
    for (int step = 0; step < 100 && distance(panel_.points[next], panel_.points[from]) < corner_reach;
         ++step) {
      const std::vector<Index>& ends = line_ends_.at(next);
      if (ends.size() != 2) break;
      const Index after = ends[0] == before ? ends[1] : ends[0];
      if (after == from) break;
      before = next;
      next = after;
    }
    return panel_.points[next] - panel_.points[from];
  }

  void add_face(const std::vector<Triangle>& triangles, Index part, double confidence) {
    PanelFace face;
    face.part = part;
    face.confidence = confidence;
    face.facets = facets_of_triangles(panel_.points, triangles);
    const Index id = static_cast<Index>(panel_.faces.size());
    face.number = id + 1;
    face.facets.triangle_surface.assign(triangles.size(), 0);
    for (std::vector<Index>& loop : face.facets.loops) face.loops.push_back(edges_of(loop, face.facets, id));
    if (confidence > 0 && confidence < unsure)
      panel_.diagnostics.push_back({"read.unsure",
                                    Severity::note,
                                    face.number,
                                    {},
                                    "this feature stands out from its sheet with a confidence of " +
                                        std::to_string(int(100 * confidence)) + " % only",
                                    "finer facets tell more"});
    panel_.faces.push_back(std::move(face));
  }

  /// Turns the loop to begin at a corner (or else at its smallest point, so that both its faces begin alike)
  /// and cuts it.
  std::vector<EdgeUse> edges_of(std::vector<Index>& loop, const Facets& facets, Index face) {
    const auto point = [&](Index v) { return facets.panel_points[v]; };
    auto start = std::find_if(loop.begin(), loop.end(), [&](Index v) { return is_corner_[point(v)]; });
    if (start == loop.end())
      start =
          std::min_element(loop.begin(), loop.end(), [&](Index a, Index b) { return point(a) < point(b); });
    std::rotate(loop.begin(), start, loop.end());
    std::vector<EdgeUse> uses;
    std::vector<Index> run{point(loop.front())};
    for (std::size_t i = 1; i <= loop.size(); ++i) {
      run.push_back(point(loop[i % loop.size()]));
      if (i < loop.size() && !is_corner_[run.back()]) continue;
      uses.push_back(edge_along(run, face));
      run = {run.back()};
    }
    return uses;
  }

  EdgeUse edge_along(const std::vector<Index>& run, Index face) {
    const std::pair<Index, Index> first{run[0], run[1]}, last{run.back(), run[run.size() - 2]};
    auto found = edge_from_.find(first);
    if (found == edge_from_.end()) {
      const Index e = static_cast<Index>(panel_.edges.size());
      PanelEdge edge;
      edge.points = run;
      std::vector<Vec3> points;
      for (const Index v : run) points.push_back(panel_.points[v]);
      auto [curve, parameters] = curve_through(points);
      edge.curve = std::move(curve);
      edge.parameters = std::move(parameters);
      panel_.edges.push_back(std::move(edge));
      edge_from_[last] = {e, true};
      found = edge_from_.insert_or_assign(first, EdgeUse{e, false}).first;
    }
    panel_.edges[found->second.edge].faces.push_back(face);
    return found->second;
  }

  const double feature_angle_;
  double corner_angle_;  ///< a line that turns by more has a corner
  FacetMesh mesh_;
  Panel panel_;
  std::vector<Index> face_;                        ///< per triangle
  std::vector<bool> is_feature_;                   ///< per face
  std::map<Index, int> outline_ends_;              ///< per point: lines beside features that end there
  std::map<Index, std::vector<Index>> line_ends_;  ///< point -> the other ends of the lines there
  std::vector<bool> is_corner_;
  std::map<std::pair<Index, Index>, EdgeUse> edge_from_;  // first segment -> the edge that begins with it
};

}  // namespace

Panel panel_of_facets(const LooseFacets& facets, double feature_angle) {
  return SkinBuilder(weld_facets(facets), feature_angle).build();
}

}  // namespace beadmesh
