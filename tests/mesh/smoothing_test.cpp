#include "beadmesh/mesh/smoothing.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "beadmesh/mesh/element_quality.h"
#include "mesh/sample_quads.h"

namespace beadmesh {
namespace {

TEST(Smoothing, LeavesPerfectGridAlone) {
  PlanarMesh mesh = sample::grid(6, 6, 5.0);
  const PlanarMesh before = mesh;
  const SmoothingReport report = smooth(mesh, nullptr);
  EXPECT_EQ(mesh.nodes, before.nodes);
  EXPECT_NEAR(report.scaled_jacobian_min, 1, 1e-12);
  EXPECT_EQ(report.edges_below_min, 0);
}

TEST(Smoothing, BringsShakenGridBack) {
  PlanarMesh mesh = sample::grid(12, 12, 5.0);
  const PlanarMesh perfect = mesh;
  sample::shake(mesh, 2.2, 7);
  const SmoothingReport report = smooth(mesh, nullptr);
  EXPECT_GT(report.scaled_jacobian_min, 0.95);
  for (size_t i = 0; i < mesh.nodes.size(); ++i) EXPECT_LT(distance(mesh.nodes[i], perfect.nodes[i]), 1.0);
}

TEST(Smoothing, UntanglesCompletelyTangledGrid) {
  PlanarMesh mesh = sample::grid(12, 12, 5.0);
  sample::shake(mesh, 12, 3);
  ASSERT_GT(summarise(sample::lifted(mesh), mesh.elements, 2.5).inverted, 50);
  const SmoothingReport report = smooth(mesh, nullptr);
  EXPECT_EQ(report.inverted, 0);
  EXPECT_EQ(report.edges_below_min, 0);
  EXPECT_GT(report.scaled_jacobian_min, 0.6);
}

TEST(Smoothing, DoesNotMoveFixedNodes) {
  PlanarMesh mesh = sample::grid(6, 6, 5.0);
  sample::shake(mesh, 2, 5);
  mesh.freedom[24] = NodeFreedom::fixed;
  const PlanarMesh before = mesh;
  smooth(mesh, nullptr);
  for (size_t i = 0; i < mesh.nodes.size(); ++i)
    if (mesh.freedom[i] == NodeFreedom::fixed) {
      EXPECT_EQ(mesh.nodes[i], before.nodes[i]);
    }
}

TEST(Smoothing, LengthensShortEdges) {
  PlanarMesh mesh = sample::grid(6, 6, 5.0);
  mesh.nodes[24] += Vec2{4.4, 0};  // leaves 0.6 to its neighbour
  ASSERT_GT(summarise(sample::lifted(mesh), mesh.elements, 2.5).edges_below_min, 0);
  const SmoothingReport report = smooth(mesh, nullptr);
  EXPECT_EQ(report.edges_below_min, 0);
  EXPECT_EQ(summarise(sample::lifted(mesh), mesh.elements, 2.5).edges_below_min, 0);
}

/// Guard: no mesh may come out with more short edges, or a worse worst element, than it went in with.
TEST(Smoothing, NeverMakesItWorse) {
  for (std::uint32_t seed = 1; seed <= 12; ++seed) {
    PlanarMesh mesh = sample::cut_triangles(5, 10);
    sample::shake(mesh, 0.15 * seed, seed);
    const QualitySummary before = summarise(sample::lifted(mesh), mesh.elements, 1.2);
    SmoothingOptions options;
    options.min_edge = 1.2;
    const SmoothingReport report = smooth(mesh, nullptr, options);
    EXPECT_LE(report.edges_below_min, before.edges_below_min);
    if (before.edges_below_min == 0) {
      EXPECT_GE(report.scaled_jacobian_min, before.scaled_jacobian_min);
    }
  }
}

TEST(Smoothing, ReportsWhatSummaryFinds) {
  PlanarMesh mesh = sample::cut_triangles(6, 10);
  const SmoothingReport report = smooth(mesh, nullptr);
  const QualitySummary summary = summarise(sample::lifted(mesh), mesh.elements, 2.5);
  EXPECT_NEAR(report.scaled_jacobian_min, summary.scaled_jacobian_min, 1e-9);
  EXPECT_NEAR(report.scaled_jacobian_mean, summary.scaled_jacobian_mean, 1e-9);
  EXPECT_EQ(report.edges_below_min, summary.edges_below_min);
}

TEST(Smoothing, IsDeterministic) {
  PlanarMesh first = sample::cut_triangles(6, 10);
  sample::shake(first, 1.5, 9);
  PlanarMesh second = first;
  smooth(first, nullptr);
  smooth(second, nullptr);
  EXPECT_EQ(first.nodes, second.nodes);
}

TEST(Smoothing, CrestNodesSlideAlongTheirLine) {
  PlanarMesh mesh = sample::grid(8, 4, 5.0);
  std::vector<Index> crest;
  for (Index i = 0; i <= 8; ++i) crest.push_back(2 * 9 + i);
  Vec2 shift = {1.8, 0};
  for (Index i = 1; i < 8; ++i, shift = -shift) {
    mesh.freedom[crest[i]] = NodeFreedom::sliding;
    mesh.nodes[crest[i]] += shift;
  }
  std::vector<SlidingLine> lines{line_through(crest, mesh.nodes)};
  const SmoothingReport report = smooth(mesh, nullptr, lines);
  EXPECT_GT(report.scaled_jacobian_min, 0.9);
  for (Index i = 1; i < 8; ++i) {
    EXPECT_NEAR(mesh.nodes[crest[i]].y, 10, 1e-9);
    EXPECT_NEAR(mesh.nodes[crest[i]].x, 5.0 * i, 1.5);
  }
}

TEST(Smoothing, CrestNodesWithoutLineStay) {
  PlanarMesh mesh = sample::grid(4, 4, 5.0);
  mesh.freedom[12] = NodeFreedom::sliding;
  mesh.nodes[12] += Vec2{2, 1};
  const Vec2 before = mesh.nodes[12];
  smooth(mesh, nullptr);
  EXPECT_EQ(mesh.nodes[12], before);
}

/// A plane tilted by 60 degrees about y: lengths along x double, so squares of the plane are 1:2 on the
/// surface.
TEST(Smoothing, MeasuresOnTheSurface) {
  Facets facets;
  FlatFace flat;
  for (const Vec2 p : {Vec2{-1, -1}, Vec2{61, -1}, Vec2{61, 61}, Vec2{-1, 61}}) {
    flat.positions.push_back(p);
    facets.points.push_back({p.x, p.y, std::sqrt(3.0) * p.x});
  }
  facets.triangles = {{0, 1, 2}, {0, 2, 3}};
  facets.triangle_surface = {0, 0};
  facets.loops = {{0, 1, 2, 3}};
  const SurfaceMap map(facets, flat);
  PlanarMesh mesh = sample::grid(10, 10, 1.5);
  SmoothingOptions options;
  options.size = 3;
  options.min_edge = 1.4;
  EXPECT_EQ(smooth(mesh, &map, options).edges_below_min, 0);
  options.min_edge = 1.6;
  // Only the edges along y are below 1.6 on the surface; on a fixed frame they cannot all be longer.
  const int below = smooth(mesh, &map, options).edges_below_min;
  EXPECT_GT(below, 0);
  EXPECT_LE(below, 11 * 10);
}

TEST(Smoothing, SurvivesMeshWithoutElements) {
  PlanarMesh mesh;
  EXPECT_EQ(smooth(mesh, nullptr).inverted, 0);
}

/// A sheet bent sharply along a line that no row of nodes follows: the row nearest to it is drawn there.
TEST(Smoothing, SurfacePassesBringElementsNearer) {
  Facets facets;
  FlatFace flat;
  const auto add_row = [&](double x, double z) {
    for (const double y : {-1.0, 41.0}) flat.positions.push_back({x, y}), facets.points.push_back({x, y, z});
  };
  add_row(-1, 0), add_row(18, 0), add_row(41, 11.5);
  facets.triangles = {{0, 2, 1}, {1, 2, 3}, {2, 4, 3}, {3, 4, 5}};
  facets.triangle_surface = {0, 0, 0, 0};
  const SurfaceMap map(facets, flat);
  SmoothingOptions options;
  PlanarMesh plain = sample::grid(8, 8, 5.0), fitted = plain;
  smooth(plain, &map, options);
  options.surface_passes = 10;
  const SmoothingReport report = smooth(fitted, &map, options);
  const auto distance_to_bend = [](const PlanarMesh& mesh) {
    double nearest = 1e300;
    for (const Vec2 p : mesh.nodes)
      if (std::abs(p.y - 20) < 8) nearest = std::min(nearest, std::abs(p.x - 18));
    return nearest;
  };
  EXPECT_LT(distance_to_bend(fitted), 0.5 * distance_to_bend(plain));
  EXPECT_GT(report.scaled_jacobian_min, 0.8);
  EXPECT_GT(report.deviation, 0);
  EXPECT_EQ(report.edges_below_min, 0);
  EXPECT_FALSE(report.given_up);

  PlanarMesh hopeless = sample::grid(8, 8, 5.0);
  options.hopeless = 1.1;
  EXPECT_TRUE(smooth(hopeless, &map, options).given_up);
  EXPECT_EQ(hopeless.nodes, plain.nodes) << "the passes are left out";
}

/// Large meshes are moved by several threads at once.
TEST(Smoothing, LargeMeshIsTheSameOnAnyNumberOfThreads) {
  PlanarMesh start = sample::cut_triangles(24, 12.0);
  sample::shake(start, 2.0, 11);
  ASSERT_GT(start.nodes.size(), 3000u);
  std::vector<PlanarMesh> results;
  for (const size_t threads : {1, 4}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    results.push_back(start);
    EXPECT_EQ(smooth(results.back(), nullptr).inverted, 0);
  }
  EXPECT_EQ(results[0].nodes, results[1].nodes);
}

}  // namespace
}  // namespace beadmesh
