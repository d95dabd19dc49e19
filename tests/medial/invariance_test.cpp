// The same shape turned, moved, scaled, written or sampled in another way has
// the same medial object.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "beadmesh/medial/medial_object.h"
#include "medial/axis_comparison.h"
#include "medial/exact_region.h"

namespace beadmesh {
namespace {

using namespace exact_shapes;

struct Shape {
  std::string name;
  std::function<PlanarRegion(const Accuracy&)> make;
};

/// Those with junctions of more than three edges, or without a single answer,
/// are not among them.
std::vector<Shape> shapes() {
  const auto sharp = [](std::vector<Vec2> corners) {
    return [=](const Accuracy& a) { return rounded(corners, std::vector<double>(corners.size(), 0.0), a); };
  };
  return {{"rectangle", sharp({{0, 0}, {100, 0}, {100, 20}, {0, 20}})},
          {"L", sharp({{0, 0}, {80, 0}, {80, 20}, {20, 20}, {20, 70}, {0, 70}})},
          {"quadrilateral", sharp({{0, 0}, {50, -7}, {61, 40}, {-9, 33}})},
          {"comb", sharp(comb_corners(15, 10, 20, 40))},
          {"stadium", [](const Accuracy& a) { return stadium(104, 8, a); }},
          {"ellipse", [](const Accuracy& a) { return ellipse(50, 25, a); }},
          {"concentric ring", [](const Accuracy& a) { return annulus(40, 28, {}, a); }},
          {"eccentric ring",
           [](const Accuracy& a) {
             return annulus(40, 20, {9, 4}, a);
           }},
          {"plate with a hole", [](const Accuracy& a) { return holed_plate(30, 12, a); }},
          {"round L",
           [](const Accuracy& a) {
             return rounded({{-8, -8}, {90, -8}, {90, 8}, {8, 8}, {8, 70}, {-8, 70}}, {3, 8, 8, 4, 8, 8}, a);
           }},
          {"gasket", [](const Accuracy& a) { return gasket(a); }}};
}

MedialObject object_of(const PlanarRegion& region) {
  auto checked = checked_region(region);
  EXPECT_TRUE(checked) << (checked ? "" : to_line(checked.error()));
  auto object = checked ? medial_object(*checked) : medial_object({});
  EXPECT_TRUE(object) << (object ? "" : to_line(object.error()));
  return object ? *object : MedialObject{};
}

/// In parts of the size. Points of edges lie elsewhere along the axis, so that polylines differ by their
/// chords; and coordinates of 1e5 lose digits. The thickness of an edge is taken from its points.
constexpr double tolerance = 2e-6, thickness_tolerance = 2e-5;

class Invariance : public testing::TestWithParam<bool> {
 protected:
  Accuracy accuracy(double phase = 0) const { return {GetParam(), radians(GetParam() ? 7.5 : 3), phase}; }

  static void expect_same(const MedialObject& known, const PlanarRegion& changed,
                          const std::function<Vec2(Vec2)>& map, double scale, double most,
                          const std::string& what) {
    const auto found = differences(known, object_of(changed), map, scale, most * known.size * scale,
                                   std::max(4 * most, thickness_tolerance) * known.size * scale);
    EXPECT_TRUE(found.empty()) << what << ": " << found.size() << " differences, first: " << found.front()
                               << ", last: " << found.back();
  }

  static Vec2 stay(Vec2 p) { return p; }
};

TEST_P(Invariance, RotationTranslationScale) {
  for (const Shape& shape : shapes()) {
    const PlanarRegion region = shape.make(accuracy());
    const MedialObject known = object_of(region);
    const auto expect_moved = [&](double angle, double scale, Vec2 shift, const std::string& what) {
      const auto map = [=](Vec2 p) {
        const double c = scale * std::cos(angle), s = scale * std::sin(angle);
        return Vec2{c * p.x - s * p.y, s * p.x + c * p.y} + shift;
      };
      expect_same(known, moved(region, angle, scale, shift), map, scale, tolerance, shape.name + ", " + what);
    };
    for (int i = 0; i < 16; ++i) expect_moved(0.01 + i * 0.41, 1, {}, "turned " + std::to_string(i));
    expect_moved(pi / 2, 1, {}, "a quarter turn");
    expect_moved(pi / 4, 1, {}, "an eighth turn");
    expect_moved(0, 1, {1e5, -1e5}, "moved");
    expect_moved(0.7, 1, {1e5, 1e5}, "turned and moved");
    expect_moved(0, 1e-3, {}, "small");
    expect_moved(0, 1e3, {}, "large");
    expect_moved(1.1, 1e3, {1e8, 3e7}, "large, turned and moved");
  }
}

TEST_P(Invariance, StartDirectionAndOrderOfLoops) {
  for (const Shape& shape : shapes()) {
    const PlanarRegion region = shape.make(accuracy());
    const MedialObject known = object_of(region);
    for (const std::size_t by : {1u, 7u, 18u})
      expect_same(known, started_later(region, by), stay, 1, tolerance, shape.name + ", started later");
    expect_same(known, run_backwards(region), stay, 1, tolerance, shape.name + ", backwards");
    PlanarRegion reordered = region;
    std::reverse(reordered.loops.begin(), reordered.loops.end());
    expect_same(known, reordered, stay, 1, tolerance, shape.name + ", loops in another order");
  }
}

TEST_P(Invariance, SamplingPhaseAndDensity) {
  // Facets stand for their curve up to their sagitta (3 degrees: 3.4e-4 of the
  // radius, here at most 0.0003 L).
  const double most = GetParam() ? tolerance : 1e-3;
  for (const Shape& shape : shapes()) {
    const MedialObject known = object_of(shape.make(accuracy()));
    for (const double phase : {0.2, 0.5, 0.9})
      expect_same(known, shape.make(accuracy(phase)), stay, 1, most,
                  shape.name + ", phase " + std::to_string(phase));
    for (const double step : {2.0, 1.0})
      expect_same(known, shape.make({GetParam(), radians(step), 0.3}), stay, 1, most,
                  shape.name + ", facets of " + std::to_string(step));
  }
}

INSTANTIATE_TEST_SUITE_P(Curves, Invariance, testing::Bool(),
                         [](const auto& value) { return std::string(value.param ? "Exact" : "Facetted"); });

}  // namespace
}  // namespace beadmesh
