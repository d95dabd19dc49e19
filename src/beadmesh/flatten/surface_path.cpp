#include "beadmesh/flatten/surface_path.h"

#include <algorithm>
#include <array>
#include <limits>
#include <queue>
#include <utility>

namespace beadmesh {
namespace {

constexpr int stops_an_edge = 5;        // between its ends; more only straighten what is drawn straight later
constexpr int most_sweeps = 4000;       // of the straightening; a sweep costs a few operations a stop
constexpr double still = 1e-9;          // of the edge: the stops have come to rest
constexpr double shy_of_vertex = 0.02;  // a stop keeps this part of its edge away from the ends: no slivers

/// Vertices first, then the stops of each edge, in the order of the edges.
class StopGraph {
 public:
  explicit StopGraph(const Facets& facets) : facets_(facets) {
    for (const Triangle& t : facets.triangles)
      for (int k = 0; k < 3; ++k) edges_.push_back(std::minmax(t[k], t[(k + 1) % 3]));
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    list_triangles();
    mark_boundary();
  }

  Index size() const { return vertices() + stops_an_edge * static_cast<Index>(edges_.size()); }

  PathStop stop(Index node) const {
    if (node < vertices()) return {node, node, 0};
    const Index e = (node - vertices()) / stops_an_edge, k = (node - vertices()) % stops_an_edge;
    return {edges_[e].first, edges_[e].second, (k + 1.0) / (stops_an_edge + 1)};
  }

  Vec3 point(Index node) const {
    const PathStop s = stop(node);
    return lerp(facets_.points[s.from], facets_.points[s.to], s.at);
  }

  bool on_boundary(Index node) const { return node < vertices() ? boundary_[node] : false; }

  /// Visits the nodes on the triangles at `node`, but not along an edge that is not a whole one.
  template <class Visit>
  void for_each_neighbour(Index node, Visit visit) const {
    const PathStop here = stop(node);
    const Index at = here.is_vertex() ? node : vertices() + edge_index({here.from, here.to});
    for (Index i = begin_[at]; i < begin_[at + 1]; ++i) {
      const Triangle& t = facets_.triangles[items_[i]];
      for (int k = 0; k < 3; ++k) {
        const bool on_my_edge = t[k] == here.from || t[k] == here.to;
        if (t[k] != node && (here.is_vertex() || !on_my_edge)) visit(t[k]);
        const std::pair<Index, Index> edge = std::minmax(t[k], t[(k + 1) % 3]);
        const bool touches = here.is_vertex() ? edge.first == node || edge.second == node
                                              : edge == std::pair{here.from, here.to};
        if (touches) continue;
        const Index first = vertices() + stops_an_edge * edge_index(edge);
        for (int s = 0; s < stops_an_edge; ++s) visit(first + s);
      }
    }
  }

 private:
  Index vertices() const { return static_cast<Index>(facets_.points.size()); }

  Index edge_index(std::pair<Index, Index> edge) const {
    return static_cast<Index>(std::lower_bound(edges_.begin(), edges_.end(), edge) - edges_.begin());
  }

  /// Triangles at each vertex, then at each edge.
  void list_triangles() {
    begin_.assign(vertices() + edges_.size() + 1, 0);
    const auto for_each_place = [&](auto visit) {
      for (Index t = 0; t < static_cast<Index>(facets_.triangles.size()); ++t)
        for (int k = 0; k < 3; ++k) {
          const Triangle& v = facets_.triangles[t];
          visit(v[k], t);
          visit(vertices() + edge_index(std::minmax(v[k], v[(k + 1) % 3])), t);
        }
    };
    for_each_place([&](Index place, Index) { ++begin_[place + 1]; });
    for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    items_.resize(begin_.back());
    std::vector<Index> next(begin_.begin(), begin_.end() - 1);
    for_each_place([&](Index place, Index t) { items_[next[place]++] = t; });
  }

  void mark_boundary() {
    boundary_.assign(facets_.points.size(), false);
    for (const auto& loop : facets_.loops)
      for (const Index v : loop) boundary_[v] = true;
  }

