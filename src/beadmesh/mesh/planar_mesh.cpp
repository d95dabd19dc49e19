#include "beadmesh/mesh/planar_mesh.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace beadmesh {
namespace {

using DirectedEdge = std::pair<Index, Index>;

/// Collects violations: one line a kind, with the first culprit and the number of them.
class Violations {
 public:
  void add(const std::string& kind, const std::string& culprit) {
    for (Entry& entry : entries_)
      if (entry.kind == kind) {
        ++entry.count;
        return;
      }
    entries_.push_back({kind, culprit, 1});
  }
  std::vector<std::string> lines() const {
    std::vector<std::string> lines;
    for (const Entry& entry : entries_)
      lines.push_back(entry.kind + ": " + entry.culprit +
                      (entry.count > 1 ? " and " + std::to_string(entry.count - 1) + " more" : ""));
    return lines;
  }

 private:
  struct Entry {
    std::string kind, culprit;
    int count;
  };
  std::vector<Entry> entries_;
};

std::string text_of(DirectedEdge edge) {
  return "edge " + std::to_string(edge.first) + "-" + std::to_string(edge.second);
}

/// True where every corner is a node and none is used twice.
bool check_elements(const PlanarMesh& mesh, Violations& violations) {
  bool sound = true;
  std::vector<MeshElement> sorted;
  for (Index e = 0; e < mesh.elements.size(); ++e) {
    MeshElement corners = mesh.elements[e];
    const int count = corner_count(corners);
    for (int i = 0; i < count; ++i)
      if (corners[i] < 0 || corners[i] >= mesh.nodes.size()) {
        violations.add("corner is no node", "element " + std::to_string(e));
        return false;
      }
    std::sort(corners.begin(), corners.begin() + count);
    if (std::adjacent_find(corners.begin(), corners.begin() + count) != corners.begin() + count) {
      violations.add("collapsed element", "element " + std::to_string(e));
      sound = false;
    }
    sorted.push_back(corners);
  }
  std::sort(sorted.begin(), sorted.end());
  const auto repeated = std::adjacent_find(sorted.begin(), sorted.end());
  if (repeated != sorted.end())
    violations.add("repeated element", "at node " + std::to_string((*repeated)[0]));
  return sound;
}

std::vector<DirectedEdge> directed_edges(const PlanarMesh& mesh) {
  std::vector<DirectedEdge> edges;
  edges.reserve(4 * mesh.elements.size());
  for (const MeshElement& element : mesh.elements) {
    const int count = corner_count(element);
    for (int i = 0; i < count; ++i) edges.emplace_back(element[i], element[(i + 1) % count]);
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

bool contains(const std::vector<DirectedEdge>& sorted, DirectedEdge edge) {
  return std::binary_search(sorted.begin(), sorted.end(), edge);
}

/// Edges without a twin in the other direction.
std::vector<DirectedEdge> one_sided(const std::vector<DirectedEdge>& sorted) {
  std::vector<DirectedEdge> result;
  for (const DirectedEdge& edge : sorted)
    if (!contains(sorted, {edge.second, edge.first})) result.push_back(edge);
  return result;
}

struct LoopEdges {
  std::vector<DirectedEdge> all, boundary;  ///< sorted; boundary: without scar edges
  int loops = 0;                            ///< loops that are more than a scar
};

LoopEdges edges_of(const NodeLoops& loops) {
  LoopEdges edges;
  for (const std::vector<Index>& loop : loops.loops)
    for (size_t i = 0; i < loop.size(); ++i) edges.all.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
  std::sort(edges.all.begin(), edges.all.end());
  edges.boundary = one_sided(edges.all);
  for (const std::vector<Index>& loop : loops.loops)
    for (size_t i = 0; i < loop.size(); ++i)
      if (contains(edges.boundary, {loop[i], loop[(i + 1) % loop.size()]})) {
        ++edges.loops;
        break;
      }
  return edges;
}

void check_boundary(const std::vector<DirectedEdge>& edges, const LoopEdges& loops, Violations& violations) {
  const std::vector<DirectedEdge> boundary = one_sided(edges);
  for (const DirectedEdge& edge : boundary)
    if (!contains(loops.boundary, edge)) violations.add("boundary edge that is in no loop", text_of(edge));
  for (const DirectedEdge& edge : loops.boundary)
    if (!contains(boundary, edge)) violations.add("loop edge that is no boundary edge", text_of(edge));
  for (const DirectedEdge& edge : loops.all)
    if (!contains(edges, edge)) violations.add("loop edge that the mesh does not have", text_of(edge));
}

int count_pieces(const PlanarMesh& mesh, const std::vector<DirectedEdge>& edges) {
  std::vector<Index> parent(mesh.nodes.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](Index i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  int pieces = static_cast<int>(mesh.nodes.size());
  for (const auto& [a, b] : edges) {
    const Index ra = root(a), rb = root(b);
    if (ra == rb) continue;
    parent[ra] = rb;
    --pieces;
  }
  return pieces;
}

}  // namespace

std::vector<std::string> verify_planar_mesh(const PlanarMesh& mesh, const NodeLoops& loops) {
  Violations violations;
  if (mesh.freedom.size() != mesh.nodes.size())
    violations.add("freedom is not given per node", std::to_string(mesh.freedom.size()) + " entries");
  if (mesh.elements.empty()) violations.add("no element", "empty mesh");
  if (!check_elements(mesh, violations)) return violations.lines();

  const std::vector<DirectedEdge> edges = directed_edges(mesh);
  for (size_t i = 1; i < edges.size(); ++i)
    if (edges[i] == edges[i - 1])
      violations.add("edge used twice in one direction (orientation, or more than two elements)",
                     text_of(edges[i]));

  std::vector<bool> used(mesh.nodes.size(), false);
  for (const DirectedEdge& edge : edges) used[edge.first] = true;
  for (Index node = 0; node < mesh.nodes.size(); ++node)
    if (!used[node]) violations.add("unused node", "node " + std::to_string(node));

  const LoopEdges loop_edges = edges_of(loops);
  check_boundary(edges, loop_edges, violations);

  const int pieces = count_pieces(mesh, edges);
  if (pieces > 1) violations.add("mesh in pieces", std::to_string(pieces) + " pieces");
  const std::int64_t edge_count = static_cast<std::int64_t>(edges.size() + one_sided(edges).size()) / 2;
  const std::int64_t euler = static_cast<std::int64_t>(mesh.nodes.size() + mesh.elements.size()) - edge_count;
  if (euler != 2 - loop_edges.loops)
    violations.add("Euler's formula does not hold", "V - E + F = " + std::to_string(euler) + " with " +
                                                        std::to_string(loop_edges.loops) + " loops");
  return violations.lines();
}

}  // namespace beadmesh
