// The boundary of a region as the medial axis sees it: straight where it is straight, a smooth curve through
// the points where a smooth curve was facetted, broken at corners only.
#pragma once

#include <vector>

#include "beadmesh/delaunay/planar_region.h"

namespace beadmesh {

/// The point of the boundary that is nearest to something.
struct Contact {
  Index loop = 0;
  Index segment = 0;
  double t = 0;  ///< along the segment, 0 to 1
  Vec2 point;    ///< on the curve
  double distance = 0;
};

/// A run of segments of one loop, forward from `segment`.
struct SegmentRun {
  Index loop = 0, segment = 0, count = 0;
};

/// Every segment of the region is a piece: the chord itself, or a cubic that leaves and arrives along the
/// tangents that the neighbouring chords suggest. The curve never leaves the polyline by more than the
/// sagitta of the shorter of two chords at a point, and is tangent continuous but for the corners. In a loop
/// without tags a point is a corner where the loop turns by more than pi - corner_angle; below that, where a
/// curve through it would bulge by more than facets do, the chords stay straight.
class BoundaryCurve {
 public:
  BoundaryCurve(const PlanarRegion& region, double corner_angle);

  /// The region with a tag at every point.
  const PlanarRegion& tagged_region() const { return region_; }

  Index loops() const { return static_cast<Index>(loops_.size()); }
  Index segments(Index loop) const { return static_cast<Index>(loops_[loop].pieces.size()); }
  double length(Index loop) const { return loops_[loop].length; }
  double size() const { return size_; }
  /// Segment at an arc length along the polyline of the loop.
  Index segment_at(Index loop, double position) const;
  /// Arc length along the polyline, and the point of the polyline there.
  double position(Index loop, Index segment, double t) const;
  Vec2 polyline_point(Index loop, Index segment, double t) const;
  Vec2 curve_point(Index loop, double position) const;

  /// Nearest point of the run; where that is an end of it, goes on downhill along the loop up to a convex
  /// corner.
  Contact nearest(Vec2 from, const SegmentRun& run) const;

  /// What a smooth boundary may be off by near a segment: the bulge of its facets or of a bump; 0 between
  /// corners.
  double tolerance(Index loop, Index segment) const { return loops_[loop].tolerance[segment]; }
  /// Estimate of the amplitude of the noise of the points; 0 where the boundary is lines and arcs or corners
  /// only.
  double noise() const { return noise_; }
  /// Angle by which the loop turns within `reach` of a position: positive convex, negative concave.
  double turning(Index loop, double position, double reach) const;

 private:
  struct Piece {
    Vec2 a, b, leave, arrive;  ///< ends and Hermite tangents
    double start = 0, length = 0;
    bool straight = true;
  };
  struct Loop {
    std::vector<Piece> pieces;
    std::vector<double> turn;       ///< per point
    std::vector<char> wall_end;     ///< per point: a convex corner, past which nothing faces the same wall
    std::vector<double> tolerance;  ///< per segment
    double length = 0;
  };

  static Loop make_loop(const PlanarLoop& loop);
  /// Per point whether the curve passes it smoothly.
  std::vector<char> smooth_points(const Loop& loop, const std::vector<bool>& corner, bool tagged) const;
  static void bend_pieces(Loop& loop, const std::vector<char>& smooth);
  static void measure_deviations(Loop& loop, const std::vector<bool>& corner, std::vector<double>& wobble);
  static Vec2 evaluate(const Piece& piece, double t);
  Contact nearest_on_piece(Vec2 from, Index loop, Index segment) const;

  PlanarRegion region_;
  std::vector<Loop> loops_;
  double size_ = 0, noise_ = 0;
};

}  // namespace beadmesh
