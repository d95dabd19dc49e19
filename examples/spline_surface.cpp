#include "examples/spline_surface.h"

#include <Eigen/Dense>
#include <Eigen/SparseLU>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <algorithm>
#include <array>

namespace beadmesh::examples {
namespace {

/// Interpolation by cubic B-splines at given parameters; the second and the last but one are no knots.
class CubicInterpolation {
 public:
  explicit CubicInterpolation(const std::vector<double>& parameters) {
    const int n = int(parameters.size());
    knots_.assign(parameters.begin() + 2, parameters.end() - 2);
    knots_.insert(knots_.begin(), 4, parameters.front());
    knots_.insert(knots_.end(), 4, parameters.back());
    std::vector<Eigen::Triplet<double>> entries;
    for (int row = 0; row < n; ++row) {
      const int span = find_span(parameters[row]);
      const std::array<double, 4> values = basis(span, parameters[row]);
      for (int k = 0; k < 4; ++k) entries.emplace_back(row, span - 3 + k, values[k]);
    }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    solver_.compute(matrix);
  }

  /// Poles of each column's spline.
  Eigen::MatrixXd poles(const Eigen::MatrixXd& values) const { return solver_.solve(values); }

  void occ_knots(TColStd_Array1OfReal& knots, TColStd_Array1OfInteger& multiplicities) const {
    for (int i = 1; i <= knots.Length(); ++i) {
      knots(i) = knots_[i + 2];
      multiplicities(i) = i == 1 || i == knots.Length() ? 4 : 1;
    }
  }
  int knot_count() const { return int(knots_.size()) - 6; }

 private:
  /// Index of the span that holds t; the last span is closed on the right.
  int find_span(double t) const {
    return int(std::upper_bound(knots_.begin() + 3, knots_.end() - 4, t) - knots_.begin()) - 1;
  }
  /// The four basis functions that do not vanish on the span (Cox, de Boor).
  std::array<double, 4> basis(int span, double t) const {
    std::array<double, 4> values{1, 0, 0, 0};
    for (int degree = 1; degree <= 3; ++degree) {
      double saved = 0;
      for (int k = 0; k < degree; ++k) {
        const double right = knots_[span + k + 1], left = knots_[span + k + 1 - degree];
        const double share = values[k] / (right - left);
        values[k] = saved + (right - t) * share;
        saved = (t - left) * share;
      }
      values[degree] = saved;
    }
    return values;
  }

  std::vector<double> knots_;
  Eigen::SparseLU<Eigen::SparseMatrix<double>> solver_;
};

}  // namespace

std::vector<double> even_steps(double from, double to, int count) {
  std::vector<double> values;
  for (int i = 0; i <= count; ++i) values.push_back(from + (to - from) * i / count);
  return values;
}

Handle(Geom_BSplineSurface) spline_through(const std::vector<double>& us, const std::vector<double>& vs,
                                           const std::vector<Vec3>& points) {
  const int rows = int(us.size()), columns = int(vs.size());
  const CubicInterpolation along_u(us), along_v(vs);
  std::array<Eigen::MatrixXd, 3> poles;
  for (int c = 0; c < 3; ++c) {
    Eigen::MatrixXd values(rows, columns);
    for (int i = 0; i < rows; ++i)
      for (int j = 0; j < columns; ++j) {
        const Vec3 p = points[std::size_t(i) * columns + j];
        values(i, j) = c == 0 ? p.x : c == 1 ? p.y : p.z;
      }
    poles[c] = along_v.poles(along_u.poles(values).transpose()).transpose();
  }
  TColgp_Array2OfPnt net(1, rows, 1, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) net(i + 1, j + 1) = {poles[0](i, j), poles[1](i, j), poles[2](i, j)};
  TColStd_Array1OfReal u_knots(1, along_u.knot_count()), v_knots(1, along_v.knot_count());
  TColStd_Array1OfInteger u_counts(1, along_u.knot_count()), v_counts(1, along_v.knot_count());
  along_u.occ_knots(u_knots, u_counts);
  along_v.occ_knots(v_knots, v_counts);
  return new Geom_BSplineSurface(net, u_knots, v_knots, u_counts, v_counts, 3, 3);
}

}  // namespace beadmesh::examples
