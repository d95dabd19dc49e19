#include "beadmesh/mesh/loop_template.h"

#include <gtest/gtest.h>

#include "mesh/sample_loops.h"

namespace beadmesh {
namespace {

// The mesh that the templates make of one loop.
PlanarMesh filled(const NodeLoops& loops, bool& done) {
  MeshDraft draft(loops, nullptr, 1);
  done = fill_by_template(draft, loops.loops[0]);
  return std::move(draft).take();
}

struct Sample {
  const char* name;
  std::vector<Vec2> points;
  int elements, inner;
};

TEST(LoopTemplate, ChoosesTheNaturalFilling) {
  const std::vector<Sample> samples{
      {"triangle", test::polygon({{0, 0}, {1, 0}, {0, 1}}, {1, 1, 1}), 1, 0},
      {"square", test::rectangle(1, 1, 1, 1), 1, 0},
      {"square with a split side", test::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {2, 1, 1, 1}), 2, 0},
      {"two squares", test::rectangle(2, 1, 2, 1), 2, 0},
      {"three squares", test::rectangle(3, 1, 3, 1), 3, 0},
      {"four squares", test::rectangle(2, 2, 2, 2), 4, 1},
  };
  for (const Sample& sample : samples) {
    NodeLoops loops;
    test::add_loop(loops, sample.points);
    bool done = false;
    const PlanarMesh mesh = filled(loops, done);
    ASSERT_TRUE(done) << sample.name;
    EXPECT_EQ(mesh.elements.size(), sample.elements) << sample.name;
    EXPECT_EQ(mesh.nodes.size() - loops.nodes.size(), sample.inner) << sample.name;
    EXPECT_TRUE(verify_planar_mesh(mesh, loops).empty()) << sample.name;
    for (const MeshElement& element : mesh.elements)
      EXPECT_GT(test::signed_area(mesh, element), 0) << sample.name;
  }
}

TEST(LoopTemplate, TriangularHexagonGetsAnInnerNode) {
  NodeLoops loops;
  test::add_loop(loops, test::polygon({{0, 0}, {2, 0}, {1, 1.7}}, {2, 2, 2}));
  bool done = false;
  const PlanarMesh mesh = filled(loops, done);
  EXPECT_EQ(mesh.elements.size(), 3u);
  EXPECT_TRUE(verify_planar_mesh(mesh, loops).empty());
}

TEST(LoopTemplate, NeverRepeatsAnEdge) {
  NodeLoops loops;
  const NodeLoop loop = test::add_loop(loops, test::rectangle(2, 1, 2, 1));
  MeshDraft draft(loops, nullptr, 1);
  draft.add_edge(loop[1], loop[4]);
  ASSERT_TRUE(fill_by_template(draft, loop));
  for (const MeshElement& element : draft.elements()) {
    for (int i = 0; i < 4; ++i) {
      const Index a = element[i], b = element[(i + 1) % 4];
      EXPECT_FALSE((a == loop[1] && b == loop[4]) || (a == loop[4] && b == loop[1]));
    }
  }
}

TEST(LoopTemplate, RefusesAFoldedLoop) {
  NodeLoops loops;
  loops.nodes = {{0, 0}, {1, 0}, {2, 0}};
  loops.loops = {{0, 1, 2, 1}};
  bool done = true;
  filled(loops, done);
  EXPECT_FALSE(done);
}

}  // namespace
}  // namespace beadmesh
