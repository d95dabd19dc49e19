#include "beadmesh/report/picture_view.h"

#include <cmath>

namespace beadmesh::drawing {
namespace {

double largest_component(Vec3 v) {
  double best = v.x;
  for (const double c : {v.y, v.z})
    if (std::abs(c) > std::abs(best)) best = c;
  return best;
}

}  // namespace

PictureView view_along(Vec3 eye) {
  eye = normalized(eye);
  const Vec3 side = std::abs(eye.x) < 0.8 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 right = normalized(side - eye * dot(side, eye));
  return {right, cross(eye, right), eye};
}

PictureView view_of_area(Vec3 sum, double area) {
  if (!(norm(sum) > 0.05 * area)) sum = {0, 0, 1};
  return view_along(largest_component(sum) < 0 ? -sum : sum);
}

}  // namespace beadmesh::drawing
