// An arm of a bead: its ridge and its medial axis.
#pragma once

#include <vector>

#include "beadmesh/bead/ridge.h"
#include "beadmesh/bead/skeleton.h"
#include "beadmesh/blocking/axis_station.h"

namespace beadmesh {

/// A ridge arm with its medial axis, measured along the ridge. Keeps references to all it is given.
class ArmLine {
 public:
  ArmLine(const SkeletonArm& medial, const RidgeArm& ridge, const std::vector<double>& loop_lengths);

  double length() const { return at_.back(); }
  Vec2 point(double along) const;
  /// Points of the ridge between two distances along it, both left out.
  std::vector<Vec2> between(double from, double to) const;
  /// Distance along the ridge of its point nearest to p.
  double nearest(Vec2 p) const;
  /// The touching line of the medial point nearest to the ridge at `along`.
  AxisStation station(double along) const;

 private:
  const SkeletonArm* medial_;
  std::vector<Vec2> points_;
  const std::vector<double>* loop_lengths_;
  std::vector<double> at_, medial_at_;
};

}  // namespace beadmesh
