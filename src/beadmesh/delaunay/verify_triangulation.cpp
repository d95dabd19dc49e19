#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "beadmesh/delaunay/triangulation.h"
#include "beadmesh/geometry/predicates.h"

namespace beadmesh {
namespace {

// A directed edge of a triangle.
struct Side {
  Index from, to;
  Index triangle;
  int slot;
  friend bool operator<(const Side& a, const Side& b) {
    return std::tie(a.from, a.to) < std::tie(b.from, b.to);
  }
};

// Works on the bare arrays, with none of the means by which they were made.
class Verifier {
 public:
  Verifier(const Triangulation& triangulation, const std::vector<std::vector<Index>>& loops)
      : t_(triangulation), loops_(loops) {}

  std::vector<std::string> run() {
    if (!check_indices()) return violations_;
    check_orientation();
    check_sides();
    check_neighbours();
    check_boundary();
    check_counts();
    check_area();
    return violations_;
  }

 private:
  template <class... Args>
  void report(fmt::format_string<Args...> format, Args&&... args) {
    violations_.push_back(fmt::format(format, std::forward<Args>(args)...));
  }
  Vec2 point(Index i) const { return t_.points[i]; }
  Side side(Index t, int k) const {
    return {t_.triangles[t][(k + 1) % 3], t_.triangles[t][(k + 2) % 3], t, k};
  }
  Index count() const { return static_cast<Index>(t_.triangles.size()); }
  const Side* find(Index from, Index to) const {
    const auto found = std::lower_bound(sides_.begin(), sides_.end(), Side{from, to, 0, 0});
    return found != sides_.end() && found->from == from && found->to == to ? &*found : nullptr;
  }

  bool check_indices();
  void check_orientation();
  void check_sides();
  void check_neighbours();
  void check_boundary();
  void check_counts();
  void check_area();
  bool is_inside(Vec2 p) const;
  double loop_area(const std::vector<Index>& loop) const;

