#include "beadmesh/geometry/segment_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "beadmesh/geometry/polyline.h"

namespace beadmesh {
namespace {

constexpr Index leaf_size = 4;
constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

SegmentSearch::SegmentSearch(std::vector<std::array<Vec2, 2>> segments) : segments_(std::move(segments)) {
  while (leaves_ * leaf_size < size()) leaves_ *= 2;
  boxes_.assign(2 * leaves_, {{infinite, infinite}, {-infinite, -infinite}});
  const auto grow = [](Box& box, Vec2 low, Vec2 high) {
    box.low = {std::min(box.low.x, low.x), std::min(box.low.y, low.y)};
    box.high = {std::max(box.high.x, high.x), std::max(box.high.y, high.y)};
  };
  for (Index i = 0; i < size(); ++i)
    for (const Vec2 p : segments_[i]) grow(boxes_[leaves_ + i / leaf_size], p, p);
  for (Index i = leaves_ - 1; i > 0; --i)
    for (const Index child : {2 * i, 2 * i + 1}) grow(boxes_[i], boxes_[child].low, boxes_[child].high);
}

SegmentSearch SegmentSearch::of_loops(const std::vector<std::vector<Vec2>>& loops) {
  std::vector<std::array<Vec2, 2>> segments;
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) segments.push_back({loop[i], loop[(i + 1) % loop.size()]});
  return SegmentSearch(std::move(segments));
}

double SegmentSearch::squared_distance(const Box& box, Vec2 p) {
  const double dx = std::max({box.low.x - p.x, p.x - box.high.x, 0.0});
  const double dy = std::max({box.low.y - p.y, p.y - box.high.y, 0.0});
  return dx * dx + dy * dy;
}

NearestOnSegments SegmentSearch::nearest(Vec2 p) const {
  return nearest_within(p, infinite);
}

NearestOnSegments SegmentSearch::nearest_within(Vec2 p, double limit) const {
  NearestOnSegments best;
  double least = limit * limit;
  std::pair<Index, double> stack[64];
  int top = 0;
  stack[top++] = {1, squared_distance(boxes_[1], p)};
  while (top > 0) {
    const auto [box, box_distance] = stack[--top];
    if (!(box_distance <= least) || box_distance == infinite) continue;
    if (box < leaves_) {
      std::pair<Index, double> near{2 * box, squared_distance(boxes_[2 * box], p)};
      std::pair<Index, double> far{2 * box + 1, squared_distance(boxes_[2 * box + 1], p)};
      if (far.second < near.second) std::swap(near, far);
      stack[top++] = far;
      stack[top++] = near;
      continue;
    }
    const Index first = (box - leaves_) * leaf_size;
    for (Index i = first; i < std::min(first + leaf_size, size()); ++i) {
      const double t = nearest_parameter(segments_[i][0], segments_[i][1], p);
      const Vec2 q = lerp(segments_[i][0], segments_[i][1], t);
      const double d = squared_norm(q - p);
      if (d < least || (d == least && i < best.segment)) {
        least = d;
        best = {i, t, q, std::sqrt(d)};
      }
    }
  }
  return best;
}

}  // namespace beadmesh
