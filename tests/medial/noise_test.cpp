// Facetted boundaries whose points are off by a little: the graph stays.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "beadmesh/medial/medial_object.h"
#include "medial/axis_comparison.h"
#include "medial/exact_region.h"
#include "medial/reference_axis.h"

namespace beadmesh {
namespace {

using namespace exact_shapes;
using namespace reference;

/// A generator that is the same on every machine.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : state_(seed * 2654435769u + 1) {}
  /// Between -1 and 1.
  double next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state_ >> 11) / 9007199254740992.0 * 2 - 1;
  }

 private:
  std::uint64_t state_;
};

/// Straight segments get points, no further apart than `spacing`; then all
/// points but corners move.
PlanarRegion noisy(const PlanarRegion& exact, double spacing, double amplitude, std::uint64_t seed) {
  Noise noise(seed);
  PlanarRegion region;
  for (const PlanarLoop& loop : exact.loops) {
    PlanarLoop& rough = region.loops.emplace_back();
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const Vec2 from = loop.points[i], to = loop.points[(i + 1) % loop.points.size()];
      const int n = std::max(1, static_cast<int>(std::ceil(distance(from, to) / spacing)));
      for (int k = 0; k < n; ++k) {
        const bool corner = k == 0 && loop.corner[i];
        const double dx = amplitude * noise.next(), dy = amplitude * noise.next();
        rough.points.push_back(lerp(from, to, static_cast<double>(k) / n) + (corner ? Vec2{} : Vec2{dx, dy}));
        rough.corner.push_back(corner);
      }
    }
  }
  return finished(std::move(region), {});
}

struct NoisyShape {
  std::string name;
  std::function<PlanarRegion(double spacing)> make;
};

/// Facets of arcs about as long as the spacing.
std::vector<NoisyShape> noisy_shapes() {
  const auto facets = [](double spacing, double radius) {
    return Accuracy{false, std::min(radians(12), spacing / radius), 0.2};
  };
  return {{"stadium", [=](double h) { return stadium(104, 8, facets(h, 8)); }},
          {"ring", [=](double h) { return annulus(40, 28, {}, facets(h, 40)); }},
          {"eccentric ring",
           [=](double h) {
             return annulus(40, 20, {9, 4}, facets(h, 30));
           }},
          {"plate with a hole", [=](double h) { return holed_plate(30, 12, facets(h, 12)); }},
          {"round L",
           [=](double h) {
             return rounded({{-8, -8}, {90, -8}, {90, 8}, {8, 8}, {8, 70}, {-8, 70}}, {3, 8, 8, 4, 8, 8},
                            facets(h, 8));
           }},
          {"comb",
           [=](double h) {
             return rounded(comb_corners(5, 10, 20, 40), std::vector<double>(20, 0.0), facets(h, 1));
           }},
          {"gasket", [=](double h) { return gasket(facets(h, 6)); }}};
}

// The noise rule: a bump of eps at one sample gives a spike once eps > h^2 / 2
// r; also beyond it nothing may change.
TEST(Noise, TopologyStays) {
  for (const NoisyShape& shape : noisy_shapes()) {
    const auto smooth = medial_object(shape.make(2));
    ASSERT_TRUE(smooth) << to_line(smooth.error());
    const MedialCounts expected = medial_counts(*smooth);
    for (const double spacing : {0.5, 1.0, 2.0})
      for (const double amplitude : {1e-6, 1e-4, 1e-3, 0.01, 0.02})
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
          const PlanarRegion region = noisy(shape.make(spacing), spacing, amplitude, seed);
          const auto object = medial_object(region);
          ASSERT_TRUE(object) << to_line(object.error());
          EXPECT_EQ(medial_counts(*object), expected)
              << shape.name << ", points every " << spacing << ", noise " << amplitude << ", seed " << seed;
        }
  }
}

// The axis moves by about as much as the boundary; the ends of caps and thin
// angles amplify it.
TEST(Noise, AxisStaysNear) {
  const double sagitta = 40 * (1 - std::cos(radians(1.5)));  // of the coarsest facets
  for (const double amplitude : {1e-4, 1e-3, 0.01})
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const auto ring =
          medial_object(noisy(annulus(40, 20, {9, 4}, {false, radians(3), 0}), 2, amplitude, seed));
      ASSERT_TRUE(ring);
      const Hausdorff of_ring = hausdorff(*ring, annulus_axis(40, 20, {9, 4}));
      EXPECT_LT(of_ring.found_to_known, sagitta + 3 * amplitude);
      EXPECT_LT(of_ring.known_to_found, sagitta + 3 * amplitude);
      const auto plate =
          medial_object(noisy(holed_plate(30, 12, {false, radians(3), 0}), 2, amplitude, seed));
      ASSERT_TRUE(plate);
      const Hausdorff of_plate = hausdorff(*plate, holed_plate_axis(30, 12));
      EXPECT_LT(of_plate.found_to_known, sagitta + 6 * amplitude);
      EXPECT_LT(of_plate.known_to_found, sagitta + 6 * amplitude);
    }
}

}  // namespace
}  // namespace beadmesh
