// Newton to exact equidistance: the triangulation gives the topology, this gives the geometry.
#pragma once

#include <array>
#include <vector>

#include "beadmesh/medial/axis_graph.h"
#include "beadmesh/medial/boundary_curve.h"

namespace beadmesh {

/// A point of an axis edge: its disc, and the two stretches of boundary, left and right, that it lies
/// between.
struct AxisPoint {
  Circle circle;
  std::array<SegmentRun, 2> runs;
  std::array<Contact, 2> feet;
};

/// The segments under a sector and one sample more at either end.
SegmentRun run_of(const BoundaryCurve& curve, const BoundarySamples& samples, Sector sector);

/// Moves the circle's centre until the nearest points of all runs are equally far (least squares where there
/// are more than three), and sets its radius to the least distance. Two runs: moves along the line between
/// the feet. Returns the feet; empty where it does not converge near the start, or all feet are nearly one;
/// the circle is unchanged then.
std::vector<Contact> polish(const BoundaryCurve& curve, const std::vector<SegmentRun>& runs, Circle& circle);

/// The same for a junction that was merged: equidistant from its two nearest runs, feet of all.
std::vector<Contact> polish_merged(const BoundaryCurve& curve, const std::vector<SegmentRun>& runs,
                                   Circle& circle);

/// Nearest points of the runs, unmoved.
std::vector<Contact> feet_of(const BoundaryCurve& curve, const std::vector<SegmentRun>& runs, Vec2 centre);

}  // namespace beadmesh
