#include "beadmesh/mesh/mapped_area.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

constexpr double least_corner_sine = 0.35;  // of a mapped quad, before smoothing

bool visits_a_node_twice(NodeLoop loop) {
  std::sort(loop.begin(), loop.end());
  return std::adjacent_find(loop.begin(), loop.end()) != loop.end();
}

// Grid of the mapped area: side 0 has `columns` edges, side 1 `rows`.
class MappedArea {
 public:
  MappedArea(const MeshDraft& draft, const NodeLoop& loop, int first_corner, int columns, int rows)
      : draft_(draft), loop_(loop), first_(first_corner), columns_(columns), rows_(rows) {
    for (int j = 0; j <= rows_; ++j) {
      for (int i = 0; i <= columns_; ++i) points_.push_back(blended(i, j));
    }
  }

  bool is_sound() const {
    for (int j = 0; j < rows_; ++j) {
      for (int i = 0; i < columns_; ++i) {
        const Vec2 p[4] = {point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)};
        for (int k = 0; k < 4; ++k) {
          const Vec2 a = p[(k + 1) % 4] - p[k], b = p[(k + 3) % 4] - p[k];
          if (cross(a, b) <= least_corner_sine * norm(a) * norm(b)) return false;
        }
      }
    }
    return true;
  }

  // A grid of one row joins loop nodes directly: these edges must be new.
  bool repeats_edge() const {
    for (int i = 1; rows_ == 1 && i < columns_; ++i) {
      if (draft_.has_edge(loop_[loop_position(i, 0)], loop_[loop_position(i, 1)])) return true;
    }
    for (int j = 1; columns_ == 1 && j < rows_; ++j) {
      if (draft_.has_edge(loop_[loop_position(0, j)], loop_[loop_position(1, j)])) return true;
    }
    return false;
  }

  void add_to(MeshDraft& draft) const {
    std::vector<Index> nodes;
    for (int j = 0; j <= rows_; ++j) {
      for (int i = 0; i <= columns_; ++i) {
        const int position = loop_position(i, j);
        nodes.push_back(position >= 0 ? loop_[position] : draft.add_node(point(i, j)));
      }
    }
    const auto node = [&](int i, int j) { return nodes[static_cast<std::size_t>(j) * (columns_ + 1) + i]; };
    for (int j = 0; j < rows_; ++j) {
      for (int i = 0; i < columns_; ++i) {
        draft.add_element({node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
      }
    }
  }

 private:
  const Vec2& point(int i, int j) const { return points_[static_cast<std::size_t>(j) * (columns_ + 1) + i]; }

  // Position in the loop of a grid point on the border, -1 inside.
  int loop_position(int i, int j) const {
    int along = -1;
    if (j == 0) {
      along = i;
    } else if (i == columns_) {
      along = columns_ + j;
    } else if (j == rows_) {
      along = columns_ + rows_ + columns_ - i;
    } else if (i == 0) {
      along = 2 * columns_ + rows_ + rows_ - j;
    }
    return along < 0 ? -1 : (first_ + along) % static_cast<int>(loop_.size());
  }

  Vec2 border(int i, int j) const { return draft_.at(loop_[loop_position(i, j)]); }

  Vec2 blended(int i, int j) const {
    if (loop_position(i, j) >= 0) return border(i, j);
    const double u = static_cast<double>(i) / columns_, v = static_cast<double>(j) / rows_;
    const Vec2 across = lerp(border(i, 0), border(i, rows_), v),
               along = lerp(border(0, j), border(columns_, j), u);
    const Vec2 corners = lerp(lerp(border(0, 0), border(columns_, 0), u),
                              lerp(border(0, rows_), border(columns_, rows_), u), v);
    return across + along - corners;
  }

  const MeshDraft& draft_;
  const NodeLoop& loop_;
  int first_, columns_, rows_;
  std::vector<Vec2> points_;
};

}  // namespace

bool fill_by_mapping(MeshDraft& draft, const NodeLoop& loop, const std::vector<double>& angles) {
  std::vector<int> corners;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int quads = quads_in_angle(angles[i]);
    if (quads > 2 || (quads == 1 && corners.size() == 4)) return false;
    if (quads == 1) corners.push_back(static_cast<int>(i));
  }
  if (corners.size() != 4) return false;
  const int columns = corners[1] - corners[0], rows = corners[2] - corners[1];
  if (corners[3] - corners[2] != columns || 2 * (columns + rows) != static_cast<int>(loop.size()))
    return false;
  if (visits_a_node_twice(loop)) return false;
  const MappedArea area(draft, loop, corners[0], columns, rows);
  if (!area.is_sound() || area.repeats_edge()) return false;
  area.add_to(draft);
  return true;
}

}  // namespace beadmesh
