#include "beadmesh/flatten/triangle_topology.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

namespace beadmesh {
namespace {

/// One side of an edge: triangle t, from its corner k to the next.
struct HalfEdge {
  Index low, high;  ///< the two vertices, ascending
  Index triangle;
  Index corner;
  bool forward;  ///< runs from low to high

  bool same_edge(const HalfEdge& other) const { return low == other.low && high == other.high; }
};

std::vector<HalfEdge> sorted_half_edges(const std::vector<Triangle>& triangles) {
  std::vector<HalfEdge> all;
  all.reserve(3 * triangles.size());
  for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t)
    for (Index k = 0; k < 3; ++k) {
      const Index a = triangles[t][k], b = triangles[t][(k + 1) % 3];
      all.push_back({std::min(a, b), std::max(a, b), t, k, a < b});
    }
  std::sort(all.begin(), all.end(), [](const HalfEdge& a, const HalfEdge& b) {
    if (a.low != b.low) return a.low < b.low;
    if (a.high != b.high) return a.high < b.high;
    return a.triangle != b.triangle ? a.triangle < b.triangle : a.corner < b.corner;
  });
  return all;
}

Result<void> check_input(const Facets& facets) {
  const auto point_count = static_cast<Index>(facets.points.size());
  if (facets.triangles.empty()) return fail("flatten.input", "the piece has no triangles");
  std::vector<bool> used(facets.points.size(), false);
  for (const Triangle& triangle : facets.triangles) {
    for (const Index v : triangle) {
      if (v < 0 || v >= point_count)
        return fail("flatten.input", "a triangle has a vertex that does not exist");
      used[v] = true;
    }
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0])
      return fail("flatten.input", "a triangle uses the same vertex twice");
  }
  for (std::size_t v = 0; v < facets.points.size(); ++v) {
    const Vec3 p = facets.points[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      return fail("flatten.input", "a vertex has a coordinate that is no number");
    if (!used[v]) return fail("flatten.input", "a vertex belongs to no triangle");
  }
  return {};
}

Result<void> check_edges(const std::vector<HalfEdge>& half_edges) {
  for (std::size_t i = 0; i < half_edges.size();) {
    std::size_t end = i + 1;
    while (end < half_edges.size() && half_edges[end].same_edge(half_edges[i])) ++end;
    if (end - i > 2) return fail("flatten.not_manifold", "an edge has more than two triangles");
    if (end - i == 2 && half_edges[i].forward == half_edges[i + 1].forward)
      return fail("flatten.not_manifold", "two neighbouring triangles have opposite orientations");
    i = end;
  }
  return {};
}

TriangleNeighbours paired(const std::vector<HalfEdge>& all, std::size_t triangle_count) {
  TriangleNeighbours neighbours(triangle_count, {no_index, no_index, no_index});
  for (std::size_t i = 0; i < all.size();) {
    std::size_t end = i + 1;
    while (end < all.size() && all[end].same_edge(all[i])) ++end;
    if (end - i == 2 && all[i].forward != all[i + 1].forward) {
      neighbours[all[i].triangle][all[i].corner] = all[i + 1].triangle;
      neighbours[all[i + 1].triangle][all[i + 1].corner] = all[i].triangle;
    }
    i = end;
  }
  return neighbours;
}

bool is_connected(const TriangleNeighbours& neighbours) {
  std::vector<bool> seen(neighbours.size(), false);
  std::vector<Index> stack{0};
  seen[0] = true;
  std::size_t count = 0;
  while (!stack.empty()) {
    const Index t = stack.back();
    stack.pop_back();
    ++count;
    for (const Index n : neighbours[t])
      if (n != no_index && !seen[n]) {
        seen[n] = true;
        stack.push_back(n);
      }
  }
  return count == neighbours.size();
}

/// The corner of `triangle` at vertex v.
Index corner_of(const Triangle& triangle, Index v) {
  return triangle[0] == v ? 0 : triangle[1] == v ? 1 : 2;
}

/// From the boundary half-edge (t, k) the boundary half-edge that follows it, round the fan at its end
/// vertex.
std::pair<Index, Index> next_boundary(const std::vector<Triangle>& triangles,
                                      const TriangleNeighbours& neighbours, Index t, Index k) {
  const Index v = triangles[t][(k + 1) % 3];
  Index corner = (k + 1) % 3;
  while (neighbours[t][corner] != no_index) {
    t = neighbours[t][corner];
    corner = corner_of(triangles[t], v);
  }
  return {t, corner};
}

