// More points on an edge of the axis where straight lines between them are off the axis.
#pragma once

#include "beadmesh/medial/axis_geometry.h"

namespace beadmesh {

/// Halves the lines between successive points until every one is nearer to the axis than `chord`; on facets
/// and noise than a part of what these leave open. New points are polished. A line that no point can be found
/// for stays.
class AxisRefiner {
 public:
  AxisRefiner(const BoundaryCurve& curve, double chord) : curve_(curve), chord_(chord) {}

  void set_chord(double chord) { chord_ = chord; }
  /// About how many points the chord asks for between those of the edge.
  double points_wanted(const PlacedEdge& points) const;

  void refine_closed(PlacedEdge& points);
  /// Between two nodes. The line to a merged one is straight on purpose.
  void refine_open(PlacedEdge& points, const AxisPoint& start, bool start_merged, const AxisPoint& end,
                   bool end_merged);

 private:
  double allowed(const AxisPoint& point) const;
  bool may_be_off(const AxisPoint& from, const AxisPoint& to) const;
  void refine_line(const AxisPoint& from, const AxisPoint& to, int depth);
  bool point_between(const AxisPoint& from, const AxisPoint& to, AxisPoint& middle) const;

  const BoundaryCurve& curve_;
  double chord_;
  PlacedEdge made_;
};

}  // namespace beadmesh
