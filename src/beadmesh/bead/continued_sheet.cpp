#include "beadmesh/bead/continued_sheet.h"

#include <Eigen/Dense>
#include <algorithm>
#include <vector>

namespace beadmesh {
namespace {

struct Contact {
  Vec3 point, normal;
};

/// One for each corner on the loop.
std::vector<Contact> contacts_of(const Facets& sheet, std::size_t loop) {
  std::vector<bool> on_loop(sheet.points.size(), false);
  for (const Index v : sheet.loops[loop]) on_loop[v] = true;
  std::vector<Contact> contacts;
  for (Index t = 0; t < Index(sheet.triangles.size()); ++t)
    for (int k = 0; k < 3; ++k)
      if (const Index v = sheet.triangles[t][k]; on_loop[v])
        contacts.push_back({sheet.points[v], corner_normal(sheet, t, k)});
  return contacts;
}

}  // namespace

ContinuedSheet::ContinuedSheet(const Facets& sheet, std::size_t loop) {
  const std::vector<Contact> contacts = contacts_of(sheet, loop);
  for (const Contact& c : contacts) {
    origin_ += c.point / double(contacts.size());
    up_ += c.normal;
  }
  up_ = normalized(up_);
  x_ = normalized(cross(std::abs(up_.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}, up_));
  y_ = cross(up_, x_);
  for (const Contact& c : contacts) scale_ = std::max(scale_, distance(c.point, origin_));

  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Identity() * 1e-9;
  Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
  const auto add = [&](const Eigen::Matrix<double, 6, 1>& row, double value) {
    matrix += row * row.transpose();
    right += row * value;
  };
  for (const Contact& c : contacts) {
    const Vec2 p = plan(c.point);
    add({1, p.x, p.y, p.x * p.x, p.x * p.y, p.y * p.y}, dot(c.point - origin_, up_) / scale_);
    const double rise = std::max(0.1, dot(c.normal, up_));
    add({0, 1, 0, 2 * p.x, p.y, 0}, -dot(c.normal, x_) / rise);
    add({0, 0, 1, 0, p.x, 2 * p.y}, -dot(c.normal, y_) / rise);
  }
  const Eigen::Matrix<double, 6, 1> solution = matrix.ldlt().solve(right);
  for (int i = 0; i < 6; ++i) coefficients_[i] = solution[i];
}

Vec2 ContinuedSheet::plan(Vec3 point) const {
  return {dot(point - origin_, x_) / scale_, dot(point - origin_, y_) / scale_};
}

double ContinuedSheet::height(Vec3 point) const {
  const Vec2 p = plan(point);
  const auto& c = coefficients_;
  return dot(point - origin_, up_) -
         scale_ * (c[0] + c[1] * p.x + c[2] * p.y + c[3] * p.x * p.x + c[4] * p.x * p.y + c[5] * p.y * p.y);
}

Vec3 ContinuedSheet::normal(Vec3 point) const {
  const Vec2 p = plan(point);
  const auto& c = coefficients_;
  return normalized(up_ - x_ * (c[1] + 2 * c[3] * p.x + c[4] * p.y) -
                    y_ * (c[2] + c[4] * p.x + 2 * c[5] * p.y));
}

}  // namespace beadmesh
