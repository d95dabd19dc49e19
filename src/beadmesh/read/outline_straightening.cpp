#include "beadmesh/read/outline_straightening.h"

#include <algorithm>
#include <map>
#include <utility>

#include "beadmesh/read/outline_cutting.h"

namespace beadmesh {
namespace {

/// Facets of uncertain side.
class ToothRemover {
 public:
  ToothRemover(const FacetMesh& mesh, FacetGroups& groups, const OutlineOptions& options)
      : mesh_(mesh), groups_(groups), options_(options), normals_(mesh.points.size()) {
    for (Index t = 0; t < mesh.triangle_count(); ++t)
      if (!is_feature(t))
        for (const Index v : mesh.triangles[t]) normals_[v] += mesh.area_vectors[t];
    for (Vec3& n : normals_) n = normalized(n);
  }

  void run() {
    std::vector<Index> waiting;
    for (Index t = 0; t < mesh_.triangle_count(); ++t) waiting.push_back(t);
    for (int pass = 0; pass < 20 && !waiting.empty(); ++pass) {
      std::vector<Index> next;
      for (const Index t : waiting)
        if (turn_over(t))
          for (Index h = 3 * t; h < 3 * t + 3; ++h)
            if (mesh_.beyond(h) != no_index) next.push_back(mesh_.beyond(h));
      std::sort(next.begin(), next.end());
      next.erase(std::unique(next.begin(), next.end()), next.end());
      waiting = std::move(next);
    }
  }

 private:
  bool is_feature(Index t) const { return groups_.is_feature[groups_.face[t]]; }

  bool turn_over(Index t) {
    std::map<Index, double> length;  // per face beyond the sides
    double inner = 0;
    for (Index h = 3 * t; h < 3 * t + 3; ++h) {
      const Index other = mesh_.beyond(h);
      if (other == no_index) return false;
      if (groups_.face[other] == groups_.face[t])
        inner += mesh_.length(h);
      else if (is_feature(other) != is_feature(t))
        length[groups_.face[other]] += mesh_.length(h);
    }
    for (const auto& [face, outer] : length)
      if (outer > options_.tooth * inner && may_turn(t)) {
        groups_.face[t] = face;
        return true;
      }
    return false;
  }

  bool may_turn(Index t) const {
    double highest = 0, longest = 0;
    for (const Index v : mesh_.triangles[t])
      for (const Index w : mesh_.triangles[t]) {
        const Vec3 way = mesh_.points[w] - mesh_.points[v];
        // in the mean of both ends a bent sheet is level
        const Vec3 normal = normals_[w] == Vec3{} ? normals_[v] : (normals_[v] + normals_[w]) / 2;
        highest = std::max(highest, std::abs(dot(way, normal)));
        longest = std::max(longest, norm(way));
      }
    if (is_feature(t)) return highest < options_.flat;
    return 2 * mesh_.area(t) < options_.sliver * longest * longest;
  }

  const FacetMesh& mesh_;
  FacetGroups& groups_;
  const OutlineOptions& options_;
  std::vector<Vec3> normals_;  ///< per point: of the sheet alone; zero inside features
};

/// Some faces were nothing but teeth.
void drop_empty(FacetGroups& groups) {
  FacetGroups kept;
  std::map<Index, Index> number;
  for (Index& f : groups.face) {
    const auto [found, is_new] = number.try_emplace(f, Index(number.size()));
    if (is_new) kept.is_feature.push_back(groups.is_feature[f]);
    kept.face.push_back(found->second);
  }
  groups = std::move(kept);
}

}  // namespace

void straighten_outlines(FacetMesh& mesh, FacetGroups& groups, const OutlineOptions& options) {
  ToothRemover(mesh, groups, options).run();
  drop_empty(groups);
  cut_along_outlines(mesh, groups);
}

}  // namespace beadmesh
