#include "beadmesh/flatten/flat_start.h"

#include <Eigen/SparseCholesky>
#include <algorithm>

namespace beadmesh {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// An edge between triangles a < b: unrolled, the angle of b is the angle of a plus `turn`. `weight`: how
/// stiff.
struct Hinge {
  Index a, b;
  double turn, weight;
};

double wrapped(double angle) {
  return std::remainder(angle, 2 * pi);
}

std::vector<Hinge> hinges_of(const std::vector<Triangle>& triangles, const TriangleNeighbours& neighbours,
                             const std::vector<RestTriangle>& rest,
                             std::vector<std::array<Index, 3>>& hinge_at) {
  std::vector<Hinge> hinges;
  const auto count = static_cast<Index>(triangles.size());
  hinge_at.assign(triangles.size(), {no_index, no_index, no_index});
  for (Index t = 0; t < count; ++t)
    for (int k = 0; k < 3; ++k) {
      const Index other = neighbours[t][k];
      if (other == no_index || hinge_at[t][k] != no_index) continue;
      int back = 0;  // the same edge in the other triangle
      while (triangles[other][back] != triangles[t][(k + 1) % 3] || neighbours[other][back] != t) ++back;
      const Vec2 here = rest[t][(k + 1) % 3] - rest[t][k];
      const Vec2 there = rest[other][back] - rest[other][(back + 1) % 3];
      const double areas = doubled_area(rest[t][0], rest[t][1], rest[t][2]) +
                           doubled_area(rest[other][0], rest[other][1], rest[other][2]);
      const double squared = squared_norm(here);
      hinge_at[t][k] = hinge_at[other][back] = static_cast<Index>(hinges.size());
      hinges.push_back({t, other, std::atan2(here.y, here.x) - std::atan2(there.y, there.x),
                        squared > 0 ? squared / std::max(areas, 1e-6 * squared) : 1e-6});
    }
  return hinges;
}

std::vector<double> breadth_first_angles(const TriangleNeighbours& neighbours,
                                         const std::vector<Hinge>& hinges,
                                         const std::vector<std::array<Index, 3>>& hinge_at, Index start) {
  std::vector<double> angle(neighbours.size(), 0);
  std::vector<bool> seen(neighbours.size(), false);
  std::vector<Index> queue{start};
  seen[start] = true;
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const Index t = queue[head];
    for (int k = 0; k < 3; ++k) {
      const Index other = neighbours[t][k];
      if (other == no_index || seen[other]) continue;
      const Hinge& hinge = hinges[hinge_at[t][k]];
      angle[other] = angle[t] + (hinge.a == t ? hinge.turn : -hinge.turn);
      seen[other] = true;
      queue.push_back(other);
    }
  }
  return angle;
}

/// Adds to the angles the correction that spreads the misfits of all hinges. Triangle 0 keeps its angle.
void spread_misfits(const std::vector<Hinge>& hinges, std::vector<double>& angle) {
  const auto size = static_cast<Eigen::Index>(angle.size()) - 1;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(size);
  double worst = 0;
  for (const Hinge& hinge : hinges) {
    const double misfit = wrapped(angle[hinge.b] - angle[hinge.a] - hinge.turn);
    worst = std::max(worst, std::abs(misfit));
    if (hinge.a > 0) {
      entries.emplace_back(hinge.a - 1, hinge.a - 1, hinge.weight);
      right[hinge.a - 1] += hinge.weight * misfit;
    }
    if (hinge.b > 0) {
      entries.emplace_back(hinge.b - 1, hinge.b - 1, hinge.weight);
      right[hinge.b - 1] -= hinge.weight * misfit;
    }
    if (hinge.a > 0 && hinge.b > 0)
      entries.emplace_back(std::max(hinge.a, hinge.b) - 1, std::min(hinge.a, hinge.b) - 1, -hinge.weight);
  }
  if (worst < 1e-12) return;
  SparseMatrix matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<SparseMatrix> solver(matrix);
  if (solver.info() != Eigen::Success) return;
  const Eigen::VectorXd correction = solver.solve(right);
  for (Eigen::Index i = 0; i < size; ++i) angle[i + 1] += correction[i];
}

