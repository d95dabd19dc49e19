// What holds for every block layout, and what can be counted in it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "beadmesh/blocking/block_layout.h"
#include "beadmesh/blocking/element_counts.h"

namespace beadmesh::shapes {

inline Index first_vertex(const BlockLayout& layout, const BlockSide& side) {
  const VirtualEdge& edge = layout.edges[side.edges.front()];
  return side.reversed.front() ? edge.end : edge.start;
}
inline Index last_vertex(const BlockLayout& layout, const BlockSide& side) {
  const VirtualEdge& edge = layout.edges[side.edges.back()];
  return side.reversed.back() ? edge.start : edge.end;
}

inline std::vector<Vec2> outline(const BlockLayout& layout, const Block& block) {
  std::vector<Vec2> points;
  for (const BlockSide& side : block.sides)
    for (size_t i = 0; i < side.edges.size(); ++i) {
      auto part = layout.edges[side.edges[i]].points;
      if (side.reversed[i]) std::reverse(part.begin(), part.end());
      points.insert(points.end(), part.begin(), part.end() - 1);
    }
  return points;
}

inline double polygon_area(const std::vector<Vec2>& points) {
  double area = 0;
  for (size_t i = 0; i < points.size(); ++i) area += cross(points[i], points[(i + 1) % points.size()]) / 2;
  return area;
}

inline double region_area(const PlanarRegion& region) {
  double area = 0;
  for (const PlanarLoop& loop : region.loops) area += signed_area(loop);
  return area;
}

/// Sides head to tail and counter-clockwise, edges with two blocks inside and one on the boundary, the whole
/// region covered.
inline void expect_sound(const BlockLayout& layout, const PlanarRegion& region) {
  std::vector<int> uses(layout.edges.size(), 0);
  double area = 0;
  for (size_t b = 0; b < layout.blocks.size(); ++b) {
    const Block& block = layout.blocks[b];
    for (int k = 0; k < 4; ++k) {
      EXPECT_EQ(last_vertex(layout, block.sides[k]), first_vertex(layout, block.sides[(k + 1) % 4]))
          << "block " << b;
      for (Index e : block.sides[k].edges) ++uses[e];
    }
    const double of_block = polygon_area(outline(layout, block));
    EXPECT_GT(of_block, 0) << "block " << b;
    area += of_block;
  }
  for (size_t e = 0; e < uses.size(); ++e)
    EXPECT_EQ(uses[e], layout.edges[e].kind == VirtualEdgeKind::boundary ? 1 : 2) << "edge " << e;
  EXPECT_NEAR(area, region_area(region), 1e-6 * region_area(region));
}

/// Inner vertices without exactly four quads; inside edges and blocks there are none.
inline int irregular_vertices(const BlockLayout& layout) {
  std::vector<int> quads(layout.vertices.size(), 0);
  for (const Block& block : layout.blocks)
    for (const BlockSide& side : block.sides) {
      ++quads[first_vertex(layout, side)];
      for (size_t i = 1; i < side.edges.size(); ++i) {
        const VirtualEdge& edge = layout.edges[side.edges[i]];
        quads[side.reversed[i] ? edge.end : edge.start] += 2;
      }
    }
  int irregular = 0;
  for (size_t v = 0; v < quads.size(); ++v)
    if (!layout.vertices[v].on_boundary && quads[v] > 0 && quads[v] != 4) ++irregular;
  return irregular;
}

inline std::vector<double> flat_lengths(const BlockLayout& layout) {
  std::vector<double> lengths;
  for (const VirtualEdge& edge : layout.edges) {
    double length = 0;
    for (size_t i = 1; i < edge.points.size(); ++i) length += distance(edge.points[i - 1], edge.points[i]);
    lengths.push_back(length);
  }
  return lengths;
}

inline int count_on(const BlockLayout& layout, const BlockSide& side) {
  int count = 0;
  for (Index e : side.edges) count += layout.edges[e].count;
  return count;
}

inline int boundary_count(const BlockLayout& layout) {
  int count = 0;
  for (const VirtualEdge& edge : layout.edges)
    if (edge.kind == VirtualEdgeKind::boundary) count += edge.count;
  return count;
}

/// Every edge has a count and opposite sides are equal.
inline void expect_counted(const BlockLayout& layout) {
  for (const VirtualEdge& edge : layout.edges) EXPECT_GT(edge.count, 0);
  for (const Block& block : layout.blocks)
    for (int k = 0; k < 2; ++k)
      EXPECT_EQ(count_on(layout, block.sides[k]), count_on(layout, block.sides[k + 2]));
}

}  // namespace beadmesh::shapes
