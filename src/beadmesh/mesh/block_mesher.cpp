#include "beadmesh/mesh/block_mesher.h"

#include <algorithm>
#include <cmath>

#include "beadmesh/geometry/polyline.h"
#include "beadmesh/mesh/surface_polyline.h"

namespace beadmesh {
namespace {

using NodeRow = std::vector<Index>;

class BlockMapper {
 public:
  BlockMapper(const BlockLayout& layout, const SurfaceMap& map) : layout_(layout), map_(map) {}

  BeadMesh run() {
    vertex_node_.assign(layout_.vertices.size(), no_index);
    for (const VirtualEdge& edge : layout_.edges) add_edge(edge);
    for (const Block& block : layout_.blocks) {
      const Index first = Index(out_.mesh.elements.size());
      fill(block);
      for (Index e = first; block.cap && e < Index(out_.mesh.elements.size()); ++e)
        out_.cap_elements.push_back(e);
    }
    collect_crest_lines();
    for (size_t e = 0; e < edge_nodes_.size(); ++e)
      out_.block_lines.push_back({layout_.edges[e].kind, edge_nodes_[e]});
    out_.blocks = int(layout_.blocks.size());
    return std::move(out_);
  }

 private:
  Index add_node(Vec2 point, NodeFreedom freedom) {
    out_.mesh.nodes.push_back(point);
    out_.mesh.freedom.push_back(freedom);
    return Index(out_.mesh.nodes.size()) - 1;
  }

  Index add_boundary_node(Vec2 point, BoundaryPosition at) {
    const Index node = add_node(point, NodeFreedom::fixed);
    out_.boundary.push_back({node, at});
    return node;
  }

  Index node_of_vertex(Index v) {
    if (vertex_node_[v] != no_index) return vertex_node_[v];
    const VirtualVertex& vertex = layout_.vertices[v];
    vertex_node_[v] = vertex.on_boundary ? add_boundary_node(vertex.point, vertex.boundary)
                                         : add_node(vertex.point, freedom_of_vertex(v));
    return vertex_node_[v];
  }

  /// A vertex inside a crest line slides along it; where lines meet or end it stays; others are free.
  NodeFreedom freedom_of_vertex(Index v) const {
    int ridges = 0;
    for (const VirtualEdge& edge : layout_.edges)
      if (edge.kind == VirtualEdgeKind::ridge) ridges += (edge.start == v) + (edge.end == v);
    return ridges == 0 ? NodeFreedom::free : ridges == 2 ? NodeFreedom::sliding : NodeFreedom::fixed;
  }

  /// Nodes along an edge, even on the surface, and where each lies along its flat polyline.
  void add_edge(const VirtualEdge& edge) {
    const SurfacePolyline line(edge.points, map_);
    const double flat_length = Polyline<Vec2>(edge.points).length();
    NodeRow row{node_of_vertex(edge.start)};
    std::vector<double> at{0};
    for (int i = 1; i < edge.count; ++i) {
      const double arc = line.length() * i / edge.count;
      row.push_back(inner_node(edge, line, i, arc));
      at.push_back(flat_length * line.flat_share_at(arc));
    }
    row.push_back(node_of_vertex(edge.end));
    at.push_back(flat_length);
    edge_nodes_.push_back(std::move(row));
    edge_at_.push_back(std::move(at));
  }

  Index inner_node(const VirtualEdge& edge, const SurfacePolyline& line, int i, double arc) {
    if (edge.kind != VirtualEdgeKind::boundary)
      return add_node(line.point_at(arc),
                      edge.kind == VirtualEdgeKind::ridge ? NodeFreedom::sliding : NodeFreedom::free);
    if (edge.prescribed.empty()) {
      const double at = edge.from + (edge.to - edge.from) * line.flat_share_at(arc);
      return add_boundary_node(line.point_at(arc), {edge.loop, at});
    }
    const double at = edge.prescribed[i - 1];
    return add_boundary_node(point_on(edge, at), {edge.loop, at});
  }

  /// Flat point of a boundary edge at an arc length of its loop, given within any turn of it.
  static Vec2 point_on(const VirtualEdge& edge, double at) {
    const double walked = edge.to > edge.from ? at - edge.from : edge.from - at;
    double left = std::fmod(walked, edge.loop_length);
    if (left < 0) left += edge.loop_length;
    for (size_t i = 1; i < edge.points.size(); ++i) {
      const double step = distance(edge.points[i - 1], edge.points[i]);
      if (left <= step && step > 0) return lerp(edge.points[i - 1], edge.points[i], left / step);
      left -= step;
    }
    return edge.points.back();
  }

