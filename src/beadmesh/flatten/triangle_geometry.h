// The shape of single triangles: in their own plane, and what a map into the plane does to them.
#pragma once

#include <array>
#include <vector>

#include "beadmesh/panel/facets.h"

namespace beadmesh {

/// Corners of a triangle of space in its own plane: first corner at the origin, second on the positive x
/// axis, third with y >= 0.
using RestTriangle = std::array<Vec2, 3>;

RestTriangle rest_triangle(Vec3 a, Vec3 b, Vec3 c);

inline RestTriangle rest_triangle(const Facets& facets, Index t) {
  const Triangle& corners = facets.triangles[t];
  return rest_triangle(facets.points[corners[0]], facets.points[corners[1]], facets.points[corners[2]]);
}

/// Twice the signed area.
inline double doubled_area(Vec2 a, Vec2 b, Vec2 c) {
  return cross(b - a, c - a);
}

double longest_edge(const RestTriangle& triangle);
/// Twice the area over the longest edge; 0 for a point.
double least_height(const RestTriangle& triangle);

/// Singular values of the linear map that takes a triangle into the plane; `least` is negative where it turns
/// over.
struct SingularValues {
  double greatest = 1, least = 1;
};

/// From `rest` to `image`. rest must have an area.
SingularValues singular_values(const RestTriangle& rest, const RestTriangle& image);

/// Length of the diagonal of the bounding box.
double diagonal(const std::vector<Vec3>& points);

/// A right-handed frame; x and y span a plane.
struct PlaneFrame {
  Vec3 x, y, normal;

  Vec2 project(Vec3 p) const { return {dot(p, x), dot(p, y)}; }
};

/// The plane of the mean facet normal through the global origin; x is the projection of the global x axis (of
/// the y axis where that is almost normal to the plane), so that a flat sheet z = const keeps its
/// coordinates. Facets whose normals cancel out (a whole cylinder) take the normal of their largest triangle.
PlaneFrame mean_plane(const Facets& facets);

}  // namespace beadmesh
