// Inside the read room: whether the facets of exact arcs keep the topology of the arcs.
#pragma once

#include <vector>

#include "beadmesh/delaunay/planar_region.h"

namespace beadmesh::read {

/// Segment `segment` of loop `loop`, both from 0.
struct SegmentName {
  std::size_t loop = 0, segment = 0;
};

/// Something of the boundary reaches into the bulge of a facet.
struct BulgeConflict {
  SegmentName bulge, other;
};

/// The bulge of a facet is the triangle of its chord and the tangents of its curve at both ends; it holds the
/// curve where the facet turns by less than 180 degrees and does not turn back. Where no bulge meets another
/// segment or bulge, the polygon of the points has the topology of the curves. Neighbours may share their
/// joint, and may be tangent there (up to 0.01 degrees).
std::vector<BulgeConflict> bulge_conflicts(const PlanarRegion& region);

}  // namespace beadmesh::read
