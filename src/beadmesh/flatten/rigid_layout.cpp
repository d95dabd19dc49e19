#include "beadmesh/flatten/rigid_layout.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <limits>

namespace beadmesh {
namespace {

constexpr double max_cotangent = 1e5;  // keeps the matrix solvable in double precision
constexpr int mixing_depth = 8;        // previous steps that Anderson mixing looks back on

using Points = Eigen::Matrix<double, Eigen::Dynamic, 2>;

/// Rest edges (from corner k to k + 1) and the cotangents opposite to them.
struct Stencil {
  std::array<Vec2, 3> edge;
  std::array<double, 3> weight;
};

Stencil stencil_of(const RestTriangle& rest) {
  Stencil stencil;
  double greatest = 0;
  for (int k = 0; k < 3; ++k) {
    stencil.edge[k] = rest[(k + 1) % 3] - rest[k];
    stencil.weight[k] = dot(rest[k] - rest[(k + 2) % 3], rest[(k + 1) % 3] - rest[(k + 2) % 3]);
    greatest = std::max(greatest, std::abs(stencil.weight[k]));
  }
  const double area = std::max(doubled_area(rest[0], rest[1], rest[2]), greatest / max_cotangent);
  for (double& weight : stencil.weight) weight = area > 0 ? weight / area : 1;
  return stencil;
}

/// conj(a) * b of complex numbers.
Vec2 conjugate_product(Vec2 a, Vec2 b) {
  return {dot(a, b), cross(a, b)};
}
Vec2 product(Vec2 a, Vec2 b) {
  return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}

/// Largest t <= 1 up to which no triangle loses its sign on the way from `from` by t * step.
double step_to_first_flip(const std::vector<Triangle>& triangles, const std::vector<Vec2>& from,
                          const std::vector<Vec2>& step) {
  double limit = 1;
  for (const Triangle& t : triangles) {
    const Vec2 p = from[t[1]] - from[t[0]], q = from[t[2]] - from[t[0]];
    const Vec2 dp = step[t[1]] - step[t[0]], dq = step[t[2]] - step[t[0]];
    const double c = cross(p, q), b = cross(p, dq) + cross(dp, q), a = cross(dp, dq);
    if (c <= 0) continue;
    const double root = b * b - 4 * a * c;  // area(s) = a s^2 + b s + c
    if (root < 0) continue;
    const double denominator = -b + std::sqrt(root);  // stable form of the least positive root
    if (denominator > 0 && 2 * c / denominator < limit) limit = 2 * c / denominator;
  }
  return limit;
}

double largest_move(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, squared_norm(b[i] - a[i]));
  return std::sqrt(most);
}

Eigen::Map<const Eigen::VectorXd> as_vector(const std::vector<Vec2>& points) {
  static_assert(sizeof(Vec2) == 2 * sizeof(double));
  return {&points.data()->x, static_cast<Eigen::Index>(2 * points.size())};
}

/// Anderson mixing of a fixed-point iteration g(x): keeps the last differences of residuals and of images.
class Mixing {
 public:
  explicit Mixing(Eigen::Index size) : residuals_(size, mixing_depth), images_(size, mixing_depth) {}

  void forget() {
    count_ = 0;
    has_last_ = false;
  }

  /// The next x, from the current x and its image g.
  std::vector<Vec2> next(const std::vector<Vec2>& x, const std::vector<Vec2>& g) {
    const Eigen::VectorXd image = as_vector(g);
    const Eigen::VectorXd residual = image - as_vector(x);
    if (has_last_) {
      const Eigen::Index column = count_++ % mixing_depth;
      residuals_.col(column) = residual - last_residual_;
      images_.col(column) = image - last_image_;
    }
    last_residual_ = residual;
    last_image_ = image;
    has_last_ = true;
    const Eigen::Index used = std::min<Eigen::Index>(count_, mixing_depth);
    if (used == 0) return g;
    const auto differences = residuals_.leftCols(used);
    Eigen::MatrixXd gram = differences.transpose() * differences;
    gram.diagonal().array() += 1e-12 * gram.diagonal().maxCoeff() + std::numeric_limits<double>::min();
    const Eigen::VectorXd mix = gram.ldlt().solve(differences.transpose() * residual);
    const Eigen::VectorXd mixed = image - images_.leftCols(used) * mix;
    if (!mixed.allFinite()) return g;
    std::vector<Vec2> result(g.size());
    for (std::size_t i = 0; i < g.size(); ++i) result[i] = {mixed[2 * i], mixed[2 * i + 1]};
    return result;
  }

 private:
  Eigen::MatrixXd residuals_, images_;
  Eigen::VectorXd last_residual_, last_image_;
  Eigen::Index count_ = 0;
  bool has_last_ = false;
};

}  // namespace

struct RigidLayout::System {
  std::vector<Triangle> triangles;
  std::vector<Stencil> stencils;
  std::size_t point_count = 0;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;  // vertex 0 is fixed: row i is vertex i + 1

