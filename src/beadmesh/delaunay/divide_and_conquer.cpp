#include "beadmesh/delaunay/divide_and_conquer.h"

#include <algorithm>
#include <array>
#include <bit>

#include "beadmesh/geometry/predicates.h"

namespace beadmesh::delaunay {
namespace {

struct Keyed {
  std::uint64_t key;
  Index point;
};

// Puts a 0 before every bit.
std::uint64_t spread(std::uint32_t bits) {
  std::uint64_t v = bits;
  v = (v | v << 16) & 0x0000ffff0000ffffULL;
  v = (v | v << 8) & 0x00ff00ff00ff00ffULL;
  v = (v | v << 4) & 0x0f0f0f0f0f0f0f0fULL;
  v = (v | v << 2) & 0x3333333333333333ULL;
  return (v | v << 1) & 0x5555555555555555ULL;
}

// Interleaves the bits of both coordinates: a monotone function of each of them, so that a bit of the key
// cuts the points by a line parallel to an axis. Odd bits are x.
class MortonKey {
 public:
  explicit MortonKey(const std::vector<Vec2>& points) {
    if (points.empty()) return;
    Vec2 high = low_ = points.front();
    for (const Vec2 p : points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double extent = std::max(high.x - low_.x, high.y - low_.y);
    if (extent > 0) scale_ = std::min(4294967295.0 / extent, 0x1p1000);
  }
  std::uint64_t operator()(Vec2 p) const {
    return spread(cell(p.x - low_.x)) << 1 | spread(cell(p.y - low_.y));
  }

 private:
  std::uint32_t cell(double offset) const {
    return static_cast<std::uint32_t>(std::min(offset * scale_, 4294967295.0));
  }
  Vec2 low_;
  double scale_ = 0;
};

// Radix sort by 11 bits at a time; a digit that all keys share costs nothing.
void sort_by_key(std::vector<Keyed>& items) {
  constexpr int bits = 11, passes = 6, buckets = 1 << bits;
  if (items.size() < 256) {
    std::sort(items.begin(), items.end(), [](const Keyed& a, const Keyed& b) {
      return a.key != b.key ? a.key < b.key : a.point < b.point;
    });
    return;
  }
  std::vector<std::array<Index, buckets>> count(passes);
  for (const Keyed& item : items)
    for (int pass = 0; pass < passes; ++pass) ++count[pass][item.key >> (pass * bits) & (buckets - 1)];
  std::vector<Keyed> sorted(items.size());
  for (int pass = 0; pass < passes; ++pass) {
    const int shift = pass * bits;
    auto& start = count[pass];
    if (start[items.front().key >> shift & (buckets - 1)] == static_cast<Index>(items.size())) continue;
    Index sum = 0;
    for (Index& c : start) sum += std::exchange(c, sum);
    for (const Keyed& item : items) sorted[start[item.key >> shift & (buckets - 1)]++] = item;
    items.swap(sorted);
  }
}

bool lexicographic(Vec2 a, Vec2 b) {
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

// Points with the same key are put in lexicographic order; equal points meet there.
void order_runs(std::vector<Keyed>& items, const std::vector<Vec2>& points, PointOrder& order) {
  for (std::size_t first = 0; first < items.size();) {
    std::size_t end = first + 1;
    while (end < items.size() && items[end].key == items[first].key) ++end;
    if (end - first > 1) {
      std::sort(items.begin() + first, items.begin() + end, [&](const Keyed& a, const Keyed& b) {
        const Vec2 p = points[a.point], q = points[b.point];
        return p == q ? a.point < b.point : lexicographic(p, q);
      });
      for (std::size_t i = first + 1; i < end; ++i)
        if (points[items[i].point] == points[items[i - 1].point])
          order.duplicates.emplace_back(items[i - 1].point, items[i].point);
    }
    first = end;
  }
}

// Builds the triangulation bottom-up. A part is a range of points with its four extreme points.
class DivideAndConquer {
 public:
  explicit DivideAndConquer(EdgeNet& net) : net_(net), key_(net.points), hull_(net.points.size(), no_index) {
    keys_.reserve(net.points.size());
    for (const Vec2 p : net.points) keys_.push_back(key_(p));
  }

  Index run() {
    const Part all = build(0, static_cast<Index>(net_.points.size()));
    return net_.previous_around(hull_[all.left]);
  }

 private:
  // Ties are broken so that each is an end of the range of a cut: left and right by (x, y), bottom and top by
  // (y, -x).
  struct Part {
    Index left, right, bottom, top;
  };

  Part build(Index first, Index end);
  Part build_two(Index a, Index b);
  Index cut(Index first, Index end, bool& by_x) const;
  void merge(Index inner_low, Index inner_high);
  Index lower_tangent(Index low, Index high);
  bool is_above(Index e, Index base) const {
    return orient2d(net_.to(e), net_.to(base), net_.from(base)) > 0;
  }
  Index left_candidate(Index base);
  Index right_candidate(Index base);
  Index lower(Index a, Index b) const {
    const Vec2 p = net_.points[a], q = net_.points[b];
    return p.y < q.y || (p.y == q.y && p.x > q.x) ? a : b;
  }
  Index lefter(Index a, Index b) const { return lexicographic(net_.points[a], net_.points[b]) ? a : b; }

  EdgeNet& net_;
  MortonKey key_;
  std::vector<std::uint64_t> keys_;
  std::vector<Index>
      hull_;  // per point on the hull of its part: the edge from it, counter-clockwise along the hull
};

// The place of the highest bit in which the keys of the range differ; the middle where they are all equal
// (the points are in lexicographic order then).
Index DivideAndConquer::cut(Index first, Index end, bool& by_x) const {
  const std::uint64_t difference = keys_[first] ^ keys_[end - 1];
  by_x = true;
  if (difference == 0) return first + (end - first) / 2;
  const int bit = 63 - std::countl_zero(difference);
  by_x = bit & 1;
  const std::uint64_t mask = std::uint64_t{1} << bit;
  const auto begin = keys_.begin();
  return static_cast<Index>(
      std::partition_point(begin + first, begin + end, [&](std::uint64_t k) { return !(k & mask); }) - begin);
}

DivideAndConquer::Part DivideAndConquer::build(Index first, Index end) {
  if (end - first == 1) return {first, first, first, first};
  if (end - first == 2) return build_two(first, first + 1);
  bool by_x;
  const Index middle = cut(first, end, by_x);
  const Part a = build(first, middle), b = build(middle, end);
  if (by_x)
    merge(a.right, b.left);
  else
    merge(a.top, b.bottom);
  return {lefter(a.left, b.left), lefter(a.right, b.right) == a.right ? b.right : a.right,
          lower(a.bottom, b.bottom), lower(a.top, b.top) == a.top ? b.top : a.top};
}

DivideAndConquer::Part DivideAndConquer::build_two(Index a, Index b) {
  const Index e = net_.add(a, b);
  hull_[a] = e;
  hull_[b] = e ^ 1;
  const Index left = lefter(a, b), bottom = lower(a, b);
  return {left, a + b - left, bottom, a + b - bottom};
}

// `low` is the part to the left of (or below) the cut. Returns the edge from the high to the low part along
// which both hulls lie on its right side, looking from high to low.
Index DivideAndConquer::lower_tangent(Index low, Index high) {
  const auto& p = net_.points;
  // Edges of the hulls with the outside on the left of `left` and on the right of `right`; none for a lone
  // point.
  Index left = hull_[low] == no_index ? no_index : net_.previous_around(hull_[low]);
  Index right = hull_[high];
  Index l = low, r = high;
  for (;;) {
    if (left != no_index && orient2d(p[l], net_.to(left), p[r]) > 0) {
      left = net_.next_of_face(left);
      l = net_.origin(left);
    } else if (right != no_index && orient2d(p[r], net_.to(right), p[l]) < 0) {
      right = net_.next_around(right ^ 1);
      r = net_.origin(right);
    } else {
      break;
    }
  }
  const Index base = net_.add(r, l);
  if (right != no_index) net_.attach(base, net_.previous_around(right));
  if (left != no_index) net_.attach(base ^ 1, left);
  hull_[l] = base ^ 1;
  if (right == no_index) hull_[r] = base;
  return base;
}

// The next point of the low part that the circle over the base meets first; edges inside of it go. Returns
// the edge to it from the base's low end, no_index where there is none above the base.
Index DivideAndConquer::left_candidate(Index base) {
  Index candidate = net_.next_around(base ^ 1);
  if (candidate == (base ^ 1) || !is_above(candidate, base)) return no_index;
  const Vec2 b = net_.to(base), a = net_.from(base);
  for (;;) {
    const Index next = net_.next_around(candidate);
    if (next == (base ^ 1) || incircle(b, a, net_.to(candidate), net_.to(next)) <= 0) return candidate;
    net_.remove(candidate);
    candidate = next;
  }
}

Index DivideAndConquer::right_candidate(Index base) {
  Index candidate = net_.previous_around(base);
  if (candidate == base || !is_above(candidate, base)) return no_index;
  const Vec2 b = net_.to(base), a = net_.from(base);
  for (;;) {
    const Index next = net_.previous_around(candidate);
    if (next == base || incircle(b, a, net_.to(candidate), net_.to(next)) <= 0) return candidate;
    net_.remove(candidate);
    candidate = next;
  }
}

// Sews the two parts together from the lower to the upper common tangent.
void DivideAndConquer::merge(Index inner_low, Index inner_high) {
  Index base = lower_tangent(inner_low, inner_high);
  for (;;) {
    const Index left = left_candidate(base), right = right_candidate(base);
    if (left == no_index && right == no_index) break;
    const bool take_right =
        left == no_index ||
        (right != no_index && incircle(net_.to(left), net_.from(left), net_.from(right), net_.to(right)) > 0);
    base = take_right ? net_.connect(right, base ^ 1) : net_.connect(base ^ 1, left ^ 1);
  }
  hull_[net_.origin(base)] = base;
}

}  // namespace

PointOrder put_points(const std::vector<Vec2>& points, EdgeNet& net) {
  const MortonKey key(points);
  std::vector<Keyed> items(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) items[i] = {key(points[i]), static_cast<Index>(i)};
  sort_by_key(items);
  PointOrder order;
  order_runs(items, points, order);
  order.input.reserve(points.size());
  net.points.reserve(points.size());
  for (const Keyed& item : items) {
    order.input.push_back(item.point);
    net.points.push_back(points[item.point]);
  }
  return order;
}

Index connect_delaunay(EdgeNet& net) {
  if (net.points.size() < 2) return no_index;
  net.reserve(6 * net.points.size());
  return DivideAndConquer(net).run();
}

}  // namespace beadmesh::delaunay
