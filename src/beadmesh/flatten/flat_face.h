// A face laid out in the plane, with the way back to the surface.
#pragma once

#include <memory>
#include <vector>

#include "beadmesh/core/result.h"
#include "beadmesh/panel/facets.h"

namespace beadmesh {

struct FlattenOptions {
  int iterations = 1000;        ///< default 1000: ARAP local/global sweeps at most
  double convergence = 1e-7;    ///< default 1e-7: stops when no point moves by more than this times the size
  double max_distortion = 4.0;  ///< default 4: larger singular-value ratios are an error
};

struct Distortion {
  double max_ratio = 1;     ///< largest singular value ratio over the facets (1 = similar)
  double max_stretch = 1;   ///< largest singular value (flat to surface) or its inverse, whichever is greater
  double mean_stretch = 1;  ///< area-weighted mean of the same
};

/// The plane image of Facets; positions[i] belongs to facets.points[i]. No triangle is turned over.
struct FlatFace {
  std::vector<Vec2> positions;
  Distortion distortion;
};

/// Lays facets out in the plane, as rigid as possible (Liu, Zhang, Xu, Gotsman, Gortler 2008). Start: the
/// facets unrolled over their edges, with the turns they have over the mean plane where none leans over it;
/// else Tutte's embedding. A planar face is copied isometrically. The image lies over the projection along
/// the mean normal, as close as a rigid motion brings it; its x axis is the projected global x axis, so that
/// a flat sheet z = const facing up keeps its coordinates. Fails with flatten.* where the piece is no disc
/// with holes, or flips or distorts beyond the limit.
Result<FlatFace> flatten(const Facets& facets, const FlattenOptions& options = {});

/// A point of the flat face seen on the facets.
struct FacetPoint {
  Index triangle = no_index;
  double weight[3] = {0, 0, 0};  ///< barycentric; clamped to the triangle where the point lay outside
};

/// Way back from the plane to the surface. Keeps references: facets and flat must outlive it. Const calls are
/// safe from several threads.
class SurfaceMap {
 public:
  SurfaceMap(const Facets& facets, const FlatFace& flat);
  ~SurfaceMap();
  SurfaceMap(SurfaceMap&&) noexcept;

  /// Facet that holds `flat`, or the nearest one (clamped) when it lies outside. `hint`: a triangle near it,
  /// or no_index; walks from there, and falls back to a search grid. triangle = no_index: no facets, or
  /// `flat` is no number.
  FacetPoint locate(Vec2 flat, Index hint = no_index) const;
  /// Point on the facet plane (fast; off the surface by at most the facets' sagitta).
  Vec3 facet_point(const FacetPoint& at) const;
  /// Point on the exact surface through its parameters, where there is one; else (or where the parameters
  /// jump within the facet) facet_point.
  Vec3 surface_point(const FacetPoint& at) const;
  /// Unit normal: exact where there is a surface, else interpolated from the facets.
  Vec3 normal(const FacetPoint& at) const;
  /// Local scale there: length on the surface of a unit flat vector in direction `direction` (unit).
  double stretch(const FacetPoint& at, Vec2 direction) const;

  const Facets& facets() const;
  const FlatFace& flat() const;

 private:
  struct Grid;
  const SurfaceEvaluator* surface_of(Index triangle) const;

  const Facets* facets_;
  const FlatFace* flat_;
  std::unique_ptr<Grid> grid_;
};

}  // namespace beadmesh
