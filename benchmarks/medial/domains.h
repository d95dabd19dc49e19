// The plane regions that the benchmark measures: outlines of lines and arcs, cut into segments.
#pragma once

#include <string>
#include <vector>

#include "beadmesh/delaunay/planar_region.h"

namespace beadmesh::bench {

/// A straight line (radius 0) or an arc; arcs run counter-clockwise where `angle` is positive.
struct Piece {
  Vec2 from, to;
  Vec2 centre;
  double radius = 0, start = 0, angle = 0;

  double length() const;
  /// At 0: `from`; at 1: `to`.
  Vec2 at(double t) const;
  double distance_to(Vec2 p) const;
};

/// An outline and what its medial object must be.
struct Domain {
  std::string name;
  std::vector<std::vector<Piece>> loops;  ///< the outer one first, counter-clockwise; the holes clockwise
  int edges = 0, junctions = 0, corner_ends = 0;
};

/// A stadium of 200 x 20: one edge.
Domain i_bead();
/// A plate with rounded corners and 40 round holes of six sizes.
Domain gasket();
/// A back with 15 teeth, all corners sharp.
Domain comb();

/// The outline turned by `angle` about the origin and cut into `segments` segments, which are as equally long
/// as the ends of the pieces allow. No tags: a plain polygon.
PlanarRegion cut(const Domain& domain, int segments, double angle);
/// The outline as it is: lines whole, arcs as exact curves under segments of at most 15 degrees, joints
/// tagged.
PlanarRegion exact(const Domain& domain, double angle);
/// From the outline, turned by `angle`.
double distance_to_outline(const Domain& domain, double angle, Vec2 p);

}  // namespace beadmesh::bench
