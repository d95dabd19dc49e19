#include "beadmesh/geometry/ray_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace beadmesh {
namespace {

constexpr Index leaf_size = 8;

double coordinate(Vec3 p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/// After Möller, Trumbore: "Fast, minimum storage ray/triangle intersection", 1997. Edges belong to it.
std::optional<double> meet(const std::array<Vec3, 3>& t, Vec3 origin, Vec3 direction) {
  constexpr double slack = 1e-12;
  const Vec3 e1 = t[1] - t[0], e2 = t[2] - t[0], p = cross(direction, e2);
  const double det = dot(e1, p);
  if (det == 0) return std::nullopt;
  const Vec3 s = origin - t[0], q = cross(s, e1);
  const double u = dot(s, p) / det, v = dot(direction, q) / det;
  if (!(u >= -slack && v >= -slack && u + v <= 1 + slack)) return std::nullopt;
  return dot(e2, q) / det;
}

}  // namespace

RaySearch::RaySearch(std::vector<std::array<Vec3, 3>> triangles)
    : triangles_(std::move(triangles)), order_(triangles_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (!order_.empty()) add_node(0, static_cast<Index>(order_.size()));
}

Index RaySearch::add_node(Index begin, Index end) {
  const Index id = static_cast<Index>(nodes_.size());
  Node node{triangles_[order_[begin]][0], triangles_[order_[begin]][0], begin, end, 0, no_index};
  for (Index i = begin; i < end; ++i)
    for (const Vec3 p : triangles_[order_[i]]) {
      node.low = {std::min(node.low.x, p.x), std::min(node.low.y, p.y), std::min(node.low.z, p.z)};
      node.high = {std::max(node.high.x, p.x), std::max(node.high.y, p.y), std::max(node.high.z, p.z)};
    }
  nodes_.push_back(node);
  if (end - begin <= leaf_size) return id;
  const Vec3 size = node.high - node.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto key = [&](Index t) {
    return coordinate(triangles_[t][0] + triangles_[t][1] + triangles_[t][2], axis);
  };
  const Index middle = (begin + end) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](Index a, Index b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  const Index left = add_node(begin, middle), right = add_node(middle, end);
  nodes_[id].left = left;
  nodes_[id].right = right;
  return id;
}

std::optional<RayHit> RaySearch::first_hit(Vec3 origin, Vec3 direction, double from, double to) const {
  std::optional<RayHit> best;
  const auto may_meet = [&](const Node& node) {
    double low = from, high = best ? best->distance : to;
    for (int axis = 0; axis < 3; ++axis) {
      const double d = coordinate(direction, axis), o = coordinate(origin, axis);
      double a = coordinate(node.low, axis) - o, b = coordinate(node.high, axis) - o;
      if (d == 0 && (a > 0 || b < 0)) return false;
      if (d == 0) continue;
      a /= d, b /= d;
      low = std::max(low, std::min(a, b));
      high = std::min(high, std::max(a, b));
    }
    return low <= high * (1 + 1e-12) + 1e-12;
  };
  std::vector<Index> todo;
  if (!nodes_.empty()) todo.push_back(0);
  while (!todo.empty()) {
    const Node& node = nodes_[todo.back()];
    todo.pop_back();
    if (!may_meet(node)) continue;
    if (node.right != no_index) {
      todo.push_back(node.right);
      todo.push_back(node.left);
      continue;
    }
    for (Index i = node.begin; i < node.end; ++i) {
      const auto at = meet(triangles_[order_[i]], origin, direction);
      if (!at || *at <= from || *at >= to) continue;
      if (!best || *at < best->distance || (*at == best->distance && order_[i] < best->triangle))
        best = RayHit{*at, order_[i]};
    }
  }
  return best;
}

}  // namespace beadmesh