  const Facets& facets_;
  std::vector<std::pair<Index, Index>> edges_;
  std::vector<Index> begin_, items_;
  std::vector<bool> boundary_;
};

/// Nodes from a source to a target; `avoid_boundary`: vertices of loops only at the ends.
std::vector<Index> dijkstra(const StopGraph& graph, const std::vector<Index>& sources,
                            const std::vector<Index>& targets, bool avoid_boundary) {
  std::vector<double> far(graph.size(), std::numeric_limits<double>::infinity());
  std::vector<Index> before(graph.size(), no_index);
  std::vector<bool> is_target(graph.size(), false);
  for (const Index t : targets) is_target[t] = true;
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const Index s : sources) far[s] = 0, queue.push({0, s});
  while (!queue.empty()) {
    const auto [d, node] = queue.top();
    queue.pop();
    if (d > far[node]) continue;
    if (is_target[node]) {
      std::vector<Index> nodes{node};
      while (before[nodes.back()] != no_index) nodes.push_back(before[nodes.back()]);
      std::reverse(nodes.begin(), nodes.end());
      return nodes;
    }
    const Vec3 here = graph.point(node);
    graph.for_each_neighbour(node, [&](Index next) {
      if (avoid_boundary && graph.on_boundary(next) && !is_target[next]) return;
      const double length = d + distance(here, graph.point(next));
      if (length < far[next]) far[next] = length, before[next] = node, queue.push({length, next});
    });
  }
  return {};
}

/// Moves every stop within its edge to where the way through its neighbours, unfolded, is straight.
void straighten(const Facets& facets, std::vector<PathStop>& way) {
  const auto point = [&](const PathStop& s) {
    return lerp(facets.points[s.from], facets.points[s.to], s.at);
  };
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double moved = 0;
    for (std::size_t i = 1; i + 1 < way.size(); ++i) {
      PathStop& stop = way[i];
      if (stop.is_vertex()) continue;
      const Vec3 origin = facets.points[stop.from], along = facets.points[stop.to] - origin;
      const double length = norm(along);
      if (!(length > 0)) continue;
      const auto place = [&](const PathStop& s) {  // along the edge and away from it
        const Vec3 d = point(s) - origin;
        return Vec2{dot(d, along) / length, norm(cross(along, d)) / length};
      };
      const Vec2 a = place(way[i - 1]), b = place(way[i + 1]);
      if (!(a.y + b.y > 0)) continue;
      const double at =
          std::clamp((a.x * b.y + b.x * a.y) / (a.y + b.y) / length, shy_of_vertex, 1 - shy_of_vertex);
      moved = std::max(moved, std::abs(at - stop.at));
      stop.at = at;
    }
    if (moved < still) return;
  }
}

}  // namespace

std::vector<PathStop> shortest_path(const Facets& facets, const std::vector<Index>& sources,
                                    const std::vector<Index>& targets) {
  const StopGraph graph(facets);
  std::vector<Index> nodes = dijkstra(graph, sources, targets, true);
  if (nodes.empty()) nodes = dijkstra(graph, sources, targets, false);
  std::vector<PathStop> way;
  for (const Index node : nodes) way.push_back(graph.stop(node));
  straighten(facets, way);
  return way;
}

Index farthest_vertex(const Facets& facets, const std::vector<Index>& sources) {
  std::vector<std::vector<Index>> neighbours(facets.points.size());
  for (const Triangle& t : facets.triangles)
    for (int k = 0; k < 3; ++k) {
      neighbours[t[k]].push_back(t[(k + 1) % 3]);
      neighbours[t[(k + 1) % 3]].push_back(t[k]);
    }
  std::vector<double> far(facets.points.size(), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const Index s : sources) far[s] = 0, queue.push({0, s});
  Index last = no_index;
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > far[v]) continue;
    last = v;
    for (const Index n : neighbours[v]) {
      const double length = d + distance(facets.points[v], facets.points[n]);
      if (length < far[n]) far[n] = length, queue.push({length, n});
    }
  }
  return last;
}

}  // namespace beadmesh
