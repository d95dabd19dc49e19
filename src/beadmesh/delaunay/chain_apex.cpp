#include "beadmesh/delaunay/chain_apex.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "beadmesh/geometry/predicates.h"

namespace beadmesh::delaunay {
namespace {

constexpr Index leaf_size = 8;
constexpr double slack = 4e-15;  // bound of the rounding of lengths in the frame / extent of the chain
constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

// The points see the base under angles; the one that sees it under the greatest is wanted. The cotangent of
// the angle is
// (|p - m|^2 - l^2 / 4) / (l h) with the base's middle m and length l and the height h of p over it. That
// gives bounds for boxes; the points themselves are compared exactly.
struct ChainApex::Search {
  Vec2 a, b;              // the base
  Vec2 frame_a, frame_b;  // and in the frame
  double tolerance;       // of lengths in the frame
  Index best = no_index;
  double best_cotangent = infinite;  // no less than that of the best point

  double length() const { return distance(frame_a, frame_b); }
  double height(Vec2 p) const { return cross(frame_b - frame_a, p - frame_a) / length(); }
  double least_cotangent(const Box& box) const;
  void offer(Index i, Vec2 p, Vec2 in_frame, Vec2 best_point);
};

double ChainApex::Search::least_cotangent(const Box& box) const {
  const double heights[] = {height(box.low), height({box.high.x, box.low.y}), height(box.high),
                            height({box.low.x, box.high.y})};
  const double highest = *std::max_element(heights, heights + 4) + tolerance;
  const double lowest = *std::min_element(heights, heights + 4) - tolerance;
  if (highest <= 0) return infinite;
  const Vec2 middle = (frame_a + frame_b) / 2;
  const double dx = std::max({box.low.x - middle.x, middle.x - box.high.x, 0.0});
  const double dy = std::max({box.low.y - middle.y, middle.y - box.high.y, 0.0});
  const double l = length(), away = std::hypot(dx, dy);
  const double above = away * away - l * l / 4 - tolerance * (l + away);
  if (above >= 0) return above / (l * highest);
  return lowest > 0 ? above / (l * lowest) : -infinite;
}

void ChainApex::Search::offer(Index i, Vec2 p, Vec2 in_frame, Vec2 best_point) {
  if (best != no_index && incircle(a, b, best_point, p) <= 0) return;
  if (orient2d(a, b, p) <= 0) return;
  best = i;
  const double l = length(), away = distance(in_frame, (frame_a + frame_b) / 2);
  const double above = away * away - l * l / 4 + tolerance * (l + away);
  const double h = height(in_frame) + (above >= 0 ? -tolerance : tolerance);
  best_cotangent = h > 0 ? above / (l * h) : infinite;
}

void ChainApex::reset(Vec2 a, Vec2 b, std::vector<Vec2> points) {
  points_ = std::move(points);
  origin_ = a;
  along_ = normalized(b - a);
  const auto size = static_cast<Index>(points_.size());
  for (leaves_ = 1; leaves_ * leaf_size < size;) leaves_ *= 2;
  boxes_.assign(2 * leaves_, {{infinite, infinite}, {-infinite, -infinite}});
  const auto grow = [](Box& box, Vec2 low, Vec2 high) {
    box.low = {std::min(box.low.x, low.x), std::min(box.low.y, low.y)};
    box.high = {std::max(box.high.x, high.x), std::max(box.high.y, high.y)};
  };
  extent_ = distance(a, b);
  for (Index i = 0; i < size; ++i) {
    const Vec2 p = in_frame(points_[i]);
    extent_ = std::max({extent_, std::abs(p.x), std::abs(p.y)});
    grow(boxes_[leaves_ + i / leaf_size], p, p);
  }
  for (Index i = leaves_ - 1; i > 0; --i)
    for (const Index child : {2 * i, 2 * i + 1}) grow(boxes_[i], boxes_[child].low, boxes_[child].high);
}

Index ChainApex::find(Vec2 a, Vec2 b, Index first, Index end) const {
  Search search{a, b, in_frame(a), in_frame(b), slack * extent_};
  const Index middle = first + (end - first) / 2;
  search.offer(middle, points_[middle], in_frame(points_[middle]), {});
  visit(search, first, end);
  return search.best;
}

void ChainApex::visit(Search& search, Index first, Index end) const {
  struct Waiting {
    Index box, begin, size;  // the points below the box
    double cotangent;
  };
  Waiting stack[64];
  int top = 0;
  stack[top++] = {1, 0, leaves_ * leaf_size, -infinite};
  while (top > 0) {
    const Waiting at = stack[--top];
    if (at.cotangent > search.best_cotangent) continue;
    if (at.box >= leaves_) {
      for (Index i = std::max(at.begin, first); i < std::min(at.begin + at.size, end); ++i)
        search.offer(i, points_[i], in_frame(points_[i]),
                     search.best == no_index ? Vec2{} : points_[search.best]);
      continue;
    }
    const Index half = at.size / 2;
    Waiting children[2] = {{2 * at.box, at.begin, half, 0}, {2 * at.box + 1, at.begin + half, half, 0}};
    for (Waiting& child : children) {
      const bool in_range = child.begin < end && child.begin + half > first;
      child.cotangent = in_range ? search.least_cotangent(boxes_[child.box]) : infinite;
    }
    if (children[0].cotangent < children[1].cotangent) std::swap(children[0], children[1]);
    for (const Waiting& child : children)
      if (child.cotangent < infinite) stack[top++] = child;
  }
}

}  // namespace beadmesh::delaunay