/// Peels the piece from its boundary inwards: the triangle reached last lies deepest.
Index central_triangle(const std::vector<Triangle>& triangles, const TriangleNeighbours& neighbours) {
  std::vector<bool> seen(triangles.size(), false);
  std::vector<Index> queue;
  for (Index t = 0; t < static_cast<Index>(triangles.size()); ++t)
    if (std::count(neighbours[t].begin(), neighbours[t].end(), no_index) > 0) {
      seen[t] = true;
      queue.push_back(t);
    }
  for (std::size_t head = 0; head < queue.size(); ++head)
    for (const Index other : neighbours[queue[head]])
      if (other != no_index && !seen[other]) {
        seen[other] = true;
        queue.push_back(other);
      }
  return queue.empty() ? 0 : queue.back();
}

/// Positions of a closed polyline of space on a circle, spaced as its segments are long, counter-clockwise.
std::vector<Vec2> on_circle(const Facets& facets, const std::vector<Index>& loop) {
  std::vector<double> along{0};
  double mean = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    mean += distance(facets.points[loop[i]], facets.points[loop[(i + 1) % loop.size()]]) /
            static_cast<double>(loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double length = distance(facets.points[loop[i]], facets.points[loop[(i + 1) % loop.size()]]);
    along.push_back(along.back() + std::max(length, 1e-3 * mean));
  }
  const double radius = along.back() / (2 * pi);
  std::vector<Vec2> positions;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double angle = along[i] / (radius > 0 ? radius : 1);
    positions.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return positions;
}

std::vector<std::pair<Index, Index>> edges_with_fans(const Facets& facets) {
  std::vector<std::pair<Index, Index>> edges;
  for (const Triangle& t : facets.triangles)
    for (int k = 0; k < 3; ++k) edges.emplace_back(std::minmax(t[k], t[(k + 1) % 3]));
  for (std::size_t l = 1; l < facets.loops.size(); ++l)
    for (const Index v : facets.loops[l])
      edges.emplace_back(v, static_cast<Index>(facets.points.size() + l - 1));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace

std::vector<Vec2> unrolled_rotations(const std::vector<Triangle>& triangles,
                                     const TriangleNeighbours& neighbours,
                                     const std::vector<RestTriangle>& rest, const std::vector<Vec2>& guess) {
  std::vector<std::array<Index, 3>> hinge_at;
  const std::vector<Hinge> hinges = hinges_of(triangles, neighbours, rest, hinge_at);
  std::vector<double> angle;
  if (guess.empty())
    angle = breadth_first_angles(neighbours, hinges, hinge_at, central_triangle(triangles, neighbours));
  for (const Vec2 turn : guess) angle.push_back(std::atan2(turn.y, turn.x));
  if (triangles.size() > 1) spread_misfits(hinges, angle);
  std::vector<Vec2> rotations(angle.size());
  for (std::size_t t = 0; t < angle.size(); ++t) rotations[t] = {std::cos(angle[t]), std::sin(angle[t])};
  return rotations;
}

std::optional<std::vector<Vec2>> tutte_layout(const Facets& facets) {
  const std::size_t count = facets.points.size() + facets.loops.size() - 1;  // a virtual vertex in every hole
  std::vector<Vec2> positions(count);
  std::vector<Index> row(count, 0);
  const std::vector<Vec2> circle = on_circle(facets, facets.loops[0]);
  for (std::size_t i = 0; i < circle.size(); ++i) {
    positions[facets.loops[0][i]] = circle[i];
    row[facets.loops[0][i]] = no_index;
  }
  Index size = 0;
  for (Index& r : row)
    if (r != no_index) r = size++;
  if (size > 0) {
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::Matrix<double, Eigen::Dynamic, 2> right = Eigen::Matrix<double, Eigen::Dynamic, 2>::Zero(size, 2);
    const auto pull = [&](Index v, Index to) {
      if (row[v] == no_index) return;
      entries.emplace_back(row[v], row[v], 1.0);
      if (row[to] == no_index)
        right.row(row[v]) += Eigen::RowVector2d(positions[to].x, positions[to].y);
      else if (row[v] > row[to])
        entries.emplace_back(row[v], row[to], -1.0);
    };
    for (const auto& [a, b] : edges_with_fans(facets)) {
      pull(a, b);
      pull(b, a);
    }
    SparseMatrix matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<SparseMatrix> solver(matrix);
    if (solver.info() != Eigen::Success) return std::nullopt;
    const Eigen::Matrix<double, Eigen::Dynamic, 2> solution = solver.solve(right);
    for (std::size_t v = 0; v < count; ++v)
      if (row[v] != no_index) positions[v] = {solution(row[v], 0), solution(row[v], 1)};
  }
  positions.resize(facets.points.size());
  return positions;
}

}  // namespace beadmesh
