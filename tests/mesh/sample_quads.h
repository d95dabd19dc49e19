// Quad meshes with known answers for the tests of the mesh room.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "beadmesh/mesh/element_quality.h"
#include "beadmesh/mesh/planar_mesh.h"

namespace beadmesh::sample {

/// Small linear congruential generator: the same numbers on every platform.
class Noise {
 public:
  explicit Noise(std::uint32_t seed) : state_(seed) {}
  /// In [-1, 1].
  double next() {
    state_ = state_ * 1664525u + 1013904223u;
    return static_cast<double>(state_ >> 8) / 8388608.0 - 1.0;
  }

 private:
  std::uint32_t state_;
};

inline std::set<std::pair<Index, Index>> directed_edges(const PlanarMesh& mesh) {
  std::set<std::pair<Index, Index>> edges;
  for (const MeshElement& element : mesh.elements)
    for (int i = 0; i < corner_count(element); ++i)
      edges.insert({element[i], element[(i + 1) % corner_count(element)]});
  return edges;
}

/// The boundary of a mesh as loops; the outer one need not be the first.
inline NodeLoops loops_of(const PlanarMesh& mesh) {
  const auto edges = directed_edges(mesh);
  std::map<Index, Index> next;
  for (const auto& [a, b] : edges)
    if (!edges.contains({b, a})) next[a] = b;
  NodeLoops loops{mesh.nodes, {}};
  while (!next.empty()) {
    std::vector<Index> loop;
    for (auto at = next.begin(); at != next.end(); at = next.find(loop.empty() ? 0 : loop.back())) {
      loop.push_back(at->second);
      next.erase(at);
    }
    loops.loops.push_back(loop);
  }
  return loops;
}

inline void fix_boundary(PlanarMesh& mesh) {
  mesh.freedom.assign(mesh.nodes.size(), NodeFreedom::free);
  for (const std::vector<Index>& loop : loops_of(mesh).loops)
    for (const Index node : loop) mesh.freedom[node] = NodeFreedom::fixed;
}

/// columns x rows squares of side `size`; node (i, j) is j * (columns + 1) + i.
inline PlanarMesh grid(int columns, int rows, double size) {
  PlanarMesh mesh;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) mesh.nodes.push_back({size * i, size * j});
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const Index a = j * (columns + 1) + i;
      mesh.elements.push_back({a, a + 1, a + columns + 2, a + columns + 1});
    }
  fix_boundary(mesh);
  return mesh;
}

/// Moves free nodes by up to `amount` in x and y.
inline void shake(PlanarMesh& mesh, double amount, std::uint32_t seed) {
  Noise noise(seed);
  for (size_t i = 0; i < mesh.nodes.size(); ++i)
    if (mesh.freedom[i] == NodeFreedom::free)
      mesh.nodes[i] += Vec2{amount * noise.next(), amount * noise.next()};
}

/// A square of cells x cells triangle pairs, every triangle cut into three quads: as irregular as quads get.
inline PlanarMesh cut_triangles(int cells, double size) {
  const PlanarMesh base = grid(cells, cells, size);
  PlanarMesh mesh{base.nodes, {}, {}};
  std::map<std::pair<Index, Index>, Index> middles;
  const auto add = [&](Vec2 position) {
    mesh.nodes.push_back(position);
    return static_cast<Index>(mesh.nodes.size()) - 1;
  };
  const auto middle = [&](Index a, Index b) {
    const auto [at, fresh] = middles.try_emplace(std::minmax(a, b), 0);
    if (fresh) at->second = add((mesh.nodes[a] + mesh.nodes[b]) / 2);
    return at->second;
  };
  for (const MeshElement& cell : base.elements)
    for (const Triangle& t : {Triangle{cell[0], cell[1], cell[2]}, Triangle{cell[0], cell[2], cell[3]}}) {
      const Index ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      const Index centre = add((mesh.nodes[t[0]] + mesh.nodes[t[1]] + mesh.nodes[t[2]]) / 3);
      mesh.elements.push_back({t[0], ab, centre, ca});
      mesh.elements.push_back({t[1], bc, centre, ab});
      mesh.elements.push_back({t[2], ca, centre, bc});
    }
  fix_boundary(mesh);
  return mesh;
}

inline std::vector<Vec3> lifted(const PlanarMesh& mesh) {
  std::vector<Vec3> nodes;
  for (const Vec2 p : mesh.nodes) nodes.push_back({p.x, p.y, 0});
  return nodes;
}

inline double worst_jacobian(const PlanarMesh& mesh) {
  const std::vector<Vec3> nodes = lifted(mesh);
  double worst = 1;
  for (const MeshElement& e : mesh.elements) worst = std::min(worst, scaled_jacobian(nodes, e));
  return worst;
}

}  // namespace beadmesh::sample
