// Inside the read room: loose triangles welded into a skin that knows its neighbours.
#pragma once

#include <array>
#include <vector>

#include "beadmesh/core/diagnostic.h"
#include "beadmesh/core/vector.h"

namespace beadmesh {

/// Triangles as a file has them: corners in space, mm.
struct LooseFacets {
  std::vector<std::array<Vec3, 3>> corners;
  std::vector<Index> parts;  ///< per triangle, any number; may be empty: the file knows of none
};

/// A skin of triangles. Half-edge 3 t + k runs from corner k of triangle t to its next.
struct FacetMesh {
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  std::vector<Index> parts;  ///< per triangle; no_index: none
  std::vector<Index>
      partner;  ///< per half-edge the one on the other side, which runs the other way, or no_index
  std::vector<Vec3> area_vectors;   ///< per triangle: normal times area, mm^2
  std::vector<Diagnostic> repairs;  ///< what was turned over or left out

  Index triangle_count() const { return static_cast<Index>(triangles.size()); }
  static constexpr Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
  Index tail(Index h) const { return triangles[h / 3][h % 3]; }
  Index head(Index h) const { return tail(next(h)); }
  /// Triangle beyond a half-edge, or no_index.
  Index beyond(Index h) const { return partner[h] == no_index ? no_index : partner[h] / 3; }
  double area(Index t) const { return norm(area_vectors[t]); }
  double length(Index h) const { return distance(points[tail(h)], points[head(h)]); }
  /// Over the longest side.
  double lowest_height(Index t) const;
  Vec3 centre(Index t) const {
    const Triangle& v = triangles[t];
    return (points[v[0]] + points[v[1]] + points[v[2]]) / 3;
  }
  /// Angle between the normals on the two sides of a half-edge that has a partner, radians; 0 beside a
  /// triangle without area.
  double turn(Index h) const;
  /// The lower height over the shared edge of the two triangles: how far a turn reaches at least.
  double reach(Index h) const;
};

Vec3 area_vector(const std::vector<Vec3>& points, const Triangle& triangle);

/// Makes partners of the two half-edges between the same two points. Three and more have none, nor do two
/// that run the same way unless `any_direction`.
void pair_half_edges(FacetMesh& mesh, bool any_direction = false);

/// Welds corners closer than 1e-6 of the size, drops collapsed and repeated triangles, and turns them alike
/// (the side with more area stays). Edges of three and more triangles, and those where no turning agrees, are
/// borders.
FacetMesh weld_facets(const LooseFacets& facets);

}  // namespace beadmesh
