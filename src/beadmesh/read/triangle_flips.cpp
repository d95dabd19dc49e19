#include "beadmesh/read/triangle_flips.h"

#include <algorithm>
#include <cstddef>

#include "beadmesh/geometry/predicates.h"

namespace beadmesh {
namespace {

class Flipper {
 public:
  Flipper(const std::vector<Vec2>& plane, const std::vector<Vec3>& space, std::vector<Triangle>& triangles,
          std::vector<std::array<Index, 3>>& neighbours)
      : plane_(plane), space_(space), triangles_(triangles), neighbours_(neighbours) {}

  void run() {
    for (Index t = 0; t < static_cast<Index>(triangles_.size()); ++t) stack_.push_back(t);
    std::reverse(stack_.begin(), stack_.end());
    // In space the flips need not come to an end by themselves, as they do in the plane.
    std::size_t left = 4 * triangles_.size();
    while (!stack_.empty() && left > 0) {
      const Index t = stack_.back();
      stack_.pop_back();
      for (int k = 0; k < 3; ++k)
        if (wants_flip(t, k)) {
          flip(t, k);
          --left;
          break;
        }
    }
  }

 private:
  static int slot_of(const std::array<Index, 3>& row, Index value) {
    return row[0] == value ? 0 : row[1] == value ? 1 : 2;
  }

  double angle_at(Index a, Index b, Index c) const {
    return angle_between(space_[b] - space_[a], space_[c] - space_[a]);
  }

  bool wants_flip(Index t, int k) const {
    const Index other = neighbours_[t][k];
    if (other == no_index) return false;
    const Index a = triangles_[t][k], b = triangles_[t][(k + 1) % 3], c = triangles_[t][(k + 2) % 3];
    const Index d = triangles_[other][slot_of(neighbours_[other], t)];
    if (angle_at(a, b, c) + angle_at(d, c, b) <= pi + 1e-6) return false;
    return orient2d(plane_[a], plane_[b], plane_[d]) > 0 && orient2d(plane_[d], plane_[c], plane_[a]) > 0;
  }

  /// Triangles (a, b, c) and (d, c, b) become (a, b, d) and (d, c, a).
  void flip(Index t, int k) {
    const Index o = neighbours_[t][k];
    const int j = slot_of(neighbours_[o], t);
    const Index a = triangles_[t][k], b = triangles_[t][(k + 1) % 3], c = triangles_[t][(k + 2) % 3];
    const Index d = triangles_[o][j];
    const Index beyond_ca = neighbours_[t][(k + 1) % 3], beyond_ab = neighbours_[t][(k + 2) % 3];
    const Index beyond_bd = neighbours_[o][(j + 1) % 3], beyond_dc = neighbours_[o][(j + 2) % 3];
    triangles_[t] = {a, b, d};
    neighbours_[t] = {beyond_bd, o, beyond_ab};
    triangles_[o] = {d, c, a};
    neighbours_[o] = {beyond_ca, t, beyond_dc};
    if (beyond_bd != no_index) neighbours_[beyond_bd][slot_of(neighbours_[beyond_bd], o)] = t;
    if (beyond_ca != no_index) neighbours_[beyond_ca][slot_of(neighbours_[beyond_ca], t)] = o;
    for (const Index touched : {t, o, beyond_ab, beyond_bd, beyond_ca, beyond_dc})
      if (touched != no_index) stack_.push_back(touched);
  }

  const std::vector<Vec2>& plane_;
  const std::vector<Vec3>& space_;
  std::vector<Triangle>& triangles_;
  std::vector<std::array<Index, 3>>& neighbours_;
  std::vector<Index> stack_;
};

}  // namespace

void flip_towards_delaunay(const std::vector<Vec2>& plane, const std::vector<Vec3>& space,
                           std::vector<Triangle>& triangles, std::vector<std::array<Index, 3>>& neighbours) {
  Flipper(plane, space, triangles, neighbours).run();
}

}  // namespace beadmesh
