// A facetted piece of the skin: one face, or several faces joined into a composite face.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh {

/// The exact surface under a face. Const calls are safe from several threads.
class SurfaceEvaluator {
 public:
  virtual ~SurfaceEvaluator() = default;
  virtual Vec3 point(Vec2 uv) const = 0;
  /// Unit normal on the side of the face's orientation; zero where the surface is singular.
  virtual Vec3 normal(Vec2 uv) const = 0;
};

/// Connected, oriented, manifold triangulation with one or more boundary loops.
struct Facets {
  std::vector<Vec3> points;                      ///< local vertices
  std::vector<Index> panel_points;               ///< per local vertex its index in Panel::points
  std::vector<Triangle> triangles;               ///< local vertices, counter-clockwise about the normal
  std::vector<std::array<Vec2, 3>> triangle_uv;  ///< surface parameters of the corners; empty: facets only
  std::vector<Index> triangle_surface;           ///< per triangle, index in `surfaces`
  std::vector<std::vector<Index>>
      loops;  ///< closed, first vertex not repeated, face on the left; outer first
  std::vector<std::shared_ptr<const SurfaceEvaluator>> surfaces;  ///< one for each face joined; null: none
};

/// Triangles on shared points (indices into `points`, which become panel_points) as facets of their own:
/// local vertices, loops traced, outer first; triangles keep their order. A point where the piece only
/// touches itself becomes several vertices. No uv, no faces.
Facets facets_of_triangles(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);

/// Unit normal at corner k of a triangle: of the exact surface where there is one, else of the triangle.
Vec3 corner_normal(const Facets& facets, Index triangle, int k);

/// Sum of the area vectors of the triangles, mm^2; its direction is the mean normal.
Vec3 vector_area(const Facets& facets);

/// Sum of the triangles' areas, mm^2.
double area(const Facets& facets);

/// Position in `loops` of the outer one: the largest area about the mean normal; on a piece that closes
/// around itself (a tube, whose mean normal vanishes) the longest. 0 where there is none.
std::size_t outer_loop(const Facets& facets);

}  // namespace beadmesh
