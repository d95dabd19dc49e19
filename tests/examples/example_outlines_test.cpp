#include "examples/example_outlines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace beadmesh::examples {
namespace {

TEST(ExampleOutlines, LoopsCloseAndRunCounterClockwise) {
  for (const std::string& name : outline_names()) {
    const ExampleOutline part = *example_outline(name);
    EXPECT_EQ(part.name, name);
    std::vector<PlanLoop> loops = part.holes;
    loops.push_back(part.outer);
    for (const PlanLoop& loop : loops) {
      for (std::size_t i = 0; i < loop.size(); ++i)
        EXPECT_LT(distance(loop[i].end, loop[(i + 1) % loop.size()].start), 1e-9) << name;
      double twice = 0;
      const std::vector<Vec2> points = sampled(loop);
      for (std::size_t i = 0; i < points.size(); ++i)
        twice += cross(points[i], points[(i + 1) % points.size()]);
      EXPECT_GT(twice, 0) << name;
    }
  }
  EXPECT_FALSE(example_outline("nothing"));
}

TEST(ExampleOutlines, HolesKeepClearOfEachOtherAndOfTheEdge) {
  for (const std::string& name : outline_names()) {
    const ExampleOutline part = *example_outline(name);
    double least = std::numeric_limits<double>::infinity();
    std::vector<PlanLoop> before{part.outer};
    for (const PlanLoop& hole : part.holes) {
      const BoundaryDistance inside(before);  // positive inside the outer loop and outside the holes
      for (const Vec2 p : sampled(hole)) least = std::min(least, inside(p));
      before.push_back(hole);
    }
    EXPECT_GT(least, 0.1) << name;
  }
}

TEST(ExampleOutlines, CountsAreThoseOfTheFigures) {
  EXPECT_TRUE(example_outline("spiral-bowl")->holes.empty());
  EXPECT_GE(example_outline("gasket")->holes.size(), 60);
  EXPECT_GE(example_outline("circuit-board")->holes.size(), 400);
  EXPECT_GE(example_outline("door")->holes.size(), 50);
  EXPECT_FALSE(example_outline("door")->base.is_flat());
}

}  // namespace
}  // namespace beadmesh::examples
