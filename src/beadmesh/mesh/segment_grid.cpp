#include "beadmesh/mesh/segment_grid.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

bool boxes_meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  return std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
         std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
}

}  // namespace

bool segments_meet(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  if (!boxes_meet(a, b, c, d)) return false;
  const double c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
  if ((c_side > 0 && d_side > 0) || (c_side < 0 && d_side < 0)) return false;
  const double a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
  return !((a_side > 0 && b_side > 0) || (a_side < 0 && b_side < 0));
}

double distance_to_segment(Vec2 point, Vec2 a, Vec2 b) {
  const Vec2 d = b - a;
  const double square = squared_norm(d);
  const double t = square > 0 ? std::clamp(dot(point - a, d) / square, 0.0, 1.0) : 0;
  return distance(point, lerp(a, b, t));
}

SegmentGrid::SegmentGrid(const std::vector<Vec2>& nodes, std::vector<std::array<Index, 2>> edges,
                         double reach)
    : nodes_(nodes), edges_(std::move(edges)), reach_(reach) {
  low_ = {1e300, 1e300};
  Vec2 high{-1e300, -1e300};
  double total = 0;
  for (const auto& [a, b] : edges_) {
    low_ = {std::min(low_.x, nodes_[a].x), std::min(low_.y, nodes_[a].y)};
    high = {std::max(high.x, nodes_[a].x), std::max(high.y, nodes_[a].y)};
    total += distance(nodes_[a], nodes_[b]);
  }
  if (edges_.empty()) low_ = high = {0, 0};
  low_ = low_ - Vec2{reach_, reach_};
  high = high + Vec2{reach_, reach_};
  const Vec2 extent = high - low_;
  // About as many cells as edges, none smaller than an edge with its reach.
  cell_ = std::max({total / std::max<std::size_t>(edges_.size(), 1) + reach_,
                    std::sqrt(extent.x * extent.y / std::max<std::size_t>(2 * edges_.size(), 1)), 1e-12});
  columns_ = static_cast<int>(extent.x / cell_) + 1;
  rows_ = static_cast<int>(extent.y / cell_) + 1;
  start_.assign(static_cast<std::size_t>(columns_) * rows_ + 1, 0);
  const auto for_cells_of_edge = [&](const std::array<Index, 2>& edge, auto visit) {
    const Vec2 a = nodes_[edge[0]], b = nodes_[edge[1]];
    for_cells_of_box({std::min(a.x, b.x) - reach_, std::min(a.y, b.y) - reach_},
                     {std::max(a.x, b.x) + reach_, std::max(a.y, b.y) + reach_}, visit);
  };
  for (const auto& edge : edges_) for_cells_of_edge(edge, [&](std::size_t cell) { ++start_[cell + 1]; });
  for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
  entries_.resize(start_.back());
  std::vector<Index> next(start_.begin(), start_.end() - 1);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    for_cells_of_edge(edges_[e], [&](std::size_t cell) { entries_[next[cell]++] = static_cast<Index>(e); });
  }
}

std::array<int, 2> SegmentGrid::cell_of(Vec2 point) const {
  return {std::clamp(static_cast<int>((point.x - low_.x) / cell_), 0, columns_ - 1),
          std::clamp(static_cast<int>((point.y - low_.y) / cell_), 0, rows_ - 1)};
}

template <class Visit>
void SegmentGrid::for_cells_of_box(Vec2 low, Vec2 high, Visit visit) const {
  const auto [i0, j0] = cell_of(low);
  const auto [i1, j1] = cell_of(high);
  for (int j = j0; j <= j1; ++j) {
    for (int i = i0; i <= i1; ++i) visit(slot(i, j));
  }
}

double SegmentGrid::clearance(Index a, Index b) const {
  const Vec2 p = nodes_[a], q = nodes_[b];
  double nearest = reach_;
  const auto judge = [&](std::size_t cell) {
    for (Index k = start_[cell]; k < start_[cell + 1]; ++k) {
      const auto [c, d] = edges_[entries_[k]];
      const bool shared = c == a || c == b || d == a || d == b;
      if (!shared && segments_meet(p, q, nodes_[c], nodes_[d])) return false;
      if (c != a && c != b) nearest = std::min(nearest, distance_to_segment(nodes_[c], p, q));
    }
    return true;
  };
  // Column by column, only the cells that the line passes: edges are entered with their reach around them.
  const auto [i0, j0] = cell_of(p.x <= q.x ? p : q);
  const auto [i1, j1] = cell_of(p.x <= q.x ? q : p);
  const double slope = q.x != p.x ? (q.y - p.y) / (q.x - p.x) : 0;
  for (int i = i0; i <= i1; ++i) {
    double y0 = p.y, y1 = q.y;
    if (q.x != p.x) {
      const double left = std::clamp(low_.x + i * cell_, std::min(p.x, q.x), std::max(p.x, q.x));
      const double right = std::clamp(low_.x + (i + 1) * cell_, std::min(p.x, q.x), std::max(p.x, q.x));
      y0 = p.y + slope * (left - p.x), y1 = p.y + slope * (right - p.x);
    }
    const int from = cell_of({p.x, std::min(y0, y1) - 1e-9 * cell_})[1];
    const int to = cell_of({p.x, std::max(y0, y1) + 1e-9 * cell_})[1];
    for (int j = from; j <= to; ++j) {
      if (!judge(slot(i, j))) return -1;
    }
  }
  return nearest;
}

std::array<Index, 2> SegmentGrid::first_crossing() const {
  for (std::size_t cell = 0; cell + 1 < start_.size(); ++cell) {
    for (Index k = start_[cell]; k < start_[cell + 1]; ++k) {
      for (Index l = start_[cell]; l < k; ++l) {
        const auto &e = edges_[entries_[k]], &f = edges_[entries_[l]];
        if (e[0] == f[0] || e[0] == f[1] || e[1] == f[0] || e[1] == f[1]) continue;
        if (segments_meet(nodes_[e[0]], nodes_[e[1]], nodes_[f[0]], nodes_[f[1]])) {
          return {entries_[l], entries_[k]};
        }
      }
    }
  }
  return {no_index, no_index};
}

}  // namespace beadmesh
