#include "beadmesh/bead/joined_sheets.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <numeric>

#include "beadmesh/bead/face_study.h"
#include "beadmesh/panel/edge_shape.h"

namespace beadmesh {
namespace {

class SheetJoiner {
 public:
  SheetJoiner(const Panel& panel, const JoinedSheetOptions& options, const Context& context)
      : panel_(panel), options_(options), context_(context), group_(panel.faces.size()) {
    std::iota(group_.begin(), group_.end(), 0);
  }

  std::vector<std::vector<Index>> run() {
    const std::vector<EdgeShape> shapes = edge_shapes(panel_);
    for (size_t e = 0; e < shapes.size(); ++e) {
      const std::vector<Index>& faces = panel_.edges[e].faces;
      if (faces.size() == 2 && is_plain(shapes[e]) && !is_kept(Index(e)) && !part_at_kept(faces[0], faces[1]))
        join(faces[0], faces[1]);
    }
    std::map<Index, std::vector<Index>> members;
    for (Index f = 0; f < Index(group_.size()); ++f) members[group_[f]].push_back(f);
    std::vector<std::vector<Index>> groups;
    for (auto& [first, faces] : members)
      if (faces.size() > 1) groups.push_back(std::move(faces));
    tbb::parallel_for(size_t(0), groups.size(), [&](size_t g) {
      if (context_.is_cancelled() || !lies_flat(groups[g])) groups[g].clear();
    });
    groups.erase(std::remove_if(groups.begin(), groups.end(), [](const auto& g) { return g.empty(); }),
                 groups.end());
    return groups;
  }

 private:
  bool is_plain(const EdgeShape& edge) const {
    return edge.turn <= options_.feature_angle && edge.bend <= 1 / options_.least_radius;
  }

  bool is_kept(Index edge) const {
    const auto& kept = options_.kept_edges;
    return std::find(kept.begin(), kept.end(), edge) != kept.end();
  }

  /// Would the two faces of a kept edge come into one group over other edges?
  bool part_at_kept(Index a, Index b) const {
    for (const Index e : options_.kept_edges) {
      const std::vector<Index>& faces = panel_.edges[e].faces;
      if (faces.size() != 2) continue;
      const Index left = group_[faces[0]], right = group_[faces[1]];
      if ((left == group_[a] && right == group_[b]) || (left == group_[b] && right == group_[a])) return true;
    }
    return false;
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
};

}  // namespace

std::vector<Index> edges_at(const Panel& panel, const std::vector<Vec3>& points, double reach,
                            std::vector<Vec3>& missed) {
  std::vector<Index> found;
  for (const Vec3 p : points) {
    double nearest = reach;
    Index best = no_index;
    bool is_inner = false;  // edges of the rim stay anyhow
    for (Index e = 0; e < Index(panel.edges.size()); ++e) {
      const auto& line = panel.edges[e].points;
      const bool inner = panel.edges[e].faces.size() == 2;
      if (is_inner && !inner) continue;
      for (size_t i = 1; i < line.size(); ++i) {
        const Vec3 a = panel.points[line[i - 1]], side = panel.points[line[i]] - a;
        const double t = std::clamp(dot(p - a, side) / std::max(squared_norm(side), 1e-300), 0.0, 1.0);
        const double away = distance(p, a + side * t);
        if (away < nearest || (away < reach && inner && !is_inner))
          nearest = away, best = e, is_inner = inner;
      }
    }
    if (best == no_index)
      missed.push_back(p);
    else
      found.push_back(best);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<std::vector<Index>> joined_sheets(const Panel& panel, const JoinedSheetOptions& options,
                                              const Context& context) {
  return SheetJoiner(panel, options, context).run();
}

}  // namespace beadmesh
