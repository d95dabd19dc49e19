#include "fuzz_input.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace beadmesh::fuzz {
namespace {

constexpr std::size_t most_points = 256;

Vec2 next_point(Bytes& bytes, int kind) {
  if (kind == 0) {
    const double x = bytes.signed_byte();
    return {x, static_cast<double>(bytes.signed_byte())};
  }
  if (kind == 1) {
    const double x = bytes.fraction();
    return {x, bytes.fraction()};
  }
  const double x = bytes.any_double();
  return {x, bytes.any_double()};
}

std::vector<Vec2> raw_points(Bytes& bytes, int kind, int count) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) points.push_back(next_point(bytes, kind));
  return points;
}

/// Simple whatever the bytes are: one radius a direction.
std::vector<Vec2> star(Bytes& bytes, Vec2 centre, double radius, int count) {
  std::vector<Vec2> points;
  for (int i = 0; i < count; ++i) {
    const double r = radius * (1 + bytes.byte()) / 256.0, angle = 2 * pi * i / count;
    points.push_back(centre + Vec2{std::cos(angle), std::sin(angle)} * r);
  }
  return points;
}

/// Columns of whole heights side by side: right angles, equal lengths, points in a row.
std::vector<Vec2> skyline(Bytes& bytes, int columns) {
  std::vector<Vec2> points{{static_cast<double>(columns), -1}, {0, -1}};
  std::reverse(points.begin(), points.end());
  for (int i = columns - 1; i >= 0; --i) {
    const double height = bytes.byte() % 16;
    points.push_back({i + 1.0, height});
    points.push_back({static_cast<double>(i), height});
  }
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}

}  // namespace

double Bytes::any_double() {
  std::uint8_t raw[sizeof(double)];
  for (std::uint8_t& one : raw) one = static_cast<std::uint8_t>(byte());
  double value = 0;
  std::memcpy(&value, raw, sizeof value);
  return value;
}

PointsAndLoops points_and_loops(Bytes& bytes) {
  PointsAndLoops result;
  const int kind = bytes.byte() % 3, loops = bytes.byte() % 4, free_points = bytes.byte() % 16;
  for (int l = 0; l < loops; ++l) {
    const int count = bytes.byte() % 64;
    auto& loop = result.loops.emplace_back();
    for (int i = 0; i < count && result.points.size() < most_points; ++i) {
      loop.push_back(static_cast<Index>(result.points.size()));
      result.points.push_back(next_point(bytes, kind));
    }
  }
  for (int i = 0; i < free_points; ++i) result.points.push_back(next_point(bytes, kind));
  if (!bytes.empty() && !result.loops.empty() &&
      !result.loops[0].empty())  // a loop that is not as it should be
    result.loops[0][bytes.byte() % result.loops[0].size()] = bytes.signed_byte();
  return result;
}

PlanarRegion region(Bytes& bytes) {
  PlanarRegion result;
  const int kind = bytes.byte() % 6, count = 3 + bytes.byte() % 48, holes = bytes.byte() % 4;
  const auto add = [&](std::vector<Vec2> points) { result.loops.push_back({std::move(points), {}, {}}); };
  if (kind < 3)
    add(raw_points(bytes, kind, count));
  else if (kind < 5)
    add(star(bytes, {}, 100, count));
  else
    add(skyline(bytes, count));
  for (int h = 0; h < holes; ++h) {
    const Vec2 centre{static_cast<double>(bytes.signed_byte()), static_cast<double>(bytes.signed_byte())};
    const double radius = 1 + bytes.byte() / 4.0;
    add(star(bytes, centre, radius, 3 + bytes.byte() % 24));
  }
  return result;
}

void expect_none(const std::vector<std::string>& violations) {
  if (violations.empty()) return;
  for (const std::string& violation : violations) std::fprintf(stderr, "%s\n", violation.c_str());
  std::abort();
}

}  // namespace beadmesh::fuzz