  NodeRow row_of(const BlockSide& side) const {
    NodeRow row;
    for (size_t i = 0; i < side.edges.size(); ++i) {
      NodeRow part = edge_nodes_[side.edges[i]];
      if (side.reversed[i]) std::reverse(part.begin(), part.end());
      if (!row.empty()) row.pop_back();
      row.insert(row.end(), part.begin(), part.end());
    }
    return row;
  }

  void fill(const Block& block) {
    const NodeRow bottom = row_of(block.sides[0]), right = row_of(block.sides[1]);
    NodeRow top = row_of(block.sides[2]), left = row_of(block.sides[3]);
    std::reverse(top.begin(), top.end());
    std::reverse(left.begin(), left.end());
    const std::vector<Vec2> bottom_points = as_many_points(bottom, bottom.size()),
                            top_points = as_many_points(top, bottom.size());
    const size_t rows = left.size() - 1;
    NodeRow row = bottom;
    for (size_t j = 1; j < rows; ++j) {
      NodeRow next = row_between(bottom_points, right, top_points, left, j);
      join_equal(row, next);
      row = std::move(next);
    }
    if (top.size() == row.size())
      join_equal(row, top);
    else if (top.size() > row.size())
      join_graded({row, top, false});
    else
      join_graded({top, row, true});
  }

  /// The points of a row of nodes, or as many as asked for, evenly spaced on the line through them.
  std::vector<Vec2> as_many_points(const NodeRow& row, size_t count) const {
    std::vector<Vec2> points;
    for (Index n : row) points.push_back(out_.mesh.nodes[n]);
    if (points.size() == count) return points;
    const Polyline<Vec2> line(points);
    points.clear();
    for (size_t i = 0; i < count; ++i)
      points.push_back(line.point_at(line.length() * double(i) / double(count - 1)));
    return points;
  }

  void join_equal(const NodeRow& lower, const NodeRow& upper) {
    for (size_t i = 0; i + 1 < lower.size(); ++i) add_quad(lower[i], lower[i + 1], upper[i + 1], upper[i]);
  }

  /// Two lines of nodes with a row between them, as far as it is filled.
  struct GradedRow {
    const NodeRow &coarse, &fine;
    bool turned;  ///< the coarse line lies above the fine one
    int c = 0, f = 0;
  };

  /// One row between lines of n and n + 2 t elements: t templates, evenly spread, plain quads between them.
  void join_graded(GradedRow row) {
    const int n = int(row.coarse.size()) - 1, templates = (int(row.fine.size()) - 1 - n) / 2;
    const double period = double(n) / templates;
    const int width = std::max(1, int(period / 2));
    for (int t = 0; t < templates; ++t) {
      add_plain_quads(row, int((t + 0.5) * period - width / 2.0 + 0.5));
      add_template(row, width);
    }
    add_plain_quads(row, n);
  }

  void add_plain_quads(GradedRow& row, int end) {
    for (; row.c < end; ++row.c, ++row.f)
      add_quad_in(row, row.coarse[row.c], row.coarse[row.c + 1], row.fine[row.f + 1], row.fine[row.f]);
  }

  /// `width` elements beside width + 2; its middle part is two elements high.
  void add_template(GradedRow& row, int width) {
    const Index* coarse = &row.coarse[row.c];
    const Index* fine = &row.fine[row.f];
    NodeRow middle;
    for (int i = 0; i <= width; ++i)
      middle.push_back(
          add_node(lerp(out_.mesh.nodes[coarse[i]], out_.mesh.nodes[fine[i + 1]], 0.5), NodeFreedom::free));
    add_quad_in(row, coarse[0], middle[0], fine[1], fine[0]);
    for (int i = 0; i < width; ++i) {
      add_quad_in(row, coarse[i], coarse[i + 1], middle[i + 1], middle[i]);
      add_quad_in(row, middle[i], middle[i + 1], fine[i + 2], fine[i + 1]);
    }
    add_quad_in(row, middle[width], coarse[width], fine[width + 2], fine[width + 1]);
    row.c += width;
    row.f += width + 2;
  }

  void add_quad_in(const GradedRow& row, Index a, Index b, Index c, Index d) {
    row.turned ? add_quad(d, c, b, a) : add_quad(a, b, c, d);
  }

  void add_quad(Index a, Index b, Index c, Index d) { out_.mesh.elements.push_back({a, b, c, d}); }

