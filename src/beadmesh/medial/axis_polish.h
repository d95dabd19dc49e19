// Newton to exact equidistance: the triangulation gives the topology, this gives the geometry.
#pragma once

#include <array>
#include <vector>

#include "beadmesh/medial/axis_graph.h"
#include "beadmesh/medial/boundary_curve.h"

namespace beadmesh {

/// The segments under a sector and one sample more at either end.
SegmentRun run_of(const BoundaryCurve& curve, const BoundarySamples& samples, Sector sector);

/// A point of an axis edge: its disc, and where that touches left and right.
struct AxisPoint {
  Circle circle;
  std::array<BoundaryPlace, 2> feet;
  Vec2 across;  ///< from the right foot to the left one: across the axis
};

/// Moves the circle's centre along the line between its two feet until these are equally far, and sets its
/// radius to that. The feet to begin with are places near them; they end as nearest points downhill from
/// there. False where it does not converge near the start or the feet are nearly one; the point is unchanged
/// then.
bool polish(const BoundaryCurve& curve, AxisPoint& point);

/// The feet moved downhill to where the unmoved centre has them, and the least distance as radius.
/// Returns by how much the distances differ.
double set_feet(const BoundaryCurve& curve, AxisPoint& point);

/// The same for a junction: until the nearest points of all runs are equally far (least squares where there
/// are more than three); radius is the least distance. Returns the feet, empty where it fails.
std::vector<Contact> polish(const BoundaryCurve& curve, const std::vector<SegmentRun>& runs, Circle& circle);

/// The same for a junction that was merged: equidistant from its two nearest runs, feet of all.
std::vector<Contact> polish_merged(const BoundaryCurve& curve, const std::vector<SegmentRun>& runs,
                                   Circle& circle);

/// Nearest points of the runs, unmoved.
std::vector<Contact> feet_of(const BoundaryCurve& curve, const std::vector<SegmentRun>& runs, Vec2 centre);

}  // namespace beadmesh
