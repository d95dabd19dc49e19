#include "beadmesh/mesh/patch_fill.h"

#include <algorithm>

namespace beadmesh {
namespace {

struct FillNode {
  Index index = no_index;
  Vec2 position;
};
using Line = std::vector<FillNode>;

class PatchFiller {
 public:
  PatchFiller(const std::vector<Index>& loop, const std::vector<Vec2>& positions,
              const std::vector<int>& corners, Index first_new)
      : loop_(loop), positions_(positions), corners_(corners), next_(first_new) {}

  PatchFill run() {
    const int count = static_cast<int>(corners_.size());
    std::vector<int> sides;
    for (int i = 0; i < count; ++i) sides.push_back(side_length(i));
    if (count == 4)
      block(along(corners_[0], sides[0], 1), along(corners_[0], sides[3], -1),
            along(corners_[3], sides[2], -1), along(corners_[1], sides[1], 1));
    else
      fill_star(*patch_divisions(sides), sides);
    return std::move(fill_);
  }

 private:
  int side_length(int side) const {
    const int from = corners_[side], to = corners_[(side + 1) % corners_.size()];
    return to > from ? to - from : to - from + static_cast<int>(loop_.size());
  }

  Line along(int start, int steps, int direction) const {
    const int size = static_cast<int>(loop_.size());
    Line line;
    for (int i = 0; i <= steps; ++i) {
      const int at = ((start + direction * i) % size + size) % size;
      line.push_back({loop_[at], positions_[at]});
    }
    return line;
  }

  FillNode fresh(Vec2 position) {
    fill_.new_nodes.push_back(position);
    return {next_++, position};
  }

  /// A line with new nodes inside, from one node to another.
  Line spoke(const FillNode& from, const FillNode& to, int steps) {
    Line line = {from};
    for (int i = 1; i < steps; ++i)
      line.push_back(fresh(lerp(from.position, to.position, double(i) / steps)));
    line.push_back(to);
    return line;
  }

  /// One block at every corner; all meet in the centre.
  void fill_star(const std::vector<int>& ends, const std::vector<int>& sides) {
    const int count = static_cast<int>(corners_.size());
    std::vector<int> splits;
    Vec2 sum;
    for (int i = 0; i < count; ++i) {
      splits.push_back((corners_[i] + sides[i] - ends[i]) % static_cast<int>(loop_.size()));
      sum += positions_[splits[i]];
    }
    const FillNode centre = fresh(sum / count);
    std::vector<Line> spokes;
    for (int i = 0; i < count; ++i)
      spokes.push_back(
          spoke({loop_[splits[i]], positions_[splits[i]]}, centre, ends[(i + count - 1) % count]));
    for (int i = 0; i < count; ++i) {
      const int next = (i + 1) % count, start = sides[next] - ends[next];
      block(along(corners_[next], start, 1), along(corners_[next], ends[i], -1), spokes[i], spokes[next]);
    }
  }

  /// Grid between bottom (u) and left (v), which start at the same corner, and the lines opposite to them.
  void block(const Line& bottom, const Line& left, const Line& top, const Line& right) {
    const size_t m = bottom.size() - 1, n = left.size() - 1;
    std::vector<Line> rows = {bottom};
    for (size_t j = 1; j < n; ++j) {
      Line row = {left[j]};
      for (size_t i = 1; i < m; ++i) {
        const double u = double(i) / double(m), v = double(j) / double(n);
        const Vec2 ruled =
            lerp(bottom[i].position, top[i].position, v) + lerp(left[j].position, right[j].position, u);
        const Vec2 corners = lerp(lerp(bottom[0].position, bottom[m].position, u),
                                  lerp(top[0].position, top[m].position, u), v);
        row.push_back(fresh(ruled - corners));
      }
      row.push_back(right[j]);
      rows.push_back(std::move(row));
    }
    rows.push_back(top);
    for (size_t j = 0; j < n; ++j)
      for (size_t i = 0; i < m; ++i)
        fill_.quads.push_back(
            {rows[j][i].index, rows[j][i + 1].index, rows[j + 1][i + 1].index, rows[j + 1][i].index});
  }

  const std::vector<Index>& loop_;
  const std::vector<Vec2>& positions_;
  const std::vector<int>& corners_;
  Index next_;
  PatchFill fill_;
};

}  // namespace

std::optional<std::vector<int>> patch_divisions(std::span<const int> sides) {
  const int count = static_cast<int>(sides.size());
  if (count == 4) {
    if (sides[0] != sides[2] || sides[1] != sides[3]) return std::nullopt;
    return std::vector<int>{};
  }
  if (count != 3 && count != 5) return std::nullopt;
  int twice = 0;
  for (int k = 0; k < count; ++k) twice += (k % 2 == 0 ? 1 : -1) * sides[2 * (k + 1) % count];
  if (twice <= 0 || twice % 2 != 0) return std::nullopt;
  std::vector<int> ends(count);
  ends[0] = twice / 2;
  for (int k = 1, i = 0; k < count; ++k) {
    const int next = (i + 2) % count;
    ends[next] = sides[next] - ends[i];
    if (ends[next] <= 0) return std::nullopt;
    i = next;
  }
  return ends;
}

PatchFill fill_patch(const std::vector<Index>& loop, const std::vector<Vec2>& positions,
                     const std::vector<int>& corners, Index first_new) {
  return PatchFiller(loop, positions, corners, first_new).run();
}

}  // namespace beadmesh