  void factor() {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(9 * triangles.size());
    const auto add = [&](Index row, Index column, double value) {
      if (row > 0 && column > 0 && row >= column) entries.emplace_back(row - 1, column - 1, value);
    };
    for (std::size_t t = 0; t < triangles.size(); ++t)
      for (int k = 0; k < 3; ++k) {
        const Index i = triangles[t][k], j = triangles[t][(k + 1) % 3];
        const double weight = stencils[t].weight[k];
        add(i, i, weight);
        add(j, j, weight);
        add(std::max(i, j), std::min(i, j), -weight);
      }
    const auto size = static_cast<Eigen::Index>(point_count) - 1;
    Eigen::SparseMatrix<double> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    solver.compute(matrix);
  }
};

RigidLayout::RigidLayout(std::size_t point_count, const std::vector<Triangle>& triangles,
                         std::vector<RestTriangle> rest)
    : system_(std::make_unique<System>()) {
  system_->triangles = triangles;
  system_->point_count = point_count;
  system_->stencils.reserve(rest.size());
  for (const RestTriangle& triangle : rest) system_->stencils.push_back(stencil_of(triangle));
  system_->factor();
}

RigidLayout::~RigidLayout() = default;

bool RigidLayout::is_ready() const {
  return system_->solver.info() == Eigen::Success;
}

std::vector<Vec2> RigidLayout::rotations(const std::vector<Vec2>& positions, double* energy) const {
  std::vector<Vec2> turns(system_->triangles.size());
  double sum = 0;
  for (std::size_t t = 0; t < turns.size(); ++t) {
    const Triangle& triangle = system_->triangles[t];
    const Stencil& stencil = system_->stencils[t];
    Vec2 turn;
    double squares = 0;
    for (int k = 0; k < 3; ++k) {
      const Vec2 image = positions[triangle[(k + 1) % 3]] - positions[triangle[k]];
      turn += stencil.weight[k] * conjugate_product(stencil.edge[k], image);
      squares += stencil.weight[k] * (squared_norm(image) + squared_norm(stencil.edge[k]));
    }
    const double length = norm(turn);
    turns[t] = length > 0 ? turn / length : Vec2{1, 0};
    sum += squares - 2 * length;
  }
  if (energy) *energy = sum;
  return turns;
}

std::vector<Vec2> RigidLayout::assembled(const std::vector<Vec2>& rotations) const {
  const auto size = static_cast<Eigen::Index>(system_->point_count);
  Points right = Points::Zero(size, 2);
  for (std::size_t t = 0; t < rotations.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Vec2 pull = system_->stencils[t].weight[k] * product(rotations[t], system_->stencils[t].edge[k]);
      const Index i = system_->triangles[t][k], j = system_->triangles[t][(k + 1) % 3];
      right(i, 0) -= pull.x;
      right(i, 1) -= pull.y;
      right(j, 0) += pull.x;
      right(j, 1) += pull.y;
    }
  const Points solution = system_->solver.solve(right.bottomRows(size - 1));
  std::vector<Vec2> positions(system_->point_count);
  for (Eigen::Index i = 1; i < size; ++i) positions[i] = {solution(i - 1, 0), solution(i - 1, 1)};
  return positions;
}

std::vector<Vec2> RigidLayout::relaxed(std::vector<Vec2> positions, int iterations, double tolerance) const {
  Mixing mixing(static_cast<Eigen::Index>(2 * system_->point_count));
  const Vec2 origin = positions[0];
  for (Vec2& p : positions) p = p - origin;
  std::vector<Vec2> plain = positions;  // the last image of the plain iteration
  double last_energy = std::numeric_limits<double>::max();
  for (int i = 0; i < iterations; ++i) {
    double energy = 0;
    std::vector<Vec2> turns = rotations(positions, &energy);
    if (energy > last_energy) {
      positions = plain;
      mixing.forget();
      turns = rotations(positions, &energy);
    }
    last_energy = energy;
    plain = assembled(turns);
    if (largest_move(positions, plain) <= tolerance) break;
    positions = mixing.next(positions, plain);
  }
  return plain;
}

std::vector<Vec2> RigidLayout::relaxed_without_flips(std::vector<Vec2> positions, int iterations,
                                                     double tolerance) const {
  std::vector<Vec2> step(positions.size());
  for (int i = 0; i < iterations; ++i) {
    const std::vector<Vec2> target = assembled(rotations(positions));
    const Vec2 origin = positions[0];
    for (std::size_t v = 0; v < step.size(); ++v) step[v] = target[v] + origin - positions[v];
    const double limit = step_to_first_flip(system_->triangles, positions, step);
    const double length = limit < 1 ? 0.8 * limit : 1;
    double most = 0;
    for (std::size_t v = 0; v < step.size(); ++v) {
      positions[v] += step[v] * length;
      most = std::max(most, norm(step[v]) * length);
    }
    if (most <= tolerance) break;
  }
  return positions;
}

}  // namespace beadmesh
