#include "beadmesh/mesh/shape_repair.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "beadmesh/mesh/smoothing.h"
#include "beadmesh/mesh/subdivision_mesher.h"
#include "mesh/sample_quads.h"

namespace beadmesh {
namespace {

using sample::grid;
using sample::worst_jacobian;

double shortest_edge(const PlanarMesh& mesh) {
  double shortest = 1e300;
  for (const MeshElement& e : mesh.elements)
    for (int i = 0; i < corner_count(e); ++i)
      shortest = std::min(shortest, distance(mesh.nodes[e[i]], mesh.nodes[e[(i + 1) % corner_count(e)]]));
  return shortest;
}

/// The sheet inside a hook: a half disc with nodes about 5 mm apart, its corners cut off by a bead's arc, and
/// an opening on one side.
NodeLoops hook(double radius, double width) {
  NodeLoops loops;
  loops.loops.emplace_back();
  const auto add = [&](Vec2 p) {
    loops.loops[0].push_back(Index(loops.nodes.size()));
    loops.nodes.push_back(p);
  };
  const int around = 2 * int(std::lround(pi * radius / 10));
  for (int i = 0; i < around; ++i)
    add({radius * std::cos(pi * i / around), radius * std::sin(pi * i / around)});
  const int along = int(std::lround(40 / 5.0)), across = 2 * int(std::lround(width / 10));
  for (int i = 0; i < along; ++i) add({-radius, -40.0 * i / along});
  for (int i = 0; i < across; ++i) add({-radius + width * i / across, -40});
  for (int i = 0; i < along; ++i) add({-radius + width, -40 + 40.0 * i / along});
  const double rest = 2 * radius - width;
  const int last = std::max(1, int(std::lround(rest / 5)));
  for (int i = 0; i < last; ++i) add({-radius + width + rest * i / last, 0});
  return loops;
}

TEST(ShapeRepair, LeavesAGoodMeshAlone) {
  PlanarMesh mesh = grid(6, 5, 5);
  const PlanarMesh before = mesh;
  EXPECT_EQ(repair_shapes(mesh, nullptr), 0);
  EXPECT_EQ(mesh.nodes, before.nodes);
  EXPECT_EQ(mesh.elements, before.elements);
}

TEST(ShapeRepair, NothingIsWorthAnEdgeUnderTheMinimum) {
  PlanarMesh mesh = grid(6, 6, 3);
  mesh.nodes[24] += Vec2{2, 2};  // smoothing alone brings it back
  repair_shapes(mesh, nullptr, {3, 2.9, 0.65});
  EXPECT_GE(shortest_edge(mesh), 2.9);
  EXPECT_GT(worst_jacobian(mesh), 0.9);
}

TEST(ShapeRepair, AGivenEdgeUnderTheMinimumIsNotWorkedOn) {
  PlanarMesh mesh = grid(6, 6, 5);
  mesh.nodes[1] = {0.5, 0};  // on the boundary
  ASSERT_LT(worst_jacobian(mesh), 0.8);
  const PlanarMesh before = mesh;
  EXPECT_EQ(repair_shapes(mesh, nullptr, {5, 2.5, 0.8}), 0);
  EXPECT_EQ(mesh.nodes, before.nodes);
}

int uneven_elements(const PlanarMesh& mesh) {
  const std::vector<Vec3> nodes = sample::lifted(mesh);
  return int(std::count_if(mesh.elements.begin(), mesh.elements.end(),
                           [&](const MeshElement& e) { return jacobian_ratio(nodes, e) < 0.6; }));
}

/// What fails by the Jacobian at the Gauss points only is worked on as well, first by moving nodes.
TEST(ShapeRepair, FewElementsFailByTheGaussPoints) {
  int elements = 0, smoothed = 0, repaired = 0;
  for (const double radius : {9.0, 10.0, 11.0, 12.0, 13.0, 15.0, 16.0, 18.0, 21.0})
    for (const double share : {0.6, 0.8, 1.0, 1.2, 1.4}) {
      const NodeLoops loops = hook(radius, share * radius);
      if (loops.nodes.size() % 2) continue;
      auto mesh = mesh_by_subdivision(loops, nullptr, {5, 2.5});
      ASSERT_TRUE(mesh) << mesh.error().message;
      smooth(*mesh, nullptr, {5, 2.5});
      smoothed += uneven_elements(*mesh);
      repair_shapes(*mesh, nullptr, {5, 2.5, 0.65});
      repaired += uneven_elements(*mesh);
      elements += int(mesh->elements.size());
    }
  EXPECT_LT(100 * smoothed, elements) << smoothed << " of " << elements;
  EXPECT_LT(500 * repaired, elements) << repaired << " of " << elements;
}

TEST(ShapeRepair, RaisesTheWorstShapeAndKeepsTheBoundary) {
  int poor = 0, mended = 0;
  for (const double radius : {9.0, 10.0, 11.0, 12.0, 13.0, 15.0, 16.0, 18.0, 21.0})
    for (const double share : {0.6, 0.8, 1.0, 1.2, 1.4}) {
      const NodeLoops loops = hook(radius, share * radius);
      if (loops.nodes.size() % 2) continue;
      auto mesh = mesh_by_subdivision(loops, nullptr, {5, 2.5});
      ASSERT_TRUE(mesh) << mesh.error().message;
      SmoothingOptions smoothing{5, 2.5};
      smoothing.aim = SmoothingOptions::Aim::angles;
      smooth(*mesh, nullptr, smoothing);
      const double before = worst_jacobian(*mesh), shortest = shortest_edge(*mesh);
      repair_shapes(*mesh, nullptr, {5, 2.5, 0.65});
      const double after = worst_jacobian(*mesh);
      // Shape beyond what is wanted may be given up for what fails by evenness.
      EXPECT_GE(after, std::min(before, 0.65)) << radius << " " << share;
      EXPECT_GE(shortest_edge(*mesh), std::min(2.5, shortest) - 1e-9);
      const auto violations = verify_planar_mesh(*mesh, loops);
      EXPECT_TRUE(violations.empty()) << violations.front();
      for (size_t n = 0; n < loops.nodes.size(); ++n) EXPECT_EQ(mesh->nodes[n], loops.nodes[n]);
      poor += before < 0.65;
      mended += before < 0.65 && after >= 0.6;
    }
  EXPECT_GE(poor, 3) << "cases without anything to mend say nothing";
  EXPECT_GE(4 * mended, 3 * poor);
}

/// Zones apart from each other, and attempts on one of them, are made at once.
TEST(ShapeRepair, IsTheSameOnAnyNumberOfThreads) {
  PlanarMesh start = sample::cut_triangles(16, 12.0);
  smooth(start, nullptr, {5, 2.5});
  std::vector<PlanarMesh> results;
  for (const size_t threads : {1, 4}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    results.push_back(start);
    EXPECT_GT(repair_shapes(results.back(), nullptr, {5, 2.5, 0.8}), 1);
  }
  EXPECT_EQ(results[0].nodes, results[1].nodes);
  EXPECT_EQ(results[0].elements, results[1].elements);
}

}  // namespace
}  // namespace beadmesh
