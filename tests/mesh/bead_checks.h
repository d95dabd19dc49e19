// What holds for every bead mesh, whatever method made it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include "bead/studied_bead.h"
#include "beadmesh/blocking/block_layout.h"
#include "beadmesh/mesh/bead_mesh.h"
#include "beadmesh/mesh/element_quality.h"

namespace beadmesh::shapes {

inline std::vector<Vec3> lifted_nodes(const PlanarMesh& mesh, const FaceStudy& study) {
  std::vector<Vec3> nodes;
  for (const Vec2 p : mesh.nodes) nodes.push_back(study.lift(p));
  return nodes;
}

inline QualitySummary quality_of(const BeadMesh& bead, const FaceStudy& study, double min_edge = 2.5) {
  return summarise(lifted_nodes(bead.mesh, study), bead.mesh.elements, min_edge);
}

inline std::set<std::pair<Index, Index>> directed_edges(const PlanarMesh& mesh) {
  std::set<std::pair<Index, Index>> edges;
  for (const MeshElement& element : mesh.elements)
    for (int k = 0; k < corner_count(element); ++k) {
      const auto edge = std::pair{element[k], element[(k + 1) % corner_count(element)]};
      EXPECT_NE(edge.first, edge.second);
      EXPECT_TRUE(edges.insert(edge).second) << "edge " << edge.first << " -> " << edge.second << " twice";
    }
  return edges;
}

/// The boundary nodes of the mesh by loop, in the order of their positions.
inline NodeLoops loops_of(const BeadMesh& bead, const PlanarRegion& region) {
  NodeLoops loops{bead.mesh.nodes, std::vector<std::vector<Index>>(region.loops.size())};
  std::vector<std::vector<std::pair<double, Index>>> sorted(region.loops.size());
  for (const BoundaryNode& node : bead.boundary)
    sorted[node.at.loop].emplace_back(node.at.position, node.node);
  const BlockLayoutBuilder boundary(region);
  for (size_t l = 0; l < sorted.size(); ++l) {
    for (auto& [at, node] : sorted[l]) {
      at = std::fmod(at, boundary.loop_length(Index(l)));
      if (at < 0) at += boundary.loop_length(Index(l));
    }
    std::sort(sorted[l].begin(), sorted[l].end());
    for (const auto& [at, node] : sorted[l]) loops.loops[l].push_back(node);
  }
  return loops;
}

/// Topology, boundary and crest: quads only, the boundary nodes where they say and an even number a loop,
/// crest lines made of element edges.
inline void expect_sound(const BeadMesh& bead, const FaceStudy& study) {
  const NodeLoops loops = loops_of(bead, study.region);
  for (const auto& loop : loops.loops) EXPECT_EQ(loop.size() % 2, 0);
  const std::set<Index> once = [&] {
    std::set<Index> nodes;
    for (const BoundaryNode& node : bead.boundary) nodes.insert(node.node);
    return nodes;
  }();
  EXPECT_EQ(once.size(), bead.boundary.size()) << "every boundary node once";
  const BlockLayoutBuilder boundary(study.region);
  for (const BoundaryNode& node : bead.boundary) {
    EXPECT_LT(distance(boundary.point_at(node.at), bead.mesh.nodes[node.node]), 1e-6);
    EXPECT_EQ(bead.mesh.freedom[node.node], NodeFreedom::fixed);
  }
  for (const MeshElement& element : bead.mesh.elements) EXPECT_TRUE(is_quad(element));
  const auto edges = directed_edges(bead.mesh);
  for (const auto& line : bead.crest_lines)
    for (size_t i = 1; i < line.size(); ++i)
      EXPECT_TRUE(edges.contains({line[i - 1], line[i]}) || edges.contains({line[i], line[i - 1]}))
          << "crest edge " << i;
  EXPECT_EQ(verify_planar_mesh(bead.mesh, loops), std::vector<std::string>{});
}

inline double crest_length(const BeadMesh& bead, const std::vector<Vec3>& nodes) {
  double length = 0;
  for (const auto& line : bead.crest_lines)
    for (size_t i = 1; i < line.size(); ++i) length += distance(nodes[line[i - 1]], nodes[line[i]]);
  return length;
}

}  // namespace beadmesh::shapes
