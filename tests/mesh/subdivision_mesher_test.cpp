#include "beadmesh/mesh/subdivision_mesher.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mesh/sample_loops.h"

namespace beadmesh {
namespace {

const SubdivisionOptions five{5, 2.5};

PlanarMesh meshed(const NodeLoops& loops, const SubdivisionOptions& options = five) {
  const auto mesh = mesh_by_subdivision(loops, nullptr, options);
  EXPECT_TRUE(mesh.has_value());
  if (!mesh) return {};
  for (const auto& violation : verify_planar_mesh(*mesh, loops)) ADD_FAILURE() << violation;
  return *mesh;
}

TEST(SubdivisionMesher, RectangleIsARegularGrid) {
  NodeLoops loops;
  test::add_loop(loops, test::rectangle(100, 60, 20, 12));
  const PlanarMesh mesh = meshed(loops);
  EXPECT_EQ(mesh.elements.size(), 240u);
  EXPECT_EQ(test::irregular_nodes(mesh), 0);
}

TEST(SubdivisionMesher, KeepsTheLoopsNodes) {
  NodeLoops loops;
  test::add_loop(loops, test::circle({3, 4}, 30, 38));
  const PlanarMesh mesh = meshed(loops);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
    const bool fixed = i < loops.nodes.size();
    EXPECT_EQ(mesh.freedom[i], fixed ? NodeFreedom::fixed : NodeFreedom::free);
    if (fixed) {
      EXPECT_EQ(mesh.nodes[i], loops.nodes[i]);
    }
  }
}

TEST(SubdivisionMesher, SheetWithHolesHasFewIrregularNodes) {
  NodeLoops loops;
  test::add_loop(loops, test::rectangle(300, 200, 60, 40));
  for (const double x : {60.0, 150.0, 240.0}) {
    for (const double y : {50.0, 140.0}) test::add_loop(loops, test::circle({x, y + 0.1 * x}, 20, 26, true));
  }
  const PlanarMesh mesh = meshed(loops);
  EXPECT_EQ(test::triangles(mesh), 0);
  EXPECT_LT(test::irregular_nodes(mesh), 0.06 * mesh.nodes.size());
  double area = 0;
  for (const MeshElement& element : mesh.elements) {
    EXPECT_GT(test::signed_area(mesh, element), 0);
    area += test::signed_area(mesh, element);
  }
  EXPECT_NEAR(area, 300 * 200 - 6 * 13 * 400 * std::sin(2 * pi / 26), 1e-6);
}

TEST(SubdivisionMesher, ScarsBecomeMeshLines) {
  NodeLoops loops;
  test::add_loop(loops, test::rectangle(100, 16, 20, 4));
  std::vector<Vec2> crest;
  for (int i = 0; i <= 16; ++i) crest.push_back({10.0 + 5 * i, 8});
  std::vector<Index> scar = test::add_loop(loops, crest);
  for (std::size_t i = scar.size() - 2; i > 0; --i) scar.push_back(scar[i]);
  loops.loops.back() = scar;
  const PlanarMesh mesh = meshed(loops);
  EXPECT_EQ(test::triangles(mesh), 0);
  EXPECT_EQ(mesh.elements.size(), 80u);
}

TEST(SubdivisionMesher, ParityDecidesAboutTheTriangle) {
  for (const int outer : {40, 41}) {
    for (const int hole : {18, 19}) {
      NodeLoops loops;
      test::add_loop(loops, test::circle({0, 0}, 60, outer));
      test::add_loop(loops, test::circle({10, 0}, 20, hole, true));
      EXPECT_EQ(test::triangles(meshed(loops)), (outer + hole) % 2) << outer << " and " << hole;
    }
  }
}

TEST(SubdivisionMesher, SameMeshEveryTime) {
  NodeLoops loops;
  test::add_loop(loops, test::circle({0, 0}, 80, 100));
  test::add_loop(loops, test::circle({20, 10}, 20, 26, true));
  const PlanarMesh first = meshed(loops), second = meshed(loops);
  EXPECT_EQ(first.nodes, second.nodes);
  EXPECT_EQ(first.elements, second.elements);
}

TEST(SubdivisionMesher, BadLoopsFailWithWords) {
  const auto code = [](const NodeLoops& loops, double size = 5) {
    const auto mesh = mesh_by_subdivision(loops, nullptr, {size, size / 2});
    return mesh ? std::string() : mesh.error().code;
  };
  NodeLoops loops;
  EXPECT_EQ(code(loops), "mesh.subdivision.loops");
  test::add_loop(loops, {{0, 0}, {10, 10}, {10, 0}, {0, 10}});  // a bow tie
  EXPECT_EQ(code(loops), "mesh.subdivision.loops");
  loops = {};
  test::add_loop(loops, test::rectangle(20, 20, 4, 4));
  EXPECT_EQ(code(loops, 0), "mesh.subdivision.size");
  EXPECT_EQ(code(loops, std::nan("")), "mesh.subdivision.size");
  test::add_loop(loops, test::circle({19, 10}, 4, 8, true));  // sticks out
  EXPECT_EQ(code(loops), "mesh.subdivision.loops");
  loops.loops.pop_back();
  loops.loops[0][3] = 999;
  EXPECT_EQ(code(loops), "mesh.subdivision.loops");
  loops = {};
  test::add_loop(loops, test::circle({0, 0}, 20, 20, true));  // clockwise
  EXPECT_EQ(code(loops), "mesh.subdivision.loops");
  loops = {};
  test::add_loop(loops, test::rectangle(20, 20, 4, 4));
  loops.nodes[2].x = std::nan("");
  EXPECT_EQ(code(loops), "mesh.subdivision.loops");
}

RC_GTEST_PROP(SubdivisionMesher, HolesAnywhereGiveAValidMesh, ()) {
  NodeLoops loops;
  test::add_loop(loops, test::rectangle(60, 40, 12, 8));
  int count = 0;
  for (const Vec2 centre : {Vec2{17, 17}, Vec2{43, 22}}) {
    const double radius = *rc::gen::inRange(2, 14);
    const int nodes = *rc::gen::inRange(3, 30);
    count += nodes;
    test::add_loop(loops, test::circle(centre, radius, nodes, true));
  }
  const auto mesh = mesh_by_subdivision(loops, nullptr, five);
  RC_ASSERT(mesh.has_value());
  RC_ASSERT(verify_planar_mesh(*mesh, loops).empty());
  RC_ASSERT(test::triangles(*mesh) == count % 2);
}

}  // namespace
}  // namespace beadmesh
