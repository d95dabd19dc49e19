#include "beadmesh/geometry/quadratic_sheet.h"

#include <Eigen/Dense>
#include <algorithm>

namespace beadmesh {
QuadraticSheet::QuadraticSheet(const std::vector<SheetContact>& contacts) {
  for (const SheetContact& c : contacts) {
    origin_ += c.point / double(contacts.size());
    up_ += c.normal;
  }
  up_ = normalized(up_);
  x_ = normalized(cross(std::abs(up_.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, up_));
  y_ = cross(up_, x_);
  for (const SheetContact& c : contacts) scale_ = std::max(scale_, distance(c.point, origin_));

  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Identity() * 1e-9;
  Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
  const auto add = [&](const Eigen::Matrix<double, 6, 1>& row, double value) {
    matrix += row * row.transpose();
    right += row * value;
  };
  for (const SheetContact& c : contacts) {
    const Vec2 p = plan(c.point);
    add({1, p.x, p.y, p.x * p.x, p.x * p.y, p.y * p.y}, dot(c.point - origin_, up_) / scale_);
    const double rise = std::max(0.1, dot(c.normal, up_));
    add({0, 1, 0, 2 * p.x, p.y, 0}, -dot(c.normal, x_) / rise);
    add({0, 0, 1, 0, p.x, 2 * p.y}, -dot(c.normal, y_) / rise);
  }
  const Eigen::Matrix<double, 6, 1> solution = matrix.ldlt().solve(right);
  for (int i = 0; i < 6; ++i) coefficients_[i] = solution[i];
}

Vec2 QuadraticSheet::plan(Vec3 point) const {
  return {dot(point - origin_, x_) / scale_, dot(point - origin_, y_) / scale_};
}

double QuadraticSheet::height(Vec3 point) const {
  const Vec2 p = plan(point);
  const auto& c = coefficients_;
  return dot(point - origin_, up_) -
         scale_ * (c[0] + c[1] * p.x + c[2] * p.y + c[3] * p.x * p.x + c[4] * p.x * p.y + c[5] * p.y * p.y);
}

Vec3 QuadraticSheet::normal(Vec3 point) const {
  const Vec2 p = plan(point);
  const auto& c = coefficients_;
  return normalized(up_ - x_ * (c[1] + 2 * c[3] * p.x + c[4] * p.y) -
                    y_ * (c[2] + c[4] * p.x + 2 * c[5] * p.y));
}

}  // namespace beadmesh
