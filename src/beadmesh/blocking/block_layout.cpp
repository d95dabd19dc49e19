#include "beadmesh/blocking/block_layout.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

double signed_area(const std::vector<Vec2>& polygon) {
  double area = 0;
  for (size_t i = 0; i < polygon.size(); ++i)
    area += cross(polygon[i], polygon[(i + 1) % polygon.size()]) / 2;
  return area;
}

/// Sides 0 and 2 keep their places.
void turn_over(Block& block) {
  std::swap(block.sides[1], block.sides[3]);
  for (BlockSide& side : block.sides) {
    std::reverse(side.edges.begin(), side.edges.end());
    std::reverse(side.reversed.begin(), side.reversed.end());
    side.reversed.flip();
  }
}

}  // namespace

BlockLayoutBuilder::BlockLayoutBuilder(const PlanarRegion& region) : region_(region) {
  for (const PlanarLoop& loop : region.loops) {
    std::vector<double> offsets{0};
    for (size_t i = 0; i < loop.points.size(); ++i)
      offsets.push_back(offsets.back() + distance(loop.points[i], loop.points[(i + 1) % loop.points.size()]));
    offsets_.push_back(std::move(offsets));
  }
}

Index BlockLayoutBuilder::add_vertex(Vec2 point) {
  layout_.vertices.push_back({point, false, {}});
  return Index(layout_.vertices.size()) - 1;
}

Index BlockLayoutBuilder::add_boundary_vertex(BoundaryPosition position) {
  layout_.vertices.push_back({point_at(position), true, position});
  return Index(layout_.vertices.size()) - 1;
}

Vec2 BlockLayoutBuilder::point_at(BoundaryPosition position) const {
  const auto& offsets = offsets_[position.loop];
  const auto& points = region_.loops[position.loop].points;
  double s = std::fmod(position.position, offsets.back());
  if (s < 0) s += offsets.back();
  const size_t next = std::upper_bound(offsets.begin(), offsets.end(), s) - offsets.begin();
  const size_t i = std::min(next, points.size()) - 1;
  const double step = offsets[i + 1] - offsets[i];
  return lerp(points[i], points[(i + 1) % points.size()], step > 0 ? (s - offsets[i]) / step : 0);
}

Index BlockLayoutBuilder::find_edge(Index a, Index b) const {
  for (Index e = 0; e < Index(layout_.edges.size()); ++e) {
    const VirtualEdge& edge = layout_.edges[e];
    if ((edge.start == a && edge.end == b) || (edge.start == b && edge.end == a)) return e;
  }
  return no_index;
}

Index BlockLayoutBuilder::add_edge(Index start, Index end, VirtualEdgeKind kind,
                                   const std::vector<Vec2>& inner_points, int count) {
  const Index known = find_edge(start, end);
  if (known != no_index) return known;
  VirtualEdge edge;
  edge.start = start;
  edge.end = end;
  edge.kind = kind;
  edge.points.push_back(point_of(start));
  edge.points.insert(edge.points.end(), inner_points.begin(), inner_points.end());
  edge.points.push_back(point_of(end));
  edge.count = count;
  layout_.edges.push_back(std::move(edge));
  return Index(layout_.edges.size()) - 1;
}

Index BlockLayoutBuilder::add_boundary_edge(Index start, Index end, bool backward, int count) {
  const BoundaryPosition a = layout_.vertices[start].boundary, b = layout_.vertices[end].boundary;
  if (a.loop != b.loop) {
    fault_ = "the two ends of a boundary side lie on different loops";
    return no_index;
  }
  const auto& offsets = offsets_[a.loop];
  const auto& points = region_.loops[a.loop].points;
  const double length = offsets.back();
  VirtualEdge edge{start, end,  VirtualEdgeKind::boundary, {}, a.loop, a.position, b.position, length,
                   {},    count};
  if (!backward && edge.to <= edge.from) edge.to += length;
  if (backward && edge.to >= edge.from) edge.to -= length;
  const double low = std::min(edge.from, edge.to), high = std::max(edge.from, edge.to);
  for (int turn = -1; turn <= 2; ++turn)
    for (size_t i = 0; i < points.size(); ++i) {
      const double at = offsets[i] + turn * length;
      if (at > low && at < high) edge.points.push_back(points[i]);
    }
  if (backward) std::reverse(edge.points.begin(), edge.points.end());
  edge.points.insert(edge.points.begin(), point_of(start));
  edge.points.push_back(point_of(end));
  layout_.edges.push_back(std::move(edge));
  return Index(layout_.edges.size()) - 1;
}

void BlockLayoutBuilder::add_block(const std::array<std::vector<Index>, 4>& sides, bool graded) {
  Block block;
  block.graded = graded;
  std::vector<Vec2> outline;
  for (int k = 0; k < 4; ++k) {
    for (size_t i = 1; i < sides[k].size(); ++i) {
      const Index e = find_edge(sides[k][i - 1], sides[k][i]);
      if (e == no_index) {
        fault_ = "a block lacks one of its sides";
        return;
      }
      const bool reversed = layout_.edges[e].start != sides[k][i - 1];
      block.sides[k].edges.push_back(e);
      block.sides[k].reversed.push_back(reversed);
      auto points = layout_.edges[e].points;
      if (reversed) std::reverse(points.begin(), points.end());
      outline.insert(outline.end(), points.begin(), points.end() - 1);
    }
  }
  if (signed_area(outline) < 0) turn_over(block);
  layout_.blocks.push_back(std::move(block));
}

void BlockLayoutBuilder::mark_cap(size_t first) {
  for (size_t b = first; b < layout_.blocks.size(); ++b) layout_.blocks[b].cap = true;
}

Result<BlockLayout> BlockLayoutBuilder::take() {
  if (!fault_.empty()) return fail("blocking.missing_edge", fault_);
  return std::move(layout_);
}

}  // namespace beadmesh
