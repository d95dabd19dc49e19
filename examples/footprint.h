// Plan views of features as exact loops of lines and circular arcs, in millimetres.
#pragma once

#include <utility>
#include <vector>

#include "beadmesh/core/vector.h"

namespace beadmesh::examples {

/// A piece of a loop: the straight line from start to end, or (radius > 0) the arc about `centre`.
struct PlanEdge {
  Vec2 start, end;
  Vec2 centre;             ///< of an arc
  double radius = 0;       ///< mm; 0 for a line
  double start_angle = 0;  ///< radians, of `start` seen from the centre
  double sweep = 0;        ///< radians, positive counter-clockwise

  bool is_arc() const { return radius > 0; }
  double length() const;
  /// The point at fraction t in [0, 1] of the length.
  Vec2 point(double t) const;
};

/// A closed chain of edges; the first edge starts where the last one ends.
using PlanLoop = std::vector<PlanEdge>;

PlanEdge line(Vec2 start, Vec2 end);
PlanEdge arc(Vec2 centre, double radius, double start_angle, double sweep);
/// The same loop run through backwards; reversed(reversed(a)) is a.
PlanLoop reversed(const PlanLoop& loop);
/// The loop turned by `angle` (radians) about the origin, then shifted by `origin`.
PlanLoop placed(const PlanLoop& loop, Vec2 origin, double angle);
/// Points along the loop, corners and arcs within 0.01 mm, without repeating the first.
std::vector<Vec2> sampled(const PlanLoop& loop);

/// Counter-clockwise polygon whose corner i is rounded with radii[i] (0 leaves it sharp).
PlanLoop rounded_polygon(const std::vector<Vec2>& corners, const std::vector<double>& radii);
/// Centred on the origin, counter-clockwise.
PlanLoop rounded_rectangle(double length, double width, double corner_radius);
/// Centred on the origin, counter-clockwise, in two halves or as one edge.
PlanLoop circle(double radius, int edges = 2);

/// A feature's outline about its own origin, with the skeleton it was made from.
struct Footprint {
  std::vector<PlanLoop> loops;        ///< the outer one first and counter-clockwise, windows clockwise
  std::vector<PlanLoop> centrelines;  ///< chains of edges, of a ring closed; none of a blob
  double half_width = 0;              ///< mm, from the boundary to the crest (the first end of a taper)
  double end_half_width = 0;          ///< mm, of the second end; equal to half_width but for a taper
  bool between_loops = false;    ///< the crest lies midway between the two loops, whatever their distance
  Vec2 axis_start, axis_end;     ///< of a taper, between its cap centres
  double centreline_length = 0;  ///< mm, cap centre to cap centre, all branches
  double mean_width = 0;         ///< mm, along the centre lines
};

/// A step of a path: straight ahead, or an arc that turns by `turn` radians (positive: left).
struct PathStep {
  double length = 0;  ///< mm, of a straight step
  double radius = 0;  ///< mm, of an arc
  double turn = 0;    ///< radians, of an arc
};

/// Shifts the loops so that the middle of the outer one's bounding box is the origin.
void centre_on_origin(Footprint& footprint);

/// Band of constant width with round caps along a tangent-continuous path (straight, arc, S, L, J, G);
/// bends are concentric, so its medial axis is the path. Centred on the middle of its bounding box.
Footprint strip(const std::vector<PathStep>& path, double width);

/// Straight band whose width changes evenly from the first cap centre to the second.
Footprint taper(double length, double start_width, double end_width);

/// Straight arms of one width between nodes (T, Y, X, H, comb, trident, ladder): round caps at loose ends,
/// concave corners rounded by `fillet`; a cycle of arms makes a window.
Footprint network(const std::vector<Vec2>& nodes, const std::vector<std::pair<int, int>>& arms, double width,
                  double fillet);

/// Band between two loops on both sides of the loop `centre` (empty: not known), all three counter-clockwise.
Footprint ring(const PlanLoop& outer, const PlanLoop& centre, const PlanLoop& inner, double width);
Footprint circular_ring(double outer_radius, double width);
/// Outer size; `corner_radius` of the outer loop, at least width, at most half the smaller side (then an
/// oval).
Footprint rounded_ring(double length, double height, double corner_radius, double width);

/// Between circles whose centres lie `offset` apart along x; `width` is the mean one.
Footprint eccentric_ring(double outer_radius, double width, double offset);
/// A circular window in an oval of the given outer size; the band is `width` wide above and below.
Footprint oval_with_round_window(double length, double height, double width);

/// A single loop that is no bead: hole, emboss, pad or plateau with a shoulder `half_width` wide.
Footprint blob(const PlanLoop& loop, double half_width);

/// Distance of p (mm) to the nearest loop, positive inside.
class BoundaryDistance {
 public:
  explicit BoundaryDistance(std::vector<PlanLoop> loops);
  double operator()(Vec2 p) const;
  /// Distance to one of the loops, without sign.
  double to_loop(int index, Vec2 p) const;

 private:
  bool contains(Vec2 p) const;
  std::vector<PlanLoop> loops_;
  std::vector<std::vector<Vec2>> polygons_;
};

}  // namespace beadmesh::examples
