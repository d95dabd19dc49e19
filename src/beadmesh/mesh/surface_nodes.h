// Nodes of a face in the flat plane together with their places on the surface.
#pragma once

#include <vector>

#include "beadmesh/flatten/flat_face.h"
#include "beadmesh/mesh/planar_mesh.h"

namespace beadmesh {

/// One place, in the plane and on the facets.
struct SurfacePlace {
  Vec2 flat;
  Vec3 space;
  Index triangle = no_index;  ///< facet it was found in: the hint for places near it
};

/// Cached 3-D positions of all nodes of a face; a null map stands for the plane z = 0.
class SurfaceNodes {
 public:
  SurfaceNodes(const std::vector<Vec2>& flat, const SurfaceMap* map) : map_(map) {
    places_.reserve(flat.size());
    Index hint = no_index;
    for (const Vec2 position : flat) {
      places_.push_back(place(position, hint));
      hint = places_.back().triangle;
    }
  }

  SurfacePlace place(Vec2 flat, Index hint) const {
    if (!map_) return {flat, {flat.x, flat.y, 0}, no_index};
    const FacetPoint at = map_->locate(flat, hint);
    return {flat, map_->facet_point(at), at.triangle};
  }

  Index add(const SurfacePlace& place) {
    places_.push_back(place);
    return static_cast<Index>(places_.size()) - 1;
  }
  /// Drops the nodes from `count` on.
  void truncate(Index count) { places_.resize(count); }
  const SurfacePlace& operator[](Index node) const { return places_[node]; }
  void set(Index node, const SurfacePlace& place) { places_[node] = place; }
  Vec2 flat(Index node) const { return places_[node].flat; }
  const Vec3& space(Index node) const { return places_[node].space; }
  size_t size() const { return places_.size(); }

 private:
  const SurfaceMap* map_;
  std::vector<SurfacePlace> places_;
};

}  // namespace beadmesh