  /// Row j between bottom and top: its ends are those of the sides, its inner nodes are new.
  NodeRow row_between(const std::vector<Vec2>& bottom, const NodeRow& right, const std::vector<Vec2>& top,
                      const NodeRow& left, size_t j) {
    const auto& p = out_.mesh.nodes;
    const double v = double(j) / double(left.size() - 1);
    const Vec2 start = p[left[j]], end = p[right[j]];
    NodeRow row{left[j]};
    for (size_t i = 1; i + 1 < bottom.size(); ++i) {
      const double u = double(i) / double(bottom.size() - 1);
      const Vec2 corners = lerp(lerp(bottom.front(), bottom.back(), u), lerp(top.front(), top.back(), u), v);
      row.push_back(add_node(lerp(start, end, u) + lerp(bottom[i], top[i], v) - corners, NodeFreedom::free));
    }
    row.push_back(right[j]);
    return row;
  }

  /// Ridge edges joined over the vertices where just two of them meet.
  void collect_crest_lines() {
    std::vector<bool> used(layout_.edges.size(), false);
    const auto is_through = [&](Index v) {
      return !layout_.vertices[v].on_boundary && freedom_of_vertex(v) == NodeFreedom::sliding;
    };
    for (int round = 0; round < 2; ++round)  // lines with ends first, closed ones after
      for (Index e = 0; e < Index(layout_.edges.size()); ++e) {
        const VirtualEdge& edge = layout_.edges[e];
        if (used[e] || edge.kind != VirtualEdgeKind::ridge) continue;
        if (round == 0 && is_through(edge.start) && is_through(edge.end)) continue;
        const bool from_end = round == 0 && is_through(edge.start);
        add_crest_line(e, from_end, used);
      }
  }

  /// A crest as far as it has been walked: its fine points, its nodes and where they lie.
  struct CrestWalk {
    std::vector<Vec2> points;
    NodeRow nodes;
    std::vector<double> at;
  };

  void add_crest_line(Index e, bool from_end, std::vector<bool>& used) {
    CrestWalk line;
    Index at = from_end ? layout_.edges[e].end : layout_.edges[e].start;
    while (e != no_index) {
      used[e] = true;
      const bool backward = layout_.edges[e].start != at;
      append(line, e, backward);
      at = backward ? layout_.edges[e].start : layout_.edges[e].end;
      e = next_ridge(at, used);
    }
    out_.crest_lines.push_back(line.nodes);
    const bool closed = line.nodes.size() > 2 && line.nodes.front() == line.nodes.back();
    if (closed) line.points.pop_back(), line.nodes.pop_back(), line.at.pop_back();
    out_.lines.push_back({Polyline<Vec2>(line.points, closed), line.nodes, line.at});
  }

  /// Carries the line on along an edge.
  void append(CrestWalk& line, Index e, bool backward) const {
    std::vector<Vec2> points = layout_.edges[e].points;
    NodeRow nodes = edge_nodes_[e];
    std::vector<double> at = edge_at_[e];
    const double length = at.back(), before = line.at.empty() ? 0 : line.at.back();
    if (backward) {
      std::reverse(points.begin(), points.end());
      std::reverse(nodes.begin(), nodes.end());
      std::reverse(at.begin(), at.end());
      for (double& a : at) a = length - a;
    }
    const bool first = line.nodes.empty();
    line.points.insert(line.points.end(), points.begin() + !first, points.end());
    line.nodes.insert(line.nodes.end(), nodes.begin() + !first, nodes.end());
    for (size_t i = !first; i < at.size(); ++i) line.at.push_back(before + at[i]);
  }

  Index next_ridge(Index vertex, const std::vector<bool>& used) const {
    if (layout_.vertices[vertex].on_boundary || freedom_of_vertex(vertex) != NodeFreedom::sliding)
      return no_index;
    for (Index e = 0; e < Index(layout_.edges.size()); ++e) {
      const VirtualEdge& edge = layout_.edges[e];
      if (edge.kind == VirtualEdgeKind::ridge && !used[e] && (edge.start == vertex || edge.end == vertex))
        return e;
    }
    return no_index;
  }

  const BlockLayout& layout_;
  const SurfaceMap& map_;
  std::vector<Index> vertex_node_;
  std::vector<NodeRow> edge_nodes_;
  std::vector<std::vector<double>> edge_at_;  ///< flat arc length of the nodes of every edge
  BeadMesh out_;
};

}  // namespace

std::vector<double> edge_lengths(const BlockLayout& layout, const SurfaceMap& map) {
  std::vector<double> lengths;
  for (const VirtualEdge& edge : layout.edges) lengths.push_back(SurfacePolyline(edge.points, map).length());
  return lengths;
}

BeadMesh map_blocks(const BlockLayout& layout, const SurfaceMap& map) {
  return BlockMapper(layout, map).run();
}

}  // namespace beadmesh
