#include "beadmesh/report/drawing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace beadmesh::drawing {
namespace {

TEST(Drawing, EscapesMarkupAndKeepsUtf8) {
  EXPECT_EQ(escaped("a<b>&\"'"), "a&lt;b&gt;&amp;&quot;&#39;");
  EXPECT_EQ(escaped("Stra\xC3\x9F"
                    "e"),
            "Stra\xC3\x9F"
            "e");
  EXPECT_EQ(escaped("caf\xE9\n"), "caf??");
}

TEST(Drawing, PathsAreRelativeAndDoNotDrift) {
  Path path;
  path.polyline({{1, 2}, {1.004, 2}, {1.008, 2}, {1.012, 1.5}}, true);
  EXPECT_EQ(path.text(), "M100 200l0 0 1 0 0-50z");
}

TEST(Drawing, ThinnedLinesKeepToTheirShape) {
  EXPECT_EQ(thinned({{0, 0}, {1, 0.05}, {2, 0}, {3, 0}}, 0.1), (std::vector<Vec2>{{0, 0}, {3, 0}}));
  EXPECT_EQ(thinned({{0, 0}, {1, 0}, {1, 1}}, 0.1), (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}}));
  std::vector<Vec2> circle;
  for (int i = 0; i <= 10000; ++i) circle.push_back({std::cos(i * pi / 5000), std::sin(i * pi / 5000)});
  const std::vector<Vec2> few = thinned(circle, 0.01);
  EXPECT_LT(few.size(), 60);
  EXPECT_GT(few.size(), 15) << "a closed line is no point";
  EXPECT_EQ(thinned({{1, 2}}, 1).size(), 1);
}

TEST(Drawing, RoundLengthsAreOneTwoOrFive) {
  EXPECT_DOUBLE_EQ(round_length(260), 200);
  EXPECT_DOUBLE_EQ(round_length(99), 50);
  EXPECT_DOUBLE_EQ(round_length(0.013), 0.01);
  EXPECT_DOUBLE_EQ(round_length(0), 1);
}

TEST(Drawing, TheRampGrowsLighter) {
  int last = -1;
  for (double t = 0; t <= 1; t += 0.05) {
    const Color color = ramp(t);
    const int light = 2 * color.red + 5 * color.green + color.blue;
    EXPECT_GT(light, last);
    last = light;
  }
}

TEST(Drawing, TheFrameTurnsYDownAndKeepsTheShape) {
  const Frame frame({{0, 0}, {10, 5}}, {100, 50}, 200, 200);
  EXPECT_EQ(frame({0, 5}), (Vec2{100, 50}));
  EXPECT_EQ(frame({10, 0}), (Vec2{300, 150}));
}

}  // namespace
}  // namespace beadmesh::drawing
