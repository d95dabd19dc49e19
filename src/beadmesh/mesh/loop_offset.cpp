#include "beadmesh/mesh/loop_offset.h"

#include <algorithm>

namespace beadmesh {

std::vector<Vec2> offset_into_face(const std::vector<Vec2>& loop, double distance) {
  const size_t n = loop.size();
  std::vector<Vec2> out;
  for (size_t i = 0; i < n; ++i) {
    const Vec2 before = normalized(loop[i] - loop[(i + n - 1) % n]),
               after = normalized(loop[(i + 1) % n] - loop[i]);
    const Vec2 inward = normalized(left_normal(before) + left_normal(after));
    out.push_back(loop[i] + inward * (distance / std::max(0.5, dot(inward, left_normal(after)))));
  }
  return out;
}

bool edges_keep_length(const std::vector<Vec2>& loop, const std::vector<Vec2>& moved, double least) {
  const size_t n = moved.size();
  for (size_t i = 0; i < n; ++i) {
    const Vec2 edge = moved[(i + 1) % n] - moved[i];
    if (norm(edge) < least || dot(edge, loop[(i + 1) % n] - loop[i]) <= 0) return false;
  }
  return true;
}

double squared_distance_to_segment(Vec2 point, Vec2 a, Vec2 b) {
  const Vec2 u = b - a;
  const double t = std::clamp(dot(point - a, u) / std::max(squared_norm(u), 1e-300), 0.0, 1.0);
  return squared_norm(a + u * t - point);
}

}  // namespace beadmesh
