#include "beadmesh/geometry/ray_search.h"

#include <gtest/gtest.h>

#include <random>

namespace beadmesh {
namespace {

std::vector<std::array<Vec3, 3>> random_triangles(int count) {
  std::mt19937 random(7);
  const auto part = [&] { return double(random() % 10000) / 10000; };
  std::vector<std::array<Vec3, 3>> triangles;
  for (int i = 0; i < count; ++i) {
    const Vec3 at{10 * part(), 10 * part(), 10 * part()};
    triangles.push_back({at, at + Vec3{part(), part(), 0}, at + Vec3{0, part(), part()}});
  }
  return triangles;
}

TEST(RaySearch, FindsWhatTryingAllTrianglesFinds) {
  const auto triangles = random_triangles(400);
  const RaySearch all(triangles);
  std::vector<RaySearch> single;
  for (const auto& t : triangles) single.emplace_back(std::vector{t});
  std::mt19937 random(11);
  const auto part = [&] { return double(random() % 10000) / 10000; };
  int hits = 0;
  for (int i = 0; i < 400; ++i) {
    const Vec3 origin{12 * part() - 1, 12 * part() - 1, -1};
    const Vec3 direction = normalized(Vec3{part() - 0.5, part() - 0.5, 1});
    std::optional<RayHit> best;
    for (Index t = 0; t < Index(single.size()); ++t)
      if (const auto hit = single[t].first_hit(origin, direction, 0, 100); hit)
        if (!best || hit->distance < best->distance) best = RayHit{hit->distance, t};
    const auto found = all.first_hit(origin, direction, 0, 100);
    ASSERT_EQ(found.has_value(), best.has_value());
    if (!best) continue;
    ++hits;
    EXPECT_EQ(found->triangle, best->triangle);
    EXPECT_EQ(found->distance, best->distance);
  }
  EXPECT_GT(hits, 40);
}

TEST(RaySearch, LooksOnlyBetweenTheDistancesAskedFor) {
  const RaySearch search({{Vec3{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}, {Vec3{0, 0, 2}, {4, 0, 2}, {0, 4, 2}}});
  const Vec3 up{0, 0, 1}, origin{1, 1, 0};
  EXPECT_EQ(search.first_hit(origin, up, 0, 9)->triangle, 0);
  EXPECT_EQ(search.first_hit(origin, up, 1, 9)->triangle, 1);
  EXPECT_FALSE(search.first_hit(origin, up, 0, 1));
  EXPECT_FALSE(search.first_hit(origin, -up, 0, 9));
  EXPECT_FALSE(RaySearch({}).first_hit(origin, up, 0, 9));
}

}  // namespace
}  // namespace beadmesh
