#include "beadmesh/read/facet_grouping.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "beadmesh/read/feature_parting.h"
#include "beadmesh/read/part_lines.h"
#include "beadmesh/read/sheet_band.h"

namespace beadmesh {
namespace {

using Triangles = std::vector<Index>;

class FacetGrouper {
 public:
  FacetGrouper(const FacetMesh& mesh, const std::vector<Index>& patch, const FacetGroupingOptions& options)
      : mesh_(mesh), patch_(patch), options_(options), face_(mesh.triangles.size(), no_index) {
    for (Index t = 0; t < mesh.triangle_count(); ++t)
      if (patch[t] != no_index) {
        if (patch[t] >= Index(members_.size())) members_.resize(patch[t] + 1);
        members_[patch[t]].push_back(t);
      }
    coarse_ = is_coarse(mesh);
  }

  FacetGroups run() {
    for (const Index p : patches_by_area())
      for (host_queue_.push_back(p); !host_queue_.empty();) {
        const Index host = host_queue_.front();
        host_queue_.erase(host_queue_.begin());
        if (face_[members_[host].front()] == no_index) search_around(host);
      }
    fill_rest();
    split_by_parts(mesh_, is_feature_, face_);
    return renumbered();
  }

 private:
  std::vector<Index> patches_by_area() const {
    std::vector<double> areas(members_.size(), 0);
    std::vector<Index> order;
    for (size_t p = 0; p < members_.size(); ++p) {
      for (const Index t : members_[p]) areas[p] += mesh_.area(t);
      order.push_back(Index(p));
    }
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return areas[a] > areas[b]; });
    return order;
  }

  bool is_joined(Index h) const { return mesh_.partner[h] != no_index; }

  bool is_sharp(Index h) const {
    return mesh_.turn(h) > (coarse_ ? options_.coarse_angle : options_.feature_angle);
  }

  Index new_face(bool is_feature) {
    is_feature_.push_back(is_feature);
    return Index(is_feature_.size()) - 1;
  }

  void assign(const Triangles& triangles, Index face) {
    for (const Index t : triangles) face_[t] = face;
  }

  void search_around(Index host) {
    const Index sheet = new_face(false);
    assign(members_[host], sheet);
    std::vector<bool> seen(mesh_.triangles.size(), false);
    for (const Index t : members_[host])
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
        if (is_joined(h) && face_[mesh_.partner[h] / 3] == no_index && !seen[mesh_.partner[h] / 3])
          settle(sheet,
                 flooded(mesh_.partner[h] / 3, seen, [&](Index next) { return face_[next] == no_index; }));
  }

  template <class Passes>
  Triangles flooded(Index seed, std::vector<bool>& seen, Passes passes) const {
    Triangles found{seed};
    seen[seed] = true;
    for (size_t i = 0; i < found.size(); ++i)
      for (Index h = 3 * found[i]; h < 3 * found[i] + 3; ++h) {
        const Index next = mesh_.beyond(h);
        if (next == no_index || seen[next] || !is_joined(h) || !passes(next)) continue;
        seen[next] = true;
        found.push_back(next);
      }
    return found;
  }

  /// Decides over what lies connected beside a sheet.
  void settle(Index sheet, const Triangles& blob) {
    const auto continued = sheet_beside(mesh_, face_, sheet, blob);
    if (!continued) return;
    std::map<Index, double> height;  // per triangle of the blob
    double highest = 0;
    for (const Index t : blob) {
      const double h = continued->height(mesh_.centre(t));
      height[t] = h;
      highest = std::max(highest, std::abs(h));
    }
    if (highest < options_.min_height) return assign(blob, sheet);
    if (!is_enclosed(sheet, blob) || has_sharp_edges(sheet, blob)) return;
    Triangles rest = without_level_patches(sheet, blob, *continued, highest);
    std::vector<bool> seen(mesh_.triangles.size(), false), in_rest(mesh_.triangles.size(), false);
    for (const Index t : rest) in_rest[t] = true;
    for (const Index t : rest) {
      if (seen[t]) continue;
      Triangles feature = flooded(t, seen, [&](Index next) { return in_rest[next]; });
      if (!touches(feature, sheet)) continue;  // inside an island, which is a host of its own
      std::sort(feature.begin(), feature.end());
      std::vector<double> heights;
      for (const Index f : feature) heights.push_back(height[f]);
      for (const Triangles& part :
           parted_features(mesh_, feature, heights, options_.saddle, options_.min_height))
        assign(part, new_face(true));
    }
  }

  bool touches(const Triangles& triangles, Index face) const {
    for (const Index t : triangles)
      for (Index h = 3 * t; h < 3 * t + 3; ++h)
        if (mesh_.beyond(h) != no_index && face_[mesh_.beyond(h)] == face) return true;
    return false;
  }

