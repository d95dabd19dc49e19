// Quality of single elements, in the definitions that pre-processors use.
#pragma once

#include <array>
#include <vector>

#include "beadmesh/core/vector.h"
#include "beadmesh/mesh/planar_mesh.h"

namespace beadmesh {

/// Mean normal of an element; its length is twice the area of a plane one.
Vec3 area_normal(const std::vector<Vec3>& nodes, const MeshElement& element);
/// Smallest corner cross product of unit edges against the element's mean normal (Verdict; triangles times
/// 2/sqrt(3)). 1 is a square, 0 and below is inverted.
double scaled_jacobian(const std::vector<Vec3>& nodes, const MeshElement& element);
/// Least over largest determinant at the 2 x 2 Gauss points of the bilinear map whose corners have these
/// determinants (areas of the parallelograms of the two sides there); 0 where none is positive.
double jacobian_ratio(const std::array<double, 4>& corner_areas);
/// The same of an element, seen along its mean normal; 1 for a triangle. What programs call its Jacobian.
double jacobian_ratio(const std::vector<Vec3>& nodes, const MeshElement& element);
/// Smallest and largest corner angle, radians.
std::array<double, 2> corner_angles(const std::vector<Vec3>& nodes, const MeshElement& element);
/// Largest angle between the two triangles of a quad over both diagonals, radians; 0 for a triangle.
double warpage(const std::vector<Vec3>& nodes, const MeshElement& element);
/// Shortest and longest side.
std::array<double, 2> side_lengths(const std::vector<Vec3>& nodes, const MeshElement& element);

struct QualitySummary {
  int nodes = 0, quads = 0, trias = 0;
  double scaled_jacobian_min = 1, scaled_jacobian_mean = 1;
  double edge_min = 0, edge_max = 0;
  double warpage_max = 0;  ///< degrees
  int warped_over_15 = 0;
  int inverted = 0;
  int edges_below_min = 0;  ///< against the min_edge given
  int irregular = 0;        ///< inner nodes without exactly four quads
};

QualitySummary summarise(const std::vector<Vec3>& nodes, const std::vector<MeshElement>& elements,
                         double min_edge);

}  // namespace beadmesh
