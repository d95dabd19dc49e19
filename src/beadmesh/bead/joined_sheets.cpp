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
      if (faces.size() == 2 && is_plain(shapes[e])) join(faces[0], faces[1]);
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

std::vector<std::vector<Index>> joined_sheets(const Panel& panel, const JoinedSheetOptions& options,
                                              const Context& context) {
  return SheetJoiner(panel, options, context).run();
}

}  // namespace beadmesh
