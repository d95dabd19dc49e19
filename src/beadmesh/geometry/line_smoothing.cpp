#include "beadmesh/geometry/line_smoothing.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

constexpr double corner_weight = 1e4;
constexpr double outlier = 2;  // of the median distance

using Matrix = Eigen::SparseMatrix<double>;

/// Squared second differences of a closed line, none over a corner.
Matrix bending(const std::vector<bool>& corners, double price) {
  const int n = static_cast<int>(corners.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    if (corners[i]) continue;
    const std::array<int, 3> at{(i + n - 1) % n, i, (i + 1) % n};
    const std::array<double, 3> factor{1, -2, 1};
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) entries.emplace_back(at[a], at[b], price * factor[a] * factor[b]);
  }
  Matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// Of each point, from how far the line has left it, compared with the points within `reach` places.
std::vector<double> weights(const std::vector<Vec3>& points, const std::vector<Vec3>& line, int reach,
                            double least) {
  const int n = static_cast<int>(points.size());
  std::vector<double> off, result;
  for (int i = 0; i < n; ++i) off.push_back(distance(points[i], line[i]));
  for (int i = 0; i < n; ++i) {
    std::vector<double> around;
    for (int k = -reach; k <= reach; ++k) around.push_back(off[(i + k + n) % n]);
    const double usual = std::max(least, outlier * median(std::move(around)));
    const double root = 1 / (1 + off[i] * off[i] / (usual * usual));
    result.push_back(root * root);
  }
  return result;
}

}  // namespace

std::vector<Vec3> smoothed_line(const std::vector<Vec3>& points, double step,
                                const std::vector<bool>& corners, const LineSmoothingOptions& options) {
  const int n = static_cast<int>(points.size());
  if (n < 5) return points;
  const Matrix stiff =
      bending(corners, std::pow(2 * std::sin(std::min(0.5, step / options.wavelength) * pi), -4));
  const int reach = std::min(n / 2, static_cast<int>(options.wavelength / step));
  std::vector<double> weight(n, 1);
  std::vector<Vec3> line = points;
  for (int round = 0; round < options.rounds; ++round) {
    Matrix matrix = stiff;
    Eigen::MatrixX3d right(n, 3);
    for (int i = 0; i < n; ++i) {
      const double w = corners[i] ? corner_weight : std::max(weight[i], 1e-4);
      matrix.coeffRef(i, i) += w;
      right.row(i) = Eigen::RowVector3d(points[i].x, points[i].y, points[i].z) * w;
    }
    const Eigen::SimplicialLDLT<Matrix> solver(matrix);
    if (solver.info() != Eigen::Success) return points;
    const Eigen::MatrixX3d found = solver.solve(right);
    for (int i = 0; i < n; ++i) line[i] = {found(i, 0), found(i, 1), found(i, 2)};
    weight = weights(points, line, reach, options.least_noise);
  }
  return line;
}

}  // namespace beadmesh