/// Number of fans of triangles around vertices, = number of vertices after cutting where the boundary touches
/// itself, and number of closed boundary loops after that cut.
struct FansAndLoops {
  Index fans = 0;
  Index loops = 0;
};

FansAndLoops count_fans_and_loops(const std::vector<Triangle>& triangles,
                                  const TriangleNeighbours& neighbours) {
  FansAndLoops counts;
  std::vector<std::array<bool, 3>> corner_seen(triangles.size(), {false, false, false});
  std::vector<std::array<bool, 3>> side_seen(triangles.size(), {false, false, false});
  const auto sweep = [&](Index t,
                         Index corner) {  // clockwise or round: marks a fan, starting at its boundary if any
    const Index v = triangles[t][corner];
    while (!corner_seen[t][corner]) {
      corner_seen[t][corner] = true;
      const Index next = neighbours[t][corner];
      if (next == no_index) return;
      t = next;
      corner = corner_of(triangles[t], v);
    }
  };
  const auto count = static_cast<Index>(triangles.size());
  for (const bool boundary_first : {true, false})
    for (Index t = 0; t < count; ++t)
      for (Index k = 0; k < 3; ++k) {
        if (corner_seen[t][k] || (boundary_first && neighbours[t][(k + 2) % 3] != no_index)) continue;
        ++counts.fans;
        sweep(t, k);
      }
  for (Index t = 0; t < count; ++t)
    for (Index k = 0; k < 3; ++k) {
      if (neighbours[t][k] != no_index || side_seen[t][k]) continue;
      ++counts.loops;
      for (std::pair<Index, Index> at{t, k}; !side_seen[at.first][at.second];) {
        side_seen[at.first][at.second] = true;
        at = next_boundary(triangles, neighbours, at.first, at.second);
      }
    }
  return counts;
}

Result<void> check_loops(const Facets& facets, const TriangleNeighbours& neighbours) {
  std::vector<std::pair<Index, Index>> boundary, looped;
  for (std::size_t t = 0; t < facets.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (neighbours[t][k] == no_index)
        boundary.emplace_back(facets.triangles[t][k], facets.triangles[t][(k + 1) % 3]);
  for (const std::vector<Index>& loop : facets.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) looped.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
  std::sort(boundary.begin(), boundary.end());
  std::sort(looped.begin(), looped.end());
  if (boundary != looped)
    return fail("flatten.loops", "the loops of the piece are not the boundary of its facets");
  return {};
}

}  // namespace

TriangleNeighbours triangle_neighbours(const std::vector<Triangle>& triangles) {
  return paired(sorted_half_edges(triangles), triangles.size());
}

Result<TriangleNeighbours> check_disc(const Facets& facets) {
  if (auto ok = check_input(facets); !ok) return Failure(ok.error());
  const std::vector<HalfEdge> half_edges = sorted_half_edges(facets.triangles);
  if (auto ok = check_edges(half_edges); !ok) return Failure(ok.error());
  TriangleNeighbours neighbours = paired(half_edges, facets.triangles.size());
  if (!is_connected(neighbours))
    return fail("flatten.disconnected", "the piece falls apart into several",
                "split it into connected pieces");
  const FansAndLoops counts = count_fans_and_loops(facets.triangles, neighbours);
  if (counts.loops == 0)
    return fail("flatten.closed", "the piece is closed, it has no boundary",
                "cut it open, or leave a face out");
  Index inner = 0;
  for (const auto& sides : neighbours)
    inner +=
        static_cast<Index>(std::count_if(sides.begin(), sides.end(), [](Index n) { return n != no_index; }));
  const auto triangle_count = static_cast<Index>(facets.triangles.size());
  const Index edges = 3 * triangle_count - inner / 2;
  const Index euler = counts.fans - edges + triangle_count;
  if (euler != 2 - counts.loops)
    return fail("flatten.not_a_disc", "the piece has a handle, it is no disc with holes", "cut it open");
  if (auto ok = check_loops(facets, neighbours); !ok) return Failure(ok.error());
  return neighbours;
}

}  // namespace beadmesh