  /// Touches no other sheet, and no border of its own meets the sheet: its rim is the sheet's all around.
  bool is_enclosed(Index sheet, const Triangles& blob) const {
    std::map<Index, int> at_point;  // 1: beside the sheet, 2: on a border
    for (const Index t : blob)
      for (Index h = 3 * t; h < 3 * t + 3; ++h) {
        const Index other = is_joined(h) ? face_[mesh_.partner[h] / 3] : no_index;
        if (is_joined(h) && other == no_index) continue;
        if (is_joined(h) && other != sheet) return false;
        for (const Index v : {mesh_.tail(h), mesh_.head(h)})
          if ((at_point[v] |= is_joined(h) ? 1 : 2) == 3) return false;
      }
    return true;
  }

  /// Sharp edges as long as a quarter of its rim: a single one among facets is noise. The crest of a narrow
  /// bead of two coarse elements is as sharp as its walls are steep; there only the rim tells.
  bool has_sharp_edges(Index sheet, const Triangles& blob) const {
    double sharp = 0, rim = 0;
    for (const Index t : blob)
      for (Index h = 3 * t; h < 3 * t + 3; ++h) {
        if (!is_joined(h)) continue;
        const bool on_rim = face_[mesh_.beyond(h)] == sheet;
        if (on_rim) rim += mesh_.length(h);
        if (is_sharp(h) && (on_rim || !coarse_))
          sharp += on_rim ? mesh_.length(h) : mesh_.length(h) / 2;  // inner ones come twice
      }
    return sharp > 0.25 * rim;
  }

  Triangles without_level_patches(Index sheet, const Triangles& blob, const QuadraticSheet& continued,
                                  double highest) {
    std::map<Index, bool> level;
    for (const Index t : blob)
      if (const Index p = patch_[t]; p != no_index && !level.contains(p))
        level[p] = is_level(p, continued, highest);
    Triangles rest;
    for (const Index t : blob)
      if (patch_[t] == no_index || !level[patch_[t]]) rest.push_back(t);
    for (const auto& [p, is] : level) {
      if (!is) continue;
      if (touches(members_[p], sheet))
        assign(members_[p], sheet);
      else
        host_queue_.push_back(p);
    }
    return rest;
  }

  /// As high as the continued sheet, and leaning as much.
  bool is_level(Index p, const QuadraticSheet& continued, double highest) const {
    double area = 0, height = 0, lean = 0;
    for (const Index t : members_[p]) {
      const double a = mesh_.area(t);
      area += a;
      height += a * std::abs(continued.height(mesh_.centre(t)));
      if (a > 0) lean += a * angle_between(continued.normal(mesh_.centre(t)), mesh_.area_vectors[t]);
    }
    return lean < options_.level_angle * area &&
           height < std::min(options_.level_height * highest, options_.most_level_height) * area;
  }

  /// What belongs to no sheet and no feature: smooth pieces.
  void fill_rest() {
    for (Index seed = 0; seed < mesh_.triangle_count(); ++seed) {
      if (face_[seed] != no_index) continue;
      const Index face = new_face(false);
      face_[seed] = face;
      Triangles found{seed};
      for (size_t i = 0; i < found.size(); ++i)
        for (Index h = 3 * found[i]; h < 3 * found[i] + 3; ++h) {
          if (!is_joined(h) || face_[mesh_.partner[h] / 3] != no_index ||
              mesh_.turn(h) > options_.feature_angle)
            continue;
          face_[mesh_.partner[h] / 3] = face;
          found.push_back(mesh_.partner[h] / 3);
        }
    }
  }

  FacetGroups renumbered() const {
    FacetGroups groups;
    std::map<Index, Index> number;
    for (const Index f : face_) {
      const auto [found, is_new] = number.try_emplace(f, Index(number.size()));
      if (is_new) groups.is_feature.push_back(f < Index(is_feature_.size()) && is_feature_[f]);
      groups.face.push_back(found->second);
    }
    return groups;
  }

  const FacetMesh& mesh_;
  const std::vector<Index>& patch_;
  const FacetGroupingOptions& options_;
  std::vector<Triangles> members_;  ///< per patch
  std::vector<Index> face_;         ///< per triangle
  std::vector<bool> is_feature_;    ///< per face
  std::vector<Index> host_queue_;   ///< patches that are sheet and whose surroundings are to be searched
  bool coarse_ = false;
};

}  // namespace

FacetGroups group_facets(const FacetMesh& mesh, const std::vector<Index>& patch,
                         const FacetGroupingOptions& options) {
  return FacetGrouper(mesh, patch, options).run();
}

}  // namespace beadmesh
