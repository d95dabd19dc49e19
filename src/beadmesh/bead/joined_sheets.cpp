#include "beadmesh/bead/joined_sheets.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "beadmesh/bead/continued_sheet.h"
#include "beadmesh/bead/face_study.h"

namespace beadmesh {
namespace {

/// What a face does beside a segment of its boundary.
struct Side {
  Vec3 normal;          ///< at the segment's middle
  double bend = 1e300;  ///< turn of the normal per length, away from the segment, 1/mm
};

/// The sides of a face at all its boundary segments, by panel points.
std::map<std::pair<Index, Index>, Side> sides_of(const Facets& facets) {
  std::map<std::pair<Index, Index>, Side> sides;
  std::set<std::pair<Index, Index>> segments;
  for (const auto& loop : facets.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) segments.insert({loop[i], loop[(i + 1) % loop.size()]});
  for (Index t = 0; t < Index(facets.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k) {
      const Triangle& v = facets.triangles[t];
      const Index a = v[k], b = v[(k + 1) % 3], c = v[(k + 2) % 3];
      if (!segments.count({a, b})) continue;
      const Vec3 at_a = corner_normal(facets, t, k), at_b = corner_normal(facets, t, (k + 1) % 3),
                 at_c = corner_normal(facets, t, (k + 2) % 3), normal = normalized(at_a + at_b);
      const double away = distance(facets.points[c], (facets.points[a] + facets.points[b]) / 2);
      const double along = distance(facets.points[a], facets.points[b]);
      sides[std::minmax(facets.panel_points[a], facets.panel_points[b])] = {
          normal, std::max(angle_between(normal, at_c) / std::max(away, 1e-6),
                           angle_between(at_a, at_b) / std::max(along, 1e-6))};
    }
  return sides;
}

class SheetJoiner {
 public:
  SheetJoiner(const Panel& panel, const JoinedSheetOptions& options, const Context& context)
      : panel_(panel), options_(options), context_(context), group_(panel.faces.size()) {
    std::iota(group_.begin(), group_.end(), 0);
    for (const PanelFace& face : panel.faces) sides_.push_back(sides_of(face.facets));
  }

  std::vector<std::vector<Index>> run() {
    for (const PanelEdge& edge : panel_.edges)
      if (edge.faces.size() == 2 && edge.faces[0] != edge.faces[1] && is_plain(edge))
        join(edge.faces[0], edge.faces[1]);
    std::map<Index, std::vector<Index>> members;
    for (Index f = 0; f < Index(group_.size()); ++f) members[group_[f]].push_back(f);
    std::vector<std::vector<Index>> groups;
    for (auto& [first, faces] : members)
      if (faces.size() > 1 && !context_.is_cancelled() && lies_flat(faces))
        groups.push_back(std::move(faces));
    return groups;
  }

 private:
  bool is_plain(const PanelEdge& edge) const {
    for (std::size_t i = 1; i < edge.points.size(); ++i) {
      const auto segment = std::minmax(edge.points[i - 1], edge.points[i]);
      const auto a = sides_[edge.faces[0]].find(segment), b = sides_[edge.faces[1]].find(segment);
      if (a == sides_[edge.faces[0]].end() || b == sides_[edge.faces[1]].end()) return false;
      if (angle_between(a->second.normal, b->second.normal) > options_.feature_angle) return false;
      if (std::max(a->second.bend, b->second.bend) > 1 / options_.least_radius) return false;
    }
    return true;
  }

  void join(Index a, Index b) {
    const auto [kept, gone] = std::minmax(group_[a], group_[b]);
    if (kept != gone) std::replace(group_.begin(), group_.end(), Index(gone), Index(kept));
  }

  bool lies_flat(const std::vector<Index>& faces) const {
    const auto study = study_faces(panel_, faces);
    return study && (*study)->flat.distortion.max_stretch <= options_.max_stretch;
  }

  const Panel& panel_;
  JoinedSheetOptions options_;
  const Context& context_;
  std::vector<Index> group_;  ///< per face: the first of its group
  std::vector<std::map<std::pair<Index, Index>, Side>> sides_;
};

}  // namespace

std::vector<std::vector<Index>> joined_sheets(const Panel& panel, const JoinedSheetOptions& options,
                                              const Context& context) {
  return SheetJoiner(panel, options, context).run();
}

}  // namespace beadmesh
