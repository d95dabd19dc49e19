#include "beadmesh/medial/triangle_type.h"

#include <algorithm>

namespace beadmesh {

Circle circumcircle(Vec2 a, Vec2 b, Vec2 c) {
  const Vec2 u = b - a, v = c - a;
  const double area = 2 * cross(u, v), uu = squared_norm(u), vv = squared_norm(v);
  const double longest = std::max({uu, vv, squared_norm(c - b)});
  if (!(std::abs(area) > 1e-14 * longest)) {
    if (longest == uu) return {lerp(a, b, 0.5), std::sqrt(uu) / 2};
    if (longest == vv) return {lerp(a, c, 0.5), std::sqrt(vv) / 2};
    return {lerp(b, c, 0.5), std::sqrt(longest) / 2};
  }
  const Vec2 to_centre = Vec2{v.y * uu - u.y * vv, u.x * vv - v.x * uu} / area;
  return {a + to_centre, norm(to_centre)};
}

Index ear_tip(const Triangulation& triangulation, Index triangle) {
  for (int k = 0; k < 3; ++k)
    if (triangulation.neighbours[triangle][k] != no_index) return triangulation.triangles[triangle][k];
  return no_index;
}

std::vector<TriangleType> triangle_types(const Triangulation& triangulation, const BoundarySamples& samples) {
  std::vector<TriangleType> types;
  types.reserve(triangulation.triangles.size());
  for (std::size_t t = 0; t < triangulation.triangles.size(); ++t) {
    const auto& around = triangulation.neighbours[t];
    const auto outside = std::count(around.begin(), around.end(), no_index);
    if (outside == 0)
      types.push_back(TriangleType::J);
    else if (outside == 1)
      types.push_back(TriangleType::N);
    else if (outside == 3)
      types.push_back(TriangleType::isolated);
    else if (samples.samples[ear_tip(triangulation, static_cast<Index>(t))].corner)
      types.push_back(TriangleType::C);
    else
      types.push_back(TriangleType::S);
  }
  return types;
}

}  // namespace beadmesh
