#include "beadmesh/read/point_hash.h"

#include <cmath>

namespace beadmesh {
namespace {

int level_of(double size) {
  return std::ilogb(size);
}

/// std::floor is a call without SSE 4.1, and this is the innermost loop.
std::int64_t cell_of(double x, double cell) {
  const double at = x / cell;
  const auto truncated = static_cast<std::int64_t>(at);
  return truncated - (at < static_cast<double>(truncated) ? 1 : 0);
}

}  // namespace

std::size_t PointHash::Level::slot(std::int64_t i, std::int64_t j, std::int64_t k) const {
  std::uint64_t h = static_cast<std::uint64_t>(i) * 0x9E3779B97F4A7C15u;
  h ^= static_cast<std::uint64_t>(j) * 0xC2B2AE3D27D4EB4Fu + (h >> 29);
  h ^= static_cast<std::uint64_t>(k) * 0x165667B19E3779F9u + (h >> 31);
  h ^= h >> 32;
  return static_cast<std::size_t>(h) & (heads.size() - 1);
}

std::size_t PointHash::Level::slot(Vec3 p) const {
  return slot(cell_of(p.x, cell), cell_of(p.y, cell), cell_of(p.z, cell));
}

void PointHash::Level::insert(Vec3 p) {
  if (items.size() >= heads.size()) grow();
  Index& head = heads[slot(p)];
  items.push_back({p, head});
  head = static_cast<Index>(items.size()) - 1;
}

void PointHash::Level::grow() {
  heads.assign(heads.size() * 4, no_index);
  for (std::size_t i = 0; i < items.size(); ++i) {
    Index& head = heads[slot(items[i].point)];
    items[i].next = head;
    head = static_cast<Index>(i);
  }
}

bool PointHash::Level::is_free(Vec3 c, double radius) const {
  for (std::int64_t i = cell_of(c.x - radius, cell); i <= cell_of(c.x + radius, cell); ++i)
    for (std::int64_t j = cell_of(c.y - radius, cell); j <= cell_of(c.y + radius, cell); ++j)
      for (std::int64_t k = cell_of(c.z - radius, cell); k <= cell_of(c.z + radius, cell); ++k)
        for (Index at = heads[slot(i, j, k)]; at != no_index; at = items[at].next)
          if (squared_norm(items[at].point - c) < radius * radius) return false;
  return true;
}

void PointHash::insert(Vec3 point, double size) {
  Level& level = levels_[level_of(size)];
  level.cell = std::ldexp(2.0, level_of(size));
  level.insert(point);
}

bool PointHash::is_free(Vec3 centre, double radius, double size) const {
  // Sizes vary slowly: what is near has a size of about the same order.
  const auto end = levels_.upper_bound(level_of(size) + 2);
  for (auto level = levels_.lower_bound(level_of(size) - 2); level != end; ++level)
    if (!level->second.is_free(centre, radius)) return false;
  return true;
}

}  // namespace beadmesh