  const Triangulation& t_;
  const std::vector<std::vector<Index>>& loops_;
  std::vector<Side> sides_;  // of all triangles, sorted
  std::vector<std::string> violations_;
};

bool Verifier::check_indices() {
  const auto n = static_cast<Index>(t_.points.size());
  if (t_.neighbours.size() != t_.triangles.size())
    report("{} neighbours for {} triangles", t_.neighbours.size(), count());
  for (std::size_t t = 0; t < t_.triangles.size() && t < t_.neighbours.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Index corner = t_.triangles[t][k], neighbour = t_.neighbours[t][k];
      if (corner < 0 || corner >= n) report("triangle {} has no point {}", t, corner);
      if (neighbour < no_index || neighbour >= count())
        report("triangle {} has no neighbour {}", t, neighbour);
    }
  for (const auto& loop : loops_)
    for (const Index i : loop)
      if (i < 0 || i >= n) report("a loop names point {} of {}", i, n);
  return violations_.empty();
}

void Verifier::check_orientation() {
  for (Index t = 0; t < count(); ++t) {
    const auto [a, b, c] = t_.triangles[t];
    if (!(orient2d(point(a), point(b), point(c)) > 0)) report("triangle {} is not counter-clockwise", t);
  }
}

void Verifier::check_sides() {
  for (Index t = 0; t < count(); ++t)
    for (int k = 0; k < 3; ++k) sides_.push_back(side(t, k));
  std::sort(sides_.begin(), sides_.end());
  for (std::size_t i = 1; i < sides_.size(); ++i)
    if (!(sides_[i - 1] < sides_[i]))
      report("triangles {} and {} are on the same side of the edge {}-{}", sides_[i - 1].triangle,
             sides_[i].triangle, sides_[i].from, sides_[i].to);
}

void Verifier::check_neighbours() {
  for (Index t = 0; t < count(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Index other = t_.neighbours[t][k];
      if (other == no_index) continue;
      const Side edge = side(t, k);
      const Side* back = find(edge.to, edge.from);
      if (!back || back->triangle != other || t_.neighbours[other][back->slot] != t) {
        report("triangles {} and {} are not each other's neighbours", t, other);
        continue;
      }
      const auto [a, b, c] = t_.triangles[t];
      if (incircle(point(a), point(b), point(c), point(t_.triangles[other][back->slot])) > 0)
        report("the edge {}-{} is not locally Delaunay", edge.from, edge.to);
    }
}

// The sides without a neighbour are the loops' edges, each once and the right way round.
void Verifier::check_boundary() {
  std::size_t open = 0, wanted = 0;
  for (const auto& slots : t_.neighbours) open += std::count(slots.begin(), slots.end(), no_index);
  for (const auto& loop : loops_)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      ++wanted;
      const Index a = loop[i], b = loop[(i + 1) % loop.size()];
      const Side* edge = find(a, b);
      if (!edge)
        report("the constraint {}-{} is not an edge", a, b);
      else if (t_.neighbours[edge->triangle][edge->slot] != no_index)
        report("the constraint {}-{} has a neighbour beyond", a, b);
    }
  if (open != wanted) report("{} edges without a neighbour, {} constraints", open, wanted);
}

// Euler's formula in the form of the angle sum: pi for a triangle, 2 pi around an inner point, pi (n - 2)
// along an outer loop of n points, pi (n + 2) along a hole. Where loops share a point their angles there
// overlap by full turns.
void Verifier::check_counts() {
  std::vector<char> use(t_.points.size(), 0);  // 1: in a triangle, 2: in a loop
  std::vector<double> angle(t_.points.size(), 0);
  std::vector<Index> visits(t_.points.size(), 0);
  for (const Triangle& triangle : t_.triangles)
    for (const Index i : triangle) use[i] |= 1;
  Index expected = 0;
  for (const auto& loop : loops_) {
    const std::size_t n = loop.size();
    expected += static_cast<Index>(n) + (loop_area(loop) > 0 ? -2 : 2);
    for (std::size_t k = 0; k < n; ++k) {
      const Vec2 p = point(loop[k]), out = point(loop[(k + 1) % n]) - p,
                 back = point(loop[(k + n - 1) % n]) - p;
      const double left = std::atan2(cross(out, back), dot(out, back));
      angle[loop[k]] += left < 0 ? left + 2 * pi : left;
      ++visits[loop[k]];
      use[loop[k]] |= 2;
    }
  }
  for (std::size_t i = 0; i < use.size(); ++i)
    if (visits[i] > 1) expected -= 2 * static_cast<Index>(angle[i] / (2 * pi));
  expected += 2 * static_cast<Index>(std::count(use.begin(), use.end(), 1));
  if (count() != expected) report("{} triangles, Euler's formula asks for {}", count(), expected);
  for (std::size_t i = 0; i < use.size(); ++i)
    if (use[i] == 0 && is_inside(t_.points[i])) report("point {} inside is in no triangle", i);
}

void Verifier::check_area() {
  double covered = 0, enclosed = 0, magnitude = 0;
  for (const auto& [a, b, c] : t_.triangles) covered += cross(point(b) - point(a), point(c) - point(a)) / 2;
  for (const auto& loop : loops_) {
    enclosed += loop_area(loop);
    for (const Index i : loop) magnitude = std::max(magnitude, squared_norm(point(i) - point(loop.front())));
  }
  if (!(std::abs(covered - enclosed) <= 1e-9 * magnitude))
    report("the triangles cover {}, the loops enclose {}", covered, enclosed);
}

bool Verifier::is_inside(Vec2 p) const {
  bool inside = false;
  for (const auto& loop : loops_)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = point(loop[i]), b = point(loop[(i + 1) % loop.size()]);
      if ((a.y <= p.y) == (b.y <= p.y)) continue;
      if ((orient2d(a, b, p) > 0) == (b.y > a.y)) inside = !inside;
    }
  return inside;
}

double Verifier::loop_area(const std::vector<Index>& loop) const {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    twice += cross(point(loop[i]) - point(loop[0]), point(loop[i + 1]) - point(loop[0]));
  return twice / 2;
}

}  // namespace

std::vector<std::string> verify_triangulation(const Triangulation& triangulation,
                                              const std::vector<std::vector<Index>>& loops) {
  return Verifier(triangulation, loops).run();
}

}  // namespace beadmesh
