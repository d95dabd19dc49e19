#include "beadmesh/mesh/boundary_row.h"

#include <algorithm>
#include <cmath>

#include "beadmesh/mesh/loop_offset.h"

namespace beadmesh {
namespace {

constexpr double sharpest_turn = radians(40);

using Polygon = std::vector<Vec2>;

Polygon polygon_of(const NodeLoops& loops, const std::vector<Index>& loop) {
  Polygon out;
  for (Index n : loop) out.push_back(loops.nodes[n]);
  return out;
}

bool is_smooth(const Polygon& p) {
  const size_t n = p.size();
  for (size_t i = 0; i < n; ++i)
    if (angle_between(p[(i + 1) % n] - p[i], p[i] - p[(i + n - 1) % n]) > sharpest_turn) return false;
  return true;
}

/// No point of the row nearer to any other part of the boundary than the row is wide.
bool keeps_clear(const Polygon& inner, const NodeLoops& loops, double width) {
  const double least = 0.95 * 0.95 * width * width;
  for (const auto& loop : loops.loops)
    for (size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = loops.nodes[loop[i]], b = loops.nodes[loop[(i + 1) % loop.size()]];
      for (Vec2 p : inner)
        if (squared_distance_to_segment(p, a, b) < least) return false;
    }
  return true;
}

/// Opposite stretches of the row stay two elements apart, so that the inside can still be filled.
bool leaves_room(const Polygon& inner, double size) {
  const size_t n = inner.size();
  for (size_t i = 0; i < n; ++i)
    for (size_t j = 0; j < n; ++j) {
      const size_t apart = std::min((i + n - j) % n, (j + n - i) % n);
      if (apart > 4 && squared_norm(inner[i] - inner[j]) < 2.25 * size * size) return false;
    }
  return true;
}

}  // namespace

std::optional<std::vector<Vec2>> boundary_row(const NodeLoops& loops, const BoundaryRowOptions& options) {
  if (loops.loops.empty() || loops.loops[0].size() < 12) return std::nullopt;
  const Polygon outer = polygon_of(loops, loops.loops[0]);
  if (!is_smooth(outer)) return std::nullopt;
  const double least = 1.06 * options.min_edge;
  for (double width : {0.9 * options.size, 0.7 * options.size, 1.1 * options.min_edge}) {
    if (width < least) continue;
    const Polygon inner = offset_into_face(outer, width);
    if (edges_keep_length(outer, inner, least) && keeps_clear(inner, loops, width) &&
        leaves_room(inner, options.size))
      return inner;
  }
  return std::nullopt;
}

}  // namespace beadmesh
