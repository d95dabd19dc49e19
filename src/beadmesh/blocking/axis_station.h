// Places along the medial axis of an arm with their touching lines (figure 11 of the paper).
#pragma once

#include <vector>

#include "beadmesh/bead/ridge.h"
#include "beadmesh/bead/skeleton.h"

namespace beadmesh {

/// A touching line: from the left foot over the axis to the right foot.
struct AxisStation {
  double along = 0;  ///< distance along the arm from its start
  Vec2 centre;
  double radius = 0;
  double subtended_angle = 0;  ///< between the directions to the feet, radians
  BoundaryPosition left, right;
};

/// Distances along the arm of all its points, from 0.
std::vector<double> distances_along(const SkeletonArm& arm);

/// Station at a distance along the arm (clamped). Feet interpolated the short way round on their loops.
/// loop_lengths: arc length of every loop of the region.
AxisStation station_at(const SkeletonArm& arm, double along, const std::vector<double>& loop_lengths);

std::vector<double> loop_lengths_of(const PlanarRegion& region);

/// b - a along a loop the short way round.
double loop_difference(double a, double b, double loop_length);

}  // namespace beadmesh
