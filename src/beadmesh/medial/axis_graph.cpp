#include "beadmesh/medial/axis_graph.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace beadmesh {
namespace {

Index next_slot(Index half_edge) {
  return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
}

struct Box {
  Vec2 low, high;
  double weight = 0;  ///< area of the triangle whose centre stands for the cluster
};

/// Two neighbours that nearly have one centre: distance over radius, and the half-edge between them.
struct NearPair {
  float nearness;
  Index half_edge;
};

/// Nearest first, up to a factor of the square root of 2: what is as near keeps its order. In linear time,
/// since on a dense boundary nearly all neighbours are near.
std::vector<NearPair> nearest_first(const std::vector<NearPair>& pairs) {
  constexpr std::uint32_t bits_left_out = 22;  // all but the exponent and the first bit of the fraction
  const auto rank = [](const NearPair& pair) {
    return std::bit_cast<std::uint32_t>(pair.nearness) >> bits_left_out;
  };
  std::vector<std::size_t> place((1u << (32 - bits_left_out)) + 1, 0);
  for (const NearPair& pair : pairs) ++place[rank(pair) + 1];
  std::partial_sum(place.begin(), place.end(), place.begin());
  std::vector<NearPair> sorted(pairs.size());
  for (const NearPair& pair : pairs) sorted[place[rank(pair)]++] = pair;
  return sorted;
}

Box joined(const Box& a, const Box& b) {
  return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
          {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)},
          std::max(a.weight, b.weight)};
}

}  // namespace

AxisTriangles::AxisTriangles(const Triangulation& triangulation, const BoundarySamples& samples)
    : triangulation_(triangulation) {
  const auto count = static_cast<Index>(triangulation.triangles.size());
  const std::vector<TriangleType> types = triangle_types(triangulation, samples);
  twin_.assign(3 * triangulation.triangles.size(), no_index);
  open_.assign(twin_.size(), 0);
  parent_.reserve(count);
  clusters_.reserve(count);
  for (Index t = 0; t < count; ++t) {
    parent_.push_back(t);
    const Triangle& corners = triangulation.triangles[t];
    Cluster cluster;
    if (types[t] == TriangleType::C) {
      cluster.corner = ear_tip(triangulation, t);
      cluster.circle = {samples.samples[cluster.corner].point, 0};
    } else {
      cluster.circle = circumcircle(triangulation.points[corners[0]], triangulation.points[corners[1]],
                                    triangulation.points[corners[2]]);
    }
    clusters_.push_back(cluster);
    for (int k = 0; k < 3; ++k) {
      const Index other = triangulation.neighbours[t][k];
      if (other == no_index) continue;
      const Index from = corners[(k + 1) % 3];
      for (int slot = 0; slot < 3; ++slot)
        if (triangulation.triangles[other][(slot + 2) % 3] == from &&
            triangulation.neighbours[other][slot] == t)
          twin_[3 * t + k] = 3 * other + slot;
      open_[3 * t + k] = twin_[3 * t + k] != no_index;
    }
  }
}

const Circle& AxisTriangles::tip(Index root) const {
  const auto found = tips_.find(root);
  return found == tips_.end() ? clusters_[root].circle : found->second;
}

Index AxisTriangles::find(Index triangle) const {
  while (parent_[triangle] != triangle) triangle = parent_[triangle] = parent_[parent_[triangle]];
  return triangle;
}

// Looking out of a counter-clockwise triangle through slot k, corner k + 2 is on the left and k + 1 on the
// right.
Index AxisTriangles::left(Index half_edge) const {
  return triangulation_.triangles[half_edge / 3][(half_edge % 3 + 2) % 3];
}

Index AxisTriangles::right(Index half_edge) const {
  return triangulation_.triangles[half_edge / 3][(half_edge % 3 + 1) % 3];
}

Index AxisTriangles::next_open(Index half_edge) const {
  Index at = half_edge;
  for (;;) {
    at = next_slot(at);
    if (twin_[at] == no_index) continue;
    if (open_[at]) return at;
    at = twin_[at];
  }
}

Index AxisTriangles::degree(Index half_edge) const {
  Index count = 1;
  for (Index h = next_open(half_edge); h != half_edge; h = next_open(h)) ++count;
  return count;
}

Index AxisTriangles::next_in_chain(Index half_edge) const {
  const Index entered = twin_[half_edge], out = next_open(entered);
  return out == entered || next_open(out) != entered ? no_index : out;
}

std::vector<Index> AxisTriangles::chain(Index half_edge) const {
  std::vector<Index> passed{half_edge};
  for (;;) {
    const Index out = next_in_chain(passed.back());
    if (out == no_index || out == half_edge) return passed;
    passed.push_back(out);
  }
}

