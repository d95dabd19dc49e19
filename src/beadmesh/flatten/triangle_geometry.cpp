#include "beadmesh/flatten/triangle_geometry.h"

#include <algorithm>

namespace beadmesh {

RestTriangle rest_triangle(Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 side = b - a, other = c - a;
  const double length = norm(side);
  if (length == 0) return {Vec2{0, 0}, Vec2{0, 0}, Vec2{norm(other), 0}};
  return {Vec2{0, 0}, Vec2{length, 0}, Vec2{dot(other, side) / length, norm(cross(side, other)) / length}};
}

double longest_edge(const RestTriangle& triangle) {
  return std::max({distance(triangle[0], triangle[1]), distance(triangle[1], triangle[2]),
                   distance(triangle[2], triangle[0])});
}

double least_height(const RestTriangle& triangle) {
  const double longest = longest_edge(triangle);
  return longest > 0 ? doubled_area(triangle[0], triangle[1], triangle[2]) / longest : 0;
}

SingularValues singular_values(const RestTriangle& rest, const RestTriangle& image) {
  const Vec2 p = rest[1] - rest[0], q = rest[2] - rest[0];
  const Vec2 u = image[1] - image[0], v = image[2] - image[0];
  const double area = cross(p, q);
  const Vec2 dx = (u * q.y - v * p.y) / area;  // images of the unit vectors
  const Vec2 dy = (v * p.x - u * q.x) / area;
  // The map z -> a z + b conj(z) has the singular values |a| + |b| and |a| - |b|.
  const double a = std::hypot(dx.x + dy.y, dx.y - dy.x) / 2, b = std::hypot(dx.x - dy.y, dx.y + dy.x) / 2;
  return {a + b, a - b};
}

double diagonal(const std::vector<Vec3>& points) {
  if (points.empty()) return 0;
  Vec3 low = points[0], high = points[0];
  for (const Vec3 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return distance(low, high);
}

PlaneFrame mean_plane(const Facets& facets) {
  Vec3 sum, largest;
  double area = 0;
  for (const Triangle& t : facets.triangles) {
    const Vec3 a = facets.points[t[0]];
    const Vec3 vector = cross(facets.points[t[1]] - a, facets.points[t[2]] - a);
    sum += vector;
    area += norm(vector);
    if (squared_norm(vector) > squared_norm(largest)) largest = vector;
  }
  PlaneFrame frame;
  frame.normal = normalized(norm(sum) > 1e-3 * area ? sum : largest);
  if (squared_norm(frame.normal) == 0) frame.normal = {0, 0, 1};
  const Vec3 axis = std::abs(frame.normal.x) < 0.99 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  frame.x = normalized(axis - frame.normal * dot(axis, frame.normal));
  frame.y = cross(frame.normal, frame.x);
  return frame;
}

}  // namespace beadmesh
