// Nearest point on facets in space: puts points back on the surface.
#pragma once

#include <memory>

#include "beadmesh/flatten/flat_face.h"

namespace beadmesh {

/// Barycentric weights of the point of triangle abc nearest to p (Ericson 2005, "Real-time collision
/// detection", 5.1.5, by regions). A degenerate triangle counts as its edges.
std::array<double, 3> nearest_weights(Vec3 a, Vec3 b, Vec3 c, Vec3 p);
std::array<double, 3> nearest_weights(Vec2 a, Vec2 b, Vec2 c, Vec2 p);

/// Tree of boxes over the facets, split at the median. Keeps a reference: facets must outlive it. Const calls
/// are safe from several threads. Equal distances: the triangle with the lowest index.
class FacetSearch {
 public:
  explicit FacetSearch(const Facets& facets);
  ~FacetSearch();
  FacetSearch(FacetSearch&&) noexcept;

  /// triangle = no_index where there are no facets or p is no number. O(log n).
  FacetPoint nearest(Vec3 p) const;

  const Facets& facets() const;

 private:
  struct Tree;
  const Facets* facets_;
  std::unique_ptr<Tree> tree_;
};

}  // namespace beadmesh
