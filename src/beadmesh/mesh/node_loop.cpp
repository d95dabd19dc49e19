#include "beadmesh/mesh/node_loop.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace beadmesh {
namespace {

constexpr std::array<std::array<int, 2>, 4> steps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

int quarter(int turns) {
  return ((turns % 4) + 4) % 4;
}

}  // namespace

double turn_from(Vec2 u, Vec2 v) {
  const double angle = std::atan2(cross(u, v), dot(u, v));
  return angle > 1e-9 ? angle : angle + 2 * pi;
}

double signed_area(const std::vector<Vec2>& nodes, const NodeLoop& loop) {
  double twice = 0;
  const Vec2 origin = nodes[loop[0]];
  for (std::size_t i = 0; i < loop.size(); ++i) {
    twice += cross(nodes[loop[i]] - origin, nodes[loop[(i + 1) % loop.size()]] - origin);
  }
  return twice / 2;
}

bool is_inside(const std::vector<Vec2>& nodes, const NodeLoop& loop, Vec2 point) {
  bool inside = false;
  for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
    const Vec2 a = nodes[loop[i]], b = nodes[loop[j]];
    if ((a.y > point.y) != (b.y > point.y) && point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y)) {
      inside = !inside;
    }
  }
  return inside;
}

int quads_in_angle(double angle) {
  return std::max(1, static_cast<int>(std::lround(angle / (pi / 2))));
}

std::vector<double> interior_angles(const std::vector<Vec2>& nodes, const NodeLoop& loop) {
  const std::size_t n = loop.size();
  std::vector<double> angles(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 p = nodes[loop[i]], next = nodes[loop[(i + 1) % n]], previous = nodes[loop[(i + n - 1) % n]];
    angles[i] = turn_from(next - p, previous - p);
  }
  return angles;
}

LatticeWalk::LatticeWalk(const std::vector<double>& angles)
    : size_(static_cast<int>(angles.size())), turns_(2 * size_ + 1, 0), places_(2 * size_ + 1, {0, 0}) {
  for (int i = 0; i < 2 * size_; ++i) {
    turns_[i + 1] = turns_[i] + 2 - quads_in_angle(angles[i % size_]);
    const auto& step = steps[quarter(turns_[i + 1])];
    places_[i + 1] = {places_[i][0] + step[0], places_[i][1] + step[1]};
  }
}

std::array<int, 2> LatticeWalk::defect(int from, int to, int edges, int quads_from, int quads_to) const {
  const int end = to > from ? to : to + size_;
  const int arriving = turns_[end] + 2 - quads_to;  // direction of the split line, after the turn at `to`
  const int turns = turns_[end] - turns_[from + 1] + 2 - quads_to + 2 - quads_from;
  const auto& step = steps[quarter(arriving)];
  const int x = places_[end][0] - places_[from][0] + edges * step[0];
  const int y = places_[end][1] - places_[from][1] + edges * step[1];
  return {4 - turns, std::abs(x) + std::abs(y)};
}

}  // namespace beadmesh
