#include "beadmesh/mesh/face_mesher.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "bead/studied_bead.h"
#include "beadmesh/mesh/element_quality.h"
#include "examples/skeletons.h"
#include "mesh/sample_loops.h"

namespace beadmesh {
namespace {

using namespace shapes;

std::vector<Vec2> box(double width, double height, int across, int up) {
  const Vec2 corners[] = {
      {-width / 2, -height / 2}, {width / 2, -height / 2}, {width / 2, height / 2}, {-width / 2, height / 2}};
  std::vector<Vec2> points;
  for (int k = 0; k < 4; ++k) {
    const int n = k % 2 ? up : across;
    for (int i = 0; i < n; ++i) points.push_back(lerp(corners[k], corners[(k + 1) % 4], double(i) / n));
  }
  return points;
}

std::vector<Vec2> hole(double radius, int n) {
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i)
    points.push_back({radius * std::cos(2 * pi * i / n), -radius * std::sin(2 * pi * i / n)});
  return points;
}

/// A flat sheet 120 x 80 to mesh on.
std::unique_ptr<FaceStudy> sheet() {
  PlanPanel plan(flat_base, 6);
  plan.add_face(plan.add_loop(box(120, 80, 20, 14), {0, 20, 34, 54}), {}, on(flat_base));
  return std::move(study_faces(plan.take(), {0}).value());
}

QualitySummary quality(const PlanarMesh& mesh) {
  std::vector<Vec3> nodes;
  for (const Vec2 p : mesh.nodes) nodes.push_back({p.x, p.y, 0});
  return summarise(nodes, mesh.elements, 2.5);
}

TEST(FaceMesher, RectangleIsAGrid) {
  const auto study = sheet();
  NodeLoops loops;
  test::add_loop(loops, box(100, 60, 20, 12));
  const auto mesh = mesh_face(loops, *study->map);
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(verify_planar_mesh(*mesh, loops), std::vector<std::string>{});
  EXPECT_EQ(mesh->elements.size(), 240);
  EXPECT_NEAR(quality(*mesh).scaled_jacobian_min, 1, 1e-3);
}

TEST(FaceMesher, PlateWithAHoleIsAllQuadsAndGood) {
  const auto study = sheet();
  NodeLoops loops;
  test::add_loop(loops, box(100, 60, 20, 12));
  test::add_loop(loops, hole(12, 14));
  const auto mesh = mesh_face(loops, *study->map);
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(verify_planar_mesh(*mesh, loops), std::vector<std::string>{});
  const QualitySummary q = quality(*mesh);
  EXPECT_EQ(q.trias, 0);
  EXPECT_EQ(q.inverted, 0);
  EXPECT_EQ(q.edges_below_min, 0);
  EXPECT_GE(q.scaled_jacobian_min, 0.4);
}

TEST(FaceMesher, NodesOfTheLoopsKeepIndexAndPlace) {
  const auto study = sheet();
  NodeLoops loops;
  test::add_loop(loops, box(100, 60, 19, 11));
  test::add_loop(loops, hole(12, 16));
  const auto mesh = mesh_face(loops, *study->map);
  ASSERT_TRUE(mesh);
  for (size_t n = 0; n < loops.nodes.size(); ++n) EXPECT_EQ(mesh->nodes[n], loops.nodes[n]);
}

TEST(FaceMesher, OddBoundaryCostsOneTriangle) {
  const auto study = sheet();
  NodeLoops loops;
  test::add_loop(loops, box(100, 60, 20, 12));
  test::add_loop(loops, hole(12, 13));
  const auto mesh = mesh_face(loops, *study->map);
  ASSERT_TRUE(mesh);
  EXPECT_EQ(verify_planar_mesh(*mesh, loops), std::vector<std::string>{});
  EXPECT_EQ(quality(*mesh).trias, 1);
}

/// Quads of a ring round an acute tip have a corner of nearly 180 degrees there.
TEST(FaceMesher, WashersThatLeaveAPoorElementAreLeftOut) {
  const auto study = sheet();
  const Vec2 tips[] = {{20, 0}, {0, -4}, {-20, 0}, {0, 4}};
  std::vector<Vec2> slit;
  for (int k = 0; k < 4; ++k)
    for (int i = 0; i < 4; ++i) slit.push_back(lerp(tips[k], tips[(k + 1) % 4], i / 4.0));
  NodeLoops loops;
  test::add_loop(loops, box(100, 60, 20, 12));
  test::add_loop(loops, slit);
  const std::vector<Washer> washers{{1, 1, 5}};
  const auto rings = washer_rings(loops, washers, 5, 2.5);
  ASSERT_EQ(rings.size(), 1) << "there is room for a ring";
  EXPECT_LT(quality(with_washers(loops, rings, {})).scaled_jacobian_min, 0.3);
  const auto mesh = mesh_face(loops, *study->map, {5, 2.5, washers});
  ASSERT_TRUE(mesh) << mesh.error().message;
  EXPECT_EQ(verify_planar_mesh(*mesh, loops), std::vector<std::string>{});
  EXPECT_GE(quality(*mesh).scaled_jacobian_min, 0.3);
}

TEST(FaceMesher, LoopsThatCrossAreRefused) {
  const auto study = sheet();
  NodeLoops loops;
  test::add_loop(loops, box(100, 60, 20, 12));
  auto shifted = hole(12, 14);
  for (Vec2& p : shifted) p.x += 47;
  test::add_loop(loops, shifted);
  const auto mesh = mesh_face(loops, *study->map);
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().code.substr(0, 5), "mesh.");
}

}  // namespace
}  // namespace beadmesh
