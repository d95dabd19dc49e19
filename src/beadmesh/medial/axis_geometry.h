// From the graph of clusters to points with feet: nodes and edges of the axis in place (sections 3.3
// and 3.6).
#pragma once

#include <array>
#include <vector>

#include "beadmesh/medial/axis_graph.h"
#include "beadmesh/medial/axis_polish.h"
#include "beadmesh/medial/boundary_curve.h"
#include "beadmesh/medial/medial_object.h"

namespace beadmesh {

/// A node in place. feet[i] belongs to the sector after out[i]; a smooth end has the two ends and, last, the
/// middle of its contact; a corner has itself; an isolated node three of its loop.
struct PlacedNode {
  Circle circle;
  std::vector<Contact> feet;
  std::vector<ContactInterval> intervals;  ///< where it touches along an arc
  bool is_end = false;                     ///< a corner or a smooth end
  bool settled = true;                     ///< false: a junction that found no disc touching all its sectors
  bool crossing = false;                   ///< junctions a way apart made one: edges go straight to it
  bool merged = false;                     ///< touches at two points only (MedialVertex::merged)
};

/// The points of an edge without its nodes, in order.
using PlacedEdge = std::vector<AxisPoint>;

/// What placing needs to know of the stages before.
struct AxisOnBoundary {
  const AxisTriangles& triangles;
  const AxisGraph& graph;
  const BoundaryCurve& curve;
  const BoundarySamples& samples;
};

/// The nodes: junctions polished, smooth ends on the centre of their arc or of curvature.
std::vector<PlacedNode> placed_nodes(const AxisOnBoundary& axis, bool polished);

/// The edges: polished, near points merged; on a noisy boundary smoothed, and kept as they are where they are
/// equidistant within the noise: polishing would put the noise back.
std::vector<PlacedEdge> placed_edges(const AxisOnBoundary& axis, const std::vector<PlacedNode>& nodes,
                                     const MedialOptions& options);

/// The feet, left and right, of a node seen from an edge that leaves it through its open half-edge `slot`.
std::array<Contact, 2> feet_leaving(const PlacedNode& placed, Index slot);

/// Touching points of junctions that contraction has made one although no disc touches them all: their
/// centres are near, but not the same. Where the boundary is facetted nobody can tell.
std::vector<BoundaryPlace> torn_contacts(const std::vector<PlacedNode>& nodes, const BoundaryCurve& curve);

/// Touching points of junctions whose disc does not touch all its sectors, or holds a touching point of its
/// neighbours: the samples were too coarse to tell which junction has which sector. With samples there the
/// triangulation can.
std::vector<BoundaryPlace> doubtful_contacts(const AxisGraph& graph, const std::vector<PlacedNode>& nodes,
                                             double tolerance);

}  // namespace beadmesh