Index AxisTriangles::chain_end(Index half_edge) const {
  Index last = half_edge;
  for (Index out = half_edge; out != no_index; out = next_in_chain(out)) {
    last = out;
    if (twin_[out] == half_edge) break;
  }
  return cluster_of(twin_[last]);
}

bool AxisTriangles::close(Index half_edge, Index keep) {
  const Index a = find(half_edge / 3), b = find(twin_[half_edge] / 3);
  if (a == b) return false;
  const Index winner = find(keep), loser = winner == a ? b : a;
  parent_[loser] = winner;
  open_[half_edge] = open_[twin_[half_edge]] = 0;
  return true;
}

void AxisTriangles::contract(double tolerance) {
  std::vector<NearPair> near;
  std::vector<Box> boxes;
  boxes.reserve(clusters_.size());
  for (Index t = 0; t < triangle_count(); ++t) {
    const Circle& circle = clusters_[t].circle;
    const Triangle& corners = triangulation_.triangles[t];
    const Vec2 a = triangulation_.points[corners[0]];
    boxes.push_back({circle.centre, circle.centre,
                     cross(triangulation_.points[corners[1]] - a, triangulation_.points[corners[2]] - a)});
    for (Index h = 3 * t; h < 3 * t + 3; ++h) {
      if (twin_[h] < h) continue;
      const Cluster& other = clusters_[twin_[h] / 3];
      if (clusters_[t].corner != no_index || other.corner != no_index) continue;
      const double radius = std::min(circle.radius, other.circle.radius);
      const double square = squared_norm(other.circle.centre - circle.centre);
      if (square <= tolerance * tolerance * radius * radius)
        near.push_back({static_cast<float>(std::sqrt(square) / radius), h});
    }
  }
  for (const auto& [nearness, h] : nearest_first(near)) {
    const Index a = find(h / 3), b = find(twin_[h] / 3);
    if (a == b) continue;
    const Box box = joined(boxes[a], boxes[b]);
    const double radius = std::min(clusters_[a].circle.radius, clusters_[b].circle.radius);
    if (distance(box.low, box.high) > tolerance * radius) continue;
    // The largest triangle has the best conditioned centre.
    const Index keep = boxes[a].weight >= boxes[b].weight ? a : b;
    close(h, keep);
    boxes[keep] = box;
  }
}

int AxisTriangles::open_sides(Index triangle) const {
  int count = 0;
  for (Index h = 3 * triangle; h < 3 * triangle + 3; ++h) {
    if (open_[h])
      ++count;
    else if (twin_[h] != no_index)
      return -1;
  }
  return count;
}

std::vector<Index> AxisTriangles::leaves() const {
  std::vector<Index> leaves;
  for (Index t = 0; t < triangle_count(); ++t) {
    if (open_sides(t) > 1) continue;
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
      if (open_[h] && next_open(h) == h) leaves.push_back(h);
  }
  return leaves;
}

AxisGraph AxisTriangles::march() const {
  AxisGraph graph;
  const auto count = static_cast<Index>(twin_.size());
  std::vector<Index> node_of(count, no_index);
  std::vector<char> marked(count, 0);
  for (Index h = 0; h < count; ++h) {
    if (h % 3 == 0 && open_sides(h / 3) == 2) {  // most triangles are but a step of an edge
      h += 2;
      continue;
    }
    if (!open_[h] || node_of[h] != no_index || degree(h) == 2) continue;
    const Index root = find(h / 3);
    AxisNode node{root, clusters_[root].corner != no_index, {}};
    for (Index out = h; node.out.empty() || out != h; out = next_open(out)) {
      node_of[out] = static_cast<Index>(graph.nodes.size());
      node.out.push_back(out);
    }
    graph.nodes.push_back(std::move(node));
  }
  const auto slot = [&](Index node, Index h) {
    const std::vector<Index>& out = graph.nodes[node].out;
    return static_cast<Index>(std::find(out.begin(), out.end(), h) - out.begin());
  };
  const auto add_edge = [&](Index h) {
    if (marked[h]) return;
    AxisEdge edge;
    edge.start = node_of[h];
    edge.half_edges = chain(h);
    for (const Index passed : edge.half_edges) marked[passed] = marked[twin_[passed]] = 1;
    if (edge.start != no_index) {
      const Index last = twin_[edge.half_edges.back()];
      edge.end = node_of[last];
      edge.start_slot = slot(edge.start, h);
      edge.end_slot = slot(edge.end, last);
    }
    graph.edges.push_back(std::move(edge));
  };
  for (const AxisNode& node : graph.nodes)
    for (const Index h : node.out) add_edge(h);
  for (Index h = 0; h < count; ++h)
    if (open_[h]) add_edge(h);
  if (graph.nodes.empty() && graph.edges.empty() && triangle_count() > 0)
    graph.nodes.push_back({find(0), false, {}});
  return graph;
}

}  // namespace beadmesh
