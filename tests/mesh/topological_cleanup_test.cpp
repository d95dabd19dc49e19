#include "beadmesh/mesh/topological_cleanup.h"

#include <gtest/gtest.h>

#include "beadmesh/mesh/element_quality.h"
#include "beadmesh/mesh/smoothing.h"
#include "mesh/sample_quads.h"

namespace beadmesh {
namespace {

QualitySummary summary_of(const PlanarMesh& mesh, double min_edge = 2.5) {
  return summarise(sample::lifted(mesh), mesh.elements, min_edge);
}

/// The loops with the node numbers after a clean-up.
NodeLoops renumbered(NodeLoops loops, const CleanupReport& report) {
  for (std::vector<Index>& loop : loops.loops)
    for (Index& node : loop) node = report.renumbered[node];
  return loops;
}

/// Cleans up, and checks what every clean-up owes: conforming, same boundary, no fixed node lost or moved.
CleanupReport clean(PlanarMesh& mesh, const CleanupOptions& options = {},
                    const std::vector<std::array<Index, 2>>& kept = {}) {
  const PlanarMesh before = mesh;
  const NodeLoops loops = sample::loops_of(mesh);
  const CleanupReport report = clean_up(mesh, nullptr, kept, options);
  for (const std::string& violation : verify_planar_mesh(mesh, renumbered(loops, report)))
    ADD_FAILURE() << violation;
  for (size_t i = 0; i < before.nodes.size(); ++i) {
    if (before.freedom[i] == NodeFreedom::free) continue;
    const Index now = report.renumbered[i];
    EXPECT_NE(now, no_index);
    if (now == no_index) continue;
    EXPECT_EQ(mesh.nodes[now], before.nodes[i]);
  }
  return report;
}

TEST(Cleanup, LeavesGridAlone) {
  PlanarMesh mesh = sample::grid(6, 6, 5.0);
  const PlanarMesh before = mesh;
  const CleanupReport report = clean(mesh);
  EXPECT_EQ(report.edits, 0);
  EXPECT_EQ(mesh.elements, before.elements);
  EXPECT_EQ(mesh.nodes, before.nodes);
}

TEST(Cleanup, RemovesDoublet) {
  PlanarMesh mesh = sample::grid(5, 5, 5.0);
  const MeshElement cell = mesh.elements[12];
  const Index inside = static_cast<Index>(mesh.nodes.size());
  mesh.nodes.push_back((mesh.nodes[cell[0]] + mesh.nodes[cell[2]]) / 2);
  mesh.freedom.push_back(NodeFreedom::free);
  mesh.elements[12] = {cell[0], cell[1], cell[2], inside};
  mesh.elements.push_back({cell[0], inside, cell[2], cell[3]});
  const CleanupReport report = clean(mesh);
  EXPECT_EQ(report.renumbered[inside], no_index);
  EXPECT_EQ(report.irregular_after, 0);
  EXPECT_EQ(mesh.elements.size(), 25u);
}

/// A quad put into the middle of an edge (a 3-5 and a 3-5 in a row) is a quad too many.
TEST(Cleanup, RemovesInsertedQuad) {
  PlanarMesh mesh = sample::grid(6, 6, 5.0);
  const Index middle = 24, copy = static_cast<Index>(mesh.nodes.size());
  mesh.nodes.push_back(mesh.nodes[middle] + Vec2{0, 1.5});
  mesh.nodes[middle] += Vec2{0, -1.5};
  mesh.freedom.push_back(NodeFreedom::free);
  for (MeshElement& element : mesh.elements)
    if (element[0] == middle || element[1] == middle)
      for (Index& corner : element)
        if (corner == middle) corner = copy;
  mesh.elements.push_back({middle, middle + 1, copy, middle - 1});
  ASSERT_EQ(summary_of(mesh).irregular, 4);
  const CleanupReport report = clean(mesh);
  EXPECT_EQ(report.irregular_after, 0);
  EXPECT_EQ(mesh.elements.size(), 36u);
}

TEST(Cleanup, MarriesNeighbouringTriangles) {
  PlanarMesh mesh = sample::grid(4, 4, 5.0);
  const MeshElement cell = mesh.elements[5];
  mesh.elements[5] = {cell[0], cell[1], cell[2], no_index};
  mesh.elements.push_back({cell[0], cell[2], cell[3], no_index});
  const CleanupReport report = clean(mesh);
  EXPECT_EQ(report.trias_before, 2);
  EXPECT_EQ(report.trias_after, 0);
  EXPECT_EQ(report.irregular_after, 0);
}

/// A strip of pentagon cuts: two triangles with four quads between them.
TEST(Cleanup, MarriesTrianglesThroughQuads) {
  PlanarMesh mesh = sample::grid(8, 6, 5.0);
  const auto node = [](int i, int j) { return Index(j * 9 + i); };
  const auto cell = [](int i, int j) { return size_t(j * 8 + i); };
  mesh.elements[cell(2, 2)] = {node(2, 2), node(3, 2), node(2, 3), no_index};
  for (int i = 3; i <= 5; ++i)
    mesh.elements[cell(i, 2)] = {node(i, 2), node(i + 1, 2), node(i, 3), node(i - 1, 3)};
  mesh.elements.push_back({node(6, 2), node(6, 3), node(5, 3), no_index});
  ASSERT_TRUE(verify_planar_mesh(mesh, sample::loops_of(sample::grid(8, 6, 5.0))).empty());
  const CleanupReport report = clean(mesh);
  EXPECT_EQ(report.trias_after, 0);
  EXPECT_EQ(report.irregular_after, 0);
}

TEST(Cleanup, LonelyTriangleStays) {
  PlanarMesh mesh = sample::grid(4, 4, 5.0);
  const MeshElement corner = mesh.elements[0];
  mesh.elements[0] = {corner[1], corner[2], corner[3], no_index};
  mesh.nodes.erase(mesh.nodes.begin());
  mesh.freedom.erase(mesh.freedom.begin());
  for (MeshElement& element : mesh.elements)
    for (Index& node : element)
      if (node != no_index) --node;
  sample::fix_boundary(mesh);
  const CleanupReport report = clean(mesh);
  EXPECT_EQ(report.trias_after, 1);
}

TEST(Cleanup, MakesCutTrianglesNearlyRegular) {
  PlanarMesh mesh = sample::cut_triangles(12, 10);
  CleanupOptions options;
  options.size = 4.5;
  options.min_edge = 2.2;
  const CleanupReport report = clean(mesh, options);
  EXPECT_GT(report.irregular_before, 300);
  EXPECT_LT(report.irregular_after, 40);
  EXPECT_EQ(report.irregular_after, summary_of(mesh).irregular);
  SmoothingOptions smoothing;
  smoothing.size = 4.5;
  smoothing.min_edge = 2.2;
  smooth(mesh, nullptr, smoothing);
  const QualitySummary summary = summary_of(mesh, 2.2);
  EXPECT_EQ(summary.edges_below_min, 0);
  EXPECT_GT(summary.scaled_jacobian_min, 0.6);
  EXPECT_GT(summary.scaled_jacobian_mean, 0.94);
}

TEST(Cleanup, KeepsKeptEdges) {
  PlanarMesh mesh = sample::cut_triangles(8, 10);
  // The middle line y = 40 of the square, edge by edge.
  std::vector<Index> line;
  for (size_t i = 0; i < mesh.nodes.size(); ++i)
    if (std::abs(mesh.nodes[i].y - 40) < 1e-9) line.push_back(static_cast<Index>(i));
  std::sort(line.begin(), line.end(), [&](Index a, Index b) { return mesh.nodes[a].x < mesh.nodes[b].x; });
  std::vector<std::array<Index, 2>> kept;
  for (size_t i = 1; i < line.size(); ++i) kept.push_back({line[i], line[i - 1]});
  for (const Index node : line) mesh.freedom[node] = NodeFreedom::fixed;
  ASSERT_EQ(kept.size(), 16u);
  CleanupOptions options;
  options.size = 4.5;
  const CleanupReport report = clean(mesh, options, kept);
  EXPECT_LT(report.irregular_after, report.irregular_before / 2);
  const auto edges = sample::directed_edges(mesh);
  for (const auto& [a, b] : kept) EXPECT_TRUE(edges.contains({report.renumbered[a], report.renumbered[b]}));
}

TEST(Cleanup, WorksAroundHole) {
  PlanarMesh mesh = sample::cut_triangles(10, 10);
  std::erase_if(mesh.elements, [&](const MeshElement& element) {
    const Vec2 centre = (mesh.nodes[element[0]] + mesh.nodes[element[2]]) / 2;
    return centre.x > 40 && centre.x < 60 && centre.y > 40 && centre.y < 60;
  });
  // Nodes inside the hole go.
  std::vector<Index> number(mesh.nodes.size(), no_index);
  PlanarMesh holed;
  for (MeshElement element : mesh.elements) {
    for (Index& node : element) {
      if (number[node] == no_index) {
        number[node] = static_cast<Index>(holed.nodes.size());
        holed.nodes.push_back(mesh.nodes[node]);
      }
      node = number[node];
    }
    holed.elements.push_back(element);
  }
  sample::fix_boundary(holed);
  CleanupOptions options;
  options.size = 4.5;
  options.min_edge = 2.2;
  const CleanupReport report = clean(holed, options);
  EXPECT_LT(report.irregular_after, report.irregular_before / 4);
}

/// Two nodes of a quad closer than the minimum, held there by fixed nodes: only an edit helps.
TEST(Cleanup, TakesOutShortEdges) {
  PlanarMesh mesh = sample::grid(6, 6, 5.0);
  for (size_t i = 0; i < mesh.nodes.size(); ++i)
    if (mesh.freedom[i] == NodeFreedom::free) mesh.nodes[i].x = 15 + (mesh.nodes[i].x - 15) * 0.3;
  CleanupOptions options;
  options.min_edge = 2.5;
  ASSERT_GT(summary_of(mesh).edges_below_min, 0);
  clean(mesh, options);
  SmoothingOptions smoothing;
  EXPECT_EQ(smooth(mesh, nullptr, smoothing).edges_below_min, 0);
}

TEST(Cleanup, IsDeterministic) {
  PlanarMesh first = sample::cut_triangles(8, 10), second = first;
  clean(first);
  clean(second);
  EXPECT_EQ(first.elements, second.elements);
  EXPECT_EQ(first.nodes, second.nodes);
}

/// Nodes thrown far over their neighbours: must end, and must not make more of it.
TEST(Cleanup, EndsOnTangledMesh) {
  PlanarMesh mesh = sample::grid(14, 14, 5.0);
  sample::shake(mesh, 20, 11);
  clean(mesh);
  EXPECT_LT(mesh.elements.size(), 300u);
}

/// Both guards at once: elements so flat and edges so short that no edit can satisfy them.
TEST(Cleanup, EndsWhereGoalsCannotBeMet) {
  PlanarMesh mesh = sample::grid(12, 12, 1.0);
  for (Vec2& node : mesh.nodes) node.x += 3 * node.y;
  clean(mesh);
}

TEST(Cleanup, SurvivesEmptyMeshAndOneQuad) {
  PlanarMesh empty;
  EXPECT_EQ(clean_up(empty, nullptr, {}).edits, 0);
  PlanarMesh one = sample::grid(1, 1, 5.0);
  EXPECT_EQ(clean(one).edits, 0);
}

}  // namespace
}  // namespace beadmesh
