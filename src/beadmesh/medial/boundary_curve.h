// The boundary of a region as the medial axis sees it: straight where it is straight, the exact curve where
// there is one, a smooth curve through the points where a smooth curve was facetted, broken at corners only.
#pragma once

#include <vector>

#include "beadmesh/delaunay/planar_region.h"
#include "beadmesh/medial/tolerances.h"

namespace beadmesh {

/// A place on the boundary.
struct BoundaryPlace {
  Index loop = 0;
  Index segment = 0;
  double t = 0;  ///< along the segment, 0 to 1
};

/// The point of the boundary that is nearest to something.
struct Contact {
  BoundaryPlace place;
  Vec2 point;  ///< on the curve
  double distance = 0;
};

/// A segment's geometry, made when it is needed: the boundary itself is kept small.
struct BoundaryPiece {
  Vec2 a, b;
  Vec2 linear, quadratic, cubic;  ///< coefficients of a cubic from a
  bool straight = true;
  const PlanarCurve* curve = nullptr;
  double from = 0, to = 0;  ///< parameters of the curve

  CurvePoint at(double t) const;
};

/// A run of segments of one loop, forward from `segment`.
struct SegmentRun {
  Index loop = 0, segment = 0, count = 0;
};

/// Every segment of the region is a piece: the chord itself, part of an exact curve, or a cubic that leaves
/// and arrives along the tangents that the neighbouring chords suggest. Such a cubic never leaves the
/// polyline by more than the sagitta of the shorter of two chords at a point. The boundary is tangent
/// continuous but for the corners. In a loop without tags a point is a corner where the loop turns by more
/// than pi - corner_angle; below that, where a cubic through it would bulge by more than facets do, the
/// chords stay straight.
class BoundaryCurve {
 public:
  BoundaryCurve(const PlanarRegion& region, double corner_angle);

  /// The region with a tag at every point.
  const PlanarRegion& tagged_region() const { return region_; }

  Index loops() const { return static_cast<Index>(loops_.size()); }
  Index segments(Index loop) const { return static_cast<Index>(region_.loops[loop].points.size()); }
  double length(Index loop) const { return loops_[loop].length; }
  double size() const { return size_; }
  const Tolerances& tolerances() const { return tolerances_; }

  /// Length of a segment's chord.
  double chord(Index loop, Index segment) const;
  /// Whether the loop's curves are known.
  bool is_exact(Index loop) const { return !region_.loops[loop].curve.empty(); }
  bool is_straight(Index loop, Index segment) const;
  /// Whether a segment stands for a smooth curve that is not known exactly.
  bool is_facet(Index loop, Index segment) const;
  bool is_corner(Index loop, Index point) const { return region_.loops[loop].corner[point]; }
  bool is_convex_corner(Index loop, Index point) const { return loops_[loop].convex_corner[point]; }

  /// Arc length along the polyline of the loop.
  double position(const BoundaryPlace& place) const;
  /// On the curve, and on the chord.
  Vec2 point(const BoundaryPlace& place) const;
  Vec2 chord_point(const BoundaryPlace& place) const;
  /// Whether a point is on the region's side of the boundary at a place.
  bool is_before(Vec2 point, const BoundaryPlace& place) const;
  /// Radius of curvature at a place, positive where the region is convex there, infinite where it is
  /// straight.
  double signed_radius(const BoundaryPlace& place, Vec2& inward_normal) const;
  /// The place at an arc length along the polyline, taken modulo the length.
  BoundaryPlace place_at(Index loop, double position) const;

  /// Nearest point of the run; where that is an end of it, goes on downhill along the loop up to a convex
  /// corner.
  Contact nearest(Vec2 from, const SegmentRun& run) const;
  /// The same, downhill from a place that is near already.
  Contact nearest(Vec2 from, const BoundaryPlace& start) const;
  /// The place whose chord is nearest: a start for the two above that costs little.
  BoundaryPlace nearest_chord(Vec2 from, const SegmentRun& run) const;

  /// What a smooth boundary may be off by near a segment: the bulge of its facets or of a bump; 0 between
  /// corners.
  double tolerance(Index loop, Index segment) const;
  /// Estimate of the amplitude of the noise of the points; 0 where the boundary is exact, or lines and arcs
  /// or corners only.
  double noise() const { return noise_; }
  /// Angle by which the loop turns within `reach` of a place: positive convex, negative concave.
  double turning(const BoundaryPlace& place, double reach) const;

 private:
  friend class FootFollower;
  struct Loop {
    std::vector<double> start;  ///< per point: arc length along the polyline
    std::vector<Vec2> tangent;  ///< per point: unit, zero where the boundary is no cubic; empty: nowhere
    std::vector<char> convex_corner;  ///< per point
    std::vector<char> bent;           ///< per segment: no straight line; empty: none
    std::vector<float> tolerance;     ///< per segment; empty: 0
    double length = 0;
  };

  void read(std::size_t l, double corner_angle, std::vector<double>& wobble);
  double turn(const PlanarLoop& loop, std::size_t i) const;
  double exact_turn(const PlanarLoop& loop, std::size_t i) const;
  std::vector<char> smooth_points(const PlanarLoop& loop, const std::vector<double>& turns,
                                  bool tagged) const;
  static std::vector<Vec2> tangents(const PlanarLoop& loop, const std::vector<double>& turns,
                                    const std::vector<char>& smooth);
  void mark_bent(std::size_t l);
  void measure_deviations(std::size_t l, std::vector<double>& wobble);
  BoundaryPiece piece(Index loop, Index segment) const;
  Index neighbour(Index loop, Index segment, int direction) const;
  static Contact nearest_on_piece(Vec2 from, const BoundaryPiece& piece, const BoundaryPlace& start);
  Contact downhill(Vec2 from, Contact best, Index most) const;

  PlanarRegion region_;
  std::vector<Loop> loops_;
  double size_ = 0, noise_ = 0;
  Tolerances tolerances_;
};

/// The nearest point of the boundary, followed downhill while what it is nearest to moves.
class FootFollower {
 public:
  FootFollower(const BoundaryCurve& curve, const BoundaryPlace& start)
      : curve_(curve), piece_(curve.piece(start.loop, start.segment)), foot_{start, {}, 0} {}
  const Contact& follow(Vec2 from);
  const Contact& foot() const { return foot_; }

 private:
  const BoundaryCurve& curve_;
  BoundaryPiece piece_;
  Contact foot_;
};

}  // namespace beadmesh
