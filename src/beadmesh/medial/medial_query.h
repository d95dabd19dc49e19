// Questions to a medial object: where is the nearest axis, how thick is the face here, how do I get from
// there to there. Needs nothing but medial_object.h.
//
//   auto region = read_polygon("part.wkt");                         // or checked_region({{{{{0, 0}, ...}}}})
//   auto medial = medial_object(*region);                           // both are Results: check them
//   MedialQuery query(*medial);
//   double mm = query.thickness_at({12, 5})->thickness;
//   for (Departure d : departures(*medial, vertex)) visit(medial->edges[d.edge], arrival(*medial, d));
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "beadmesh/medial/medial_object.h"

namespace beadmesh {

/// A place on the axis: an edge and how far along it, or the single vertex of a full disc.
struct AxisPlace {
  Index edge = no_index;    ///< no_index: `vertex` is an isolated one
  double distance = 0;      ///< arc length from the edge's start, 0 to its length
  Index vertex = no_index;  ///< the isolated vertex; no_index on an edge
  Vec2 point;               ///< where that is
  double radius = 0;        ///< of the inscribed circle there, half the thickness
};

struct NearestAxis {
  AxisPlace place;
  double gap = 0;  ///< distance from the point asked about
};

/// Thickness of the region at a point: the diameter of the largest inscribed disc that holds the point
/// ("local thickness", Hildebrand and Rueegsegger 1997). It is defined in the whole region, is that of the
/// axis on the axis, and does not fall off towards the walls.
struct LocalThickness {
  double thickness = 0;
  AxisPlace disc;  ///< its centre
  /// How far the point lies outside that disc: 0 in the region, but for a trace along walls whose axis is
  /// known at points only. More means that the point asked about is outside; the disc is then the one that
  /// comes nearest.
  double outside = 0;
};

/// Answers in about the logarithm of the number of axis points. Keeps a reference: the object must outlive
/// it. Const calls are safe from several threads. Between the points of an edge the axis and its radius are
/// taken as straight (point_at takes the cubic that its slopes tell).
class MedialQuery {
 public:
  explicit MedialQuery(const MedialObject& object);
  ~MedialQuery();
  MedialQuery(MedialQuery&&) noexcept;

  /// Nothing only where the object is empty or p is no number. Of places equally near the first, in the order
  /// of edges and points.
  std::optional<NearestAxis> nearest(Vec2 p) const;
  std::optional<LocalThickness> thickness_at(Vec2 p) const;

 private:
  class Tree;
  std::unique_ptr<const Tree> tree_;
};

/// An edge in the direction in which it leaves a vertex.
struct Departure {
  Index edge = no_index;
  bool forward = true;  ///< from start to end
  friend bool operator==(const Departure&, const Departure&) = default;
};

/// The ways out of a vertex, counter-clockwise, that of MedialVertex::edges[0] first; an edge that comes back
/// to the vertex is there twice, once each way.
std::vector<Departure> departures(const MedialObject& object, Index vertex);

/// The vertex where the way ends; no_index on a closed edge (type N).
Index arrival(const MedialObject& object, Departure way);

/// The other end of an edge: `vertex` itself for an edge that comes back to it. no_index where the edge does
/// not end at `vertex`.
Index other_end(const MedialObject& object, Index edge, Index vertex);

/// The point at `distance` along the way, counted from where it departs; clamped.
MedialPoint point_along(const MedialObject& object, Departure way, double distance);

/// `count` points evenly spaced by arc length, both ends included (a closed edge: its start once). `count` of
/// at least 2, or 1: the middle.
std::vector<MedialPoint> even_points(const MedialEdge& edge, int count);

/// The shortest way along edges from one vertex to another, in order; empty where there is none or they are
/// the same.
std::vector<Departure> path_between(const MedialObject& object, Index from, Index to);

/// Sum of the edges' lengths, mm.
double total_length(const MedialObject& object);
double total_length(const MedialObject& object, const std::vector<Departure>& path);

}  // namespace beadmesh
