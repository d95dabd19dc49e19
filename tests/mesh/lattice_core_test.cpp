#include "beadmesh/mesh/lattice_core.h"

#include <gtest/gtest.h>

#include "mesh/sample_loops.h"

namespace beadmesh {
namespace {

TEST(LatticeCore, FitsTheNodesOfARotatedRectangle) {
  NodeLoops loops;
  const double angle = 0.3;
  auto points = test::rectangle(100, 61, 20, 12);
  for (Vec2& p : points)
    p = {p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle)};
  test::add_loop(loops, points);
  const MeshDraft draft(loops, nullptr, 5);
  const Lattice lattice = fit_lattice(draft, loops.loops);
  for (const Vec2& p : points) {
    for (const Vec2& step : {lattice.first, lattice.second}) {
      const double place = dot(p - lattice.origin, step) / squared_norm(step);
      EXPECT_NEAR(place, std::round(place), 0.05);
    }
  }
}

TEST(LatticeCore, KeepsItsDistanceAndLeavesItsOutline) {
  NodeLoops loops;
  test::add_loop(loops, test::rectangle(100, 60, 20, 12));
  test::add_loop(loops, test::circle({50, 30}, 10, 12, true));
  MeshDraft draft(loops, nullptr, 5);
  const auto outlines = add_lattice_core(draft, loops.loops, {{0, 0}, {5, 0}, {0, 5}}, 1);
  ASSERT_EQ(outlines.size(), 2u);
  double total = 0;
  for (const auto& outline : outlines) total += signed_area(draft.nodes(), outline);
  EXPECT_NEAR(-total, 25.0 * draft.elements().size(), 1e-9);
  for (std::size_t i = loops.nodes.size(); i < draft.nodes().size(); ++i) {
    const Vec2 p = draft.nodes()[i];
    EXPECT_GE(distance(p, {50, 30}), 14.5);
    EXPECT_GE(std::min({p.x, p.y, 100 - p.x, 60 - p.y}), 5 - 1e-4);
  }
}

TEST(LatticeCore, OddLoopsGetACommonArea) {
  NodeLoops loops;
  test::add_loop(loops, test::rectangle(100, 60, 20, 12));
  test::add_loop(loops, test::circle({25, 30}, 5, 7, true));
  test::add_loop(loops, test::circle({75, 30}, 5, 7, true));
  MeshDraft draft(loops, nullptr, 5);
  // One outline around the core, one around both holes with the slot between them.
  EXPECT_EQ(add_lattice_core(draft, loops.loops, {{0, 0}, {5, 0}, {0, 5}}, 1).size(), 2u);
}

TEST(LatticeCore, NarrowFaceHasNone) {
  NodeLoops loops;
  test::add_loop(loops, test::rectangle(100, 12, 20, 2));
  MeshDraft draft(loops, nullptr, 5);
  EXPECT_TRUE(add_lattice_core(draft, loops.loops, fit_lattice(draft, loops.loops), 1).empty());
  EXPECT_TRUE(draft.elements().empty());
}

}  // namespace
}  // namespace beadmesh
