// From the graph of clusters to points with feet: nodes and edges of the axis in place (sections 3.3
// and 3.6).
#pragma once

#include <vector>

#include "beadmesh/medial/axis_polish.h"
#include "beadmesh/medial/medial_object.h"

namespace beadmesh {

/// A node in place. feet[i] belongs to the sector after out[i]; a smooth end has the two ends and, last, the
/// middle of its contact; a corner has itself; an isolated node three of its loop.
struct PlacedNode {
  Circle circle;
  std::vector<Contact> feet;
  bool settled = true;  ///< false: a junction that found no disc touching all its sectors
  bool merged = false;  ///< touches at two points only (MedialVertex::merged)
};

/// The points of an edge without its nodes, in order.
using PlacedEdge = std::vector<AxisPoint>;

struct PlacedAxis {
  std::vector<PlacedNode> nodes;
  std::vector<PlacedEdge> edges;
};

/// Polishes, merges near points, smooths and polishes again, as the options say. On a noisy boundary the
/// smoothed points are kept where they are equidistant within the noise: polishing would put the noise back.
PlacedAxis placed_axis(const AxisTriangles& axis, const AxisGraph& graph, const BoundaryCurve& curve,
                       const BoundarySamples& samples, const MedialOptions& options);

/// Touching points of junctions whose disc does not touch all its sectors, or holds a touching point of its
/// neighbours: the samples were too coarse to tell which junction has which sector. With samples there the
/// triangulation can.
std::vector<Contact> doubtful_contacts(const AxisGraph& graph, const PlacedAxis& placed, double tolerance);

}  // namespace beadmesh
