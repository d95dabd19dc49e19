#include "beadmesh/flatten/facet_search.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace beadmesh {
namespace {

constexpr Index leaf_size = 4;

/// Fraction along ab of the point nearest to p.
template <class V>
double nearest_fraction(V a, V b, V p) {
  const double squared = squared_norm(b - a);
  return squared > 0 ? std::clamp(dot(p - a, b - a) / squared, 0.0, 1.0) : 0;
}

template <class V>
std::array<double, 3> nearest_on_edges(const std::array<V, 3>& corner, V p) {
  std::array<double, 3> best{1, 0, 0};
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    const double t = nearest_fraction(corner[k], corner[next], p);
    const double squared = squared_norm(lerp(corner[k], corner[next], t) - p);
    if (squared < least) {
      least = squared;
      best = {0, 0, 0};
      best[k] = 1 - t;
      best[next] = t;
    }
  }
  return best;
}

double dot(double a, double b) {
  return a * b;
}  // cross products of the plane are numbers

template <class V>
std::array<double, 3> nearest_in_triangle(V a, V b, V c, V p) {
  const V u = b - a, v = c - a, w = p - a;
  const auto normal = cross(u, v);
  const double squared_area = dot(normal, normal);
  if (squared_area > 1e-20 * squared_norm(u) * squared_norm(v)) {
    const double s = dot(cross(w, v), normal) / squared_area, t = dot(cross(u, w), normal) / squared_area;
    if (s >= 0 && t >= 0 && s + t <= 1) return {1 - s - t, s, t};
  }
  return nearest_on_edges<V>({a, b, c}, p);
}

struct Box {
  Vec3 low, high;

  double squared_distance(Vec3 p) const {
    const double x = std::max({low.x - p.x, 0.0, p.x - high.x});
    const double y = std::max({low.y - p.y, 0.0, p.y - high.y});
    const double z = std::max({low.z - p.z, 0.0, p.z - high.z});
    return x * x + y * y + z * z;
  }
  void add(Vec3 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
};

Box box_around(Vec3 p) {
  return {p, p};
}

double component(Vec3 v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

}  // namespace

std::array<double, 3> nearest_weights(Vec3 a, Vec3 b, Vec3 c, Vec3 p) {
  return nearest_in_triangle(a, b, c, p);
}
std::array<double, 3> nearest_weights(Vec2 a, Vec2 b, Vec2 c, Vec2 p) {
  return nearest_in_triangle(a, b, c, p);
}

struct FacetSearch::Tree {
  /// A leaf holds order[first .. first + count); an inner node has count 0, its left child follows it at
  /// once.
  struct Node {
    Box box;
    Index first = 0, count = 0, right = no_index;
  };
  struct Best {
    double squared = std::numeric_limits<double>::infinity();
    Index triangle = no_index;
    std::array<double, 3> weight{0, 0, 0};
  };

  const Facets& facets;
  std::vector<Vec3> centres;
  std::vector<Index> order;
  std::vector<Node> nodes;

  explicit Tree(const Facets& of) : facets(of), order(of.triangles.size()) {
    std::iota(order.begin(), order.end(), 0);
    centres.reserve(order.size());
    for (const Triangle& t : of.triangles)
      centres.push_back((of.points[t[0]] + of.points[t[1]] + of.points[t[2]]) / 3);
    if (!order.empty()) build(0, static_cast<Index>(order.size()));
  }

  void build(Index first, Index count) {
    const auto self = nodes.size();
    nodes.push_back({box_around(facets.points[facets.triangles[order[first]][0]]), first, count, no_index});
    Box centre_box = box_around(centres[order[first]]);
    for (Index i = first; i < first + count; ++i) {
      for (const Index v : facets.triangles[order[i]]) nodes[self].box.add(facets.points[v]);
      centre_box.add(centres[order[i]]);
    }
    if (count <= leaf_size) return;
    const Vec3 extent = centre_box.high - centre_box.low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const Index half = count / 2;
    std::nth_element(order.begin() + first, order.begin() + first + half, order.begin() + first + count,
                     [&](Index a, Index b) {
                       const double x = component(centres[a], axis), y = component(centres[b], axis);
                       return x != y ? x < y : a < b;
                     });
    nodes[self].count = 0;
    build(first, half);
    nodes[self].right = static_cast<Index>(nodes.size());
    build(first + half, count - half);
  }

  void test(Index t, Vec3 p, Best& best) const {
    const Triangle& corners = facets.triangles[t];
    const Vec3 a = facets.points[corners[0]], b = facets.points[corners[1]], c = facets.points[corners[2]];
    const std::array<double, 3> w = nearest_weights(a, b, c, p);
    const double squared = squared_norm(a * w[0] + b * w[1] + c * w[2] - p);
    if (squared < best.squared || (squared == best.squared && t < best.triangle)) best = {squared, t, w};
  }

  void search(Index n, Vec3 p, Best& best) const {
    const Node& node = nodes[n];
    if (node.count > 0) {
      for (Index i = node.first; i < node.first + node.count; ++i) test(order[i], p, best);
      return;
    }
    Index near = n + 1, far = node.right;
    double near_distance = nodes[near].box.squared_distance(p),
           far_distance = nodes[far].box.squared_distance(p);
    if (far_distance < near_distance) {
      std::swap(near, far);
      std::swap(near_distance, far_distance);
    }
    if (near_distance <= best.squared) search(near, p, best);
    if (far_distance <= best.squared) search(far, p, best);
  }
};

FacetSearch::FacetSearch(const Facets& facets) : facets_(&facets), tree_(std::make_unique<Tree>(facets)) {}
FacetSearch::~FacetSearch() = default;
FacetSearch::FacetSearch(FacetSearch&&) noexcept = default;

FacetPoint FacetSearch::nearest(Vec3 p) const {
  FacetPoint found;
  if (tree_->nodes.empty()) return found;
  Tree::Best best;
  tree_->search(0, p, best);
  found.triangle = best.triangle;
  std::copy(best.weight.begin(), best.weight.end(), found.weight);
  return found;
}

const Facets& FacetSearch::facets() const {
  return *facets_;
}

}  // namespace beadmesh
