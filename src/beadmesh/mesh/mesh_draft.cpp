#include "beadmesh/mesh/mesh_draft.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {

MeshDraft::MeshDraft(const NodeLoops& loops, const SurfaceMap* map, double size) : map_(map), size_(size) {
  nodes_.reserve(4 * loops.nodes.size());
  metrics_.reserve(4 * loops.nodes.size());
  edges_.reserve(8 * loops.nodes.size());
  for (const Vec2& node : loops.nodes) add_node(node);
  fixed_nodes_ = static_cast<Index>(nodes_.size());
  std::vector<double> sum(nodes_.size(), 0);
  std::vector<int> count(nodes_.size(), 0);
  for (const auto& loop : loops.loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index a = loop[i], b = loop[(i + 1) % loop.size()];
      const double length = surface_length(a, b);
      add_edge(a, b);
      sum[a] += length, sum[b] += length;
      ++count[a], ++count[b];
    }
  }
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (count[i] > 0) spacing_[i] = std::clamp(sum[i] / count[i], 0.3 * size, 3 * size);
  }
}

MeshDraft::MeshDraft(const MeshDraft& whole, std::vector<Index> nodes)
    : map_(whole.map_), size_(whole.size_), whole_(&whole), of_whole_(std::move(nodes)), hint_(whole.hint_) {
  for (const Index node : of_whole_) {
    fixed_nodes_ += node < whole.fixed_nodes_;
    nodes_.push_back(whole.nodes_[node]);
    metrics_.push_back(whole.metrics_[node]);
    spacing_.push_back(whole.spacing_[node]);
    valences_.push_back(whole.valences_[node]);
  }
}

SurfaceMetric MeshDraft::sample(Vec2 position) {
  if (!map_) return {};
  const FacetPoint at = map_->locate(position, hint_);
  hint_ = at.triangle;
  const double diagonal = std::sqrt(0.5);
  const double x = map_->stretch(at, {1, 0}), y = map_->stretch(at, {0, 1});
  const double d = map_->stretch(at, {diagonal, diagonal});
  return {x * x, d * d - 0.5 * (x * x + y * y), y * y};
}

Index MeshDraft::add_node(Vec2 position) {
  nodes_.push_back(position);
  metrics_.push_back(sample(position));
  spacing_.push_back(size_);
  valences_.push_back(0);
  return static_cast<Index>(nodes_.size() - 1);
}

void MeshDraft::add_element(const MeshElement& element) {
  const int corners = is_quad(element) ? 4 : 3;
  for (int i = 0; i < corners; ++i) {
    add_edge(element[i], element[(i + 1) % corners]);
    ++valences_[element[i]];
  }
  elements_.push_back(element);
}

double MeshDraft::surface_length(Index a, Index b) const {
  const Vec2 d = nodes_[b] - nodes_[a];
  const SurfaceMetric &m = metrics_[a], &n = metrics_[b];
  const double square =
      0.5 * ((m.xx + n.xx) * d.x * d.x + 2 * (m.xy + n.xy) * d.x * d.y + (m.yy + n.yy) * d.y * d.y);
  return std::sqrt(std::max(0.0, square));
}

double MeshDraft::spacing_along(Index a, Index b, double length, double at) const {
  const double reach = 3 * size_;
  const double wa = std::exp(-at / reach), wb = std::exp(-(length - at) / reach), w = 1 - std::max(wa, wb);
  return (wa * spacing_[a] + wb * spacing_[b] + w * size_) / (wa + wb + w);
}

double MeshDraft::edge_count(Index a, Index b) const {
  const double length = surface_length(a, b);
  if (spacing_[a] == size_ && spacing_[b] == size_) return length / size_;
  return length / 6 * (1 / spacing_[a] + 4 / spacing_along(a, b, length, length / 2) + 1 / spacing_[b]);
}

std::vector<Index> MeshDraft::add_line(Index a, Index b, int edges) {
  constexpr int samples = 64;
  const double length = surface_length(a, b);
  std::vector<double> counted(samples + 1, 0);  // edges from a up to each sample
  for (int i = 0; i < samples; ++i) {
    counted[i + 1] = counted[i] + 1 / spacing_along(a, b, length, length * (i + 0.5) / samples);
  }
  std::vector<Index> line{a};
  for (int k = 1, i = 0; k < edges; ++k) {
    const double wanted = counted[samples] * k / edges;
    while (i < samples - 1 && counted[i + 1] < wanted) ++i;
    const double t = (i + (wanted - counted[i]) / (counted[i + 1] - counted[i])) / samples;
    const Index node = add_node(lerp(nodes_[a], nodes_[b], t));
    spacing_[node] = spacing_along(a, b, length, t * length);
    line.push_back(node);
  }
  line.push_back(b);
  for (int k = 0; k < edges; ++k) add_edge(line[k], line[k + 1]);
  return line;
}

MeshDraft::Piece MeshDraft::take_back(const Mark& mark) {
  Piece piece;
  const auto move_tail = [](auto& all, std::size_t from, auto& tail) {
    tail.assign(all.begin() + from, all.end());
    all.resize(from);
  };
  move_tail(elements_, mark.elements, piece.elements);
  for (const MeshElement& element : piece.elements) {
    for (const Index node : element) valences_[node == no_index ? element[0] : node] -= node != no_index;
  }
  move_tail(nodes_, mark.nodes, piece.nodes);
  move_tail(metrics_, mark.nodes, piece.metrics);
  move_tail(spacing_, mark.nodes, piece.spacing);
  valences_.resize(mark.nodes);
  for (std::size_t i = mark.edges; i < edge_order_.size(); ++i) edges_.erase(edge_order_[i]);
  edge_order_.resize(mark.edges);
  return piece;
}

void MeshDraft::put(const Piece& piece) {
  nodes_.insert(nodes_.end(), piece.nodes.begin(), piece.nodes.end());
  metrics_.insert(metrics_.end(), piece.metrics.begin(), piece.metrics.end());
  spacing_.insert(spacing_.end(), piece.spacing.begin(), piece.spacing.end());
  valences_.resize(nodes_.size(), 0);
  for (const MeshElement& element : piece.elements) add_element(element);
}

void MeshDraft::put(Piece piece, const std::vector<Index>& nodes) {
  const auto given = static_cast<Index>(nodes.size());
  const Index shift = static_cast<Index>(nodes_.size()) - given;
  for (MeshElement& element : piece.elements) {
    for (Index& node : element) {
      if (node != no_index) node = node < given ? nodes[node] : node + shift;
    }
  }
  put(piece);
}

PlanarMesh MeshDraft::take() && {
  PlanarMesh mesh;
  mesh.nodes = std::move(nodes_);
  mesh.elements = std::move(elements_);
  mesh.freedom.assign(mesh.nodes.size(), NodeFreedom::free);
  std::fill_n(mesh.freedom.begin(), fixed_nodes_, NodeFreedom::fixed);
  return mesh;
}

}  // namespace beadmesh
