#include "random_domains.h"

#include <algorithm>
#include <cmath>

namespace beadmesh::oracle {
namespace {

std::vector<Vec2> star(Random& random, Vec2 centre, double low, double high, int corners) {
  std::vector<Vec2> points;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * (i + random.between(-0.3, 0.3)) / corners;
    points.push_back(centre + Vec2{std::cos(angle), std::sin(angle)} * random.between(low, high));
  }
  return points;
}

PlanarRegion region_of(std::vector<std::vector<Vec2>> loops) {
  PlanarRegion region;
  for (auto& points : loops) region.loops.push_back({std::move(points), {}, {}});
  return region;
}

std::vector<Vec2> comb_outline(int teeth) {
  std::vector<Vec2> points{{20.0 * teeth - 12, 8}, {0, 8}};
  for (int k = 0; k < teeth; ++k) {
    const double x = 20.0 * k;
    if (k > 0) points.push_back({x, 0});
    points.push_back({x, -60});
    points.push_back({x + 8, -60});
    if (k + 1 < teeth) points.push_back({x + 8, 0});
  }
  return points;
}

}  // namespace

PlanarRegion random_region(std::uint64_t seed, int corners) {
  Random random(seed);
  std::vector<std::vector<Vec2>> loops{star(random, {}, 60, 100, corners)};
  const int holes = random.below(4);
  for (int h = 0; h < holes; ++h) {
    const double angle = 2 * pi * (h + random.between(0, 0.3)) / holes;
    const Vec2 centre = Vec2{std::cos(angle), std::sin(angle)} * 30;
    loops.push_back(star(random, centre, 6, 14, 3 + random.below(9)));
  }
  return region_of(std::move(loops));
}

PlanarRegion random_skyline(std::uint64_t seed, int columns) {
  Random random(seed);
  std::vector<Vec2> points{{0, -1}, {static_cast<double>(columns), -1}};
  for (int i = columns - 1; i >= 0; --i) {
    const double height = random.below(8);
    points.push_back({i + 1.0, height});
    points.push_back({static_cast<double>(i), height});
  }
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return region_of({points});
}

std::vector<NamedRegion> letters() {
  return {
      {"L", region_of({{{0, 0}, {60, 0}, {60, 20}, {20, 20}, {20, 60}, {0, 60}}})},
      {"T", region_of({{{-8, -60}, {8, -60}, {8, -9}, {50, -9}, {50, 9}, {-50, 9}, {-50, -9}, {-8, -9}}})},
      {"comb", region_of({comb_outline(15)})},
      {"plate", region_of({{{0, 0}, {90, 0}, {80, 50}, {10, 55}},
                           {{20, 15}, {22, 33}, {35, 30}, {33, 12}},
                           {{55, 20}, {50, 35}, {66, 31}}})}};
}

PlanarRegion on_grid(const PlanarRegion& region, double angle, int bits) {
  const double c = std::cos(angle), s = std::sin(angle);
  PlanarRegion result = region;
  double largest = 0;
  for (PlanarLoop& loop : result.loops)
    for (Vec2& p : loop.points) {
      p = {c * p.x - s * p.y, s * p.x + c * p.y};
      largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    }
  const double scale = std::ldexp(1.0, bits) / largest;
  for (PlanarLoop& loop : result.loops)
    for (Vec2& p : loop.points) p = {std::round(p.x * scale), std::round(p.y * scale)};
  return result;
}

}  // namespace beadmesh::oracle
