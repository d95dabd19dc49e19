// Medial axes known in closed form, and distances by brute force, for the tests
// of the medial object. Nothing here uses the code that is tested.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "beadmesh/delaunay/planar_region.h"
#include "beadmesh/medial/medial_object.h"

namespace beadmesh::reference {

inline double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const double along = squared_norm(b - a);
  const double t = along > 0 ? std::clamp(dot(p - a, b - a) / along, 0.0, 1.0) : 0.0;
  return distance(p, a + (b - a) * t);
}

/// The distance of points to the boundary: segments and exact curves, by
/// looking at every one.
class Boundary {
 public:
  explicit Boundary(const PlanarRegion& region) {
    for (const PlanarLoop& loop : region.loops)
      for (std::size_t i = 0; i < loop.points.size(); ++i) {
        Piece piece{loop.points[i], loop.points[(i + 1) % loop.points.size()], nullptr, {0, 0}, 0};
        if (!loop.curve.empty() && loop.curve[i] != no_index) {
          piece.curve = region.curves[loop.curve[i]].get();
          piece.ends = loop.parameters[i];
          piece.bulge = distance(piece.curve->at((piece.ends[0] + piece.ends[1]) / 2).point,
                                 lerp(piece.start, piece.end, 0.5)) *
                        2;
        }
        pieces_.push_back(piece);
      }
  }

  double distance_to(Vec2 p) const {
    double best = std::numeric_limits<double>::infinity();
    for (const Piece& piece : pieces_) {
      const double chord = distance_to_segment(p, piece.start, piece.end);
      if (chord - piece.bulge < best) best = std::min(best, piece.curve ? to_curve(piece, p) : chord);
    }
    return best;
  }

  /// Points of the boundary, `per_piece` on every segment.
  std::vector<Vec2> points(int per_piece) const {
    std::vector<Vec2> result;
    for (const Piece& piece : pieces_)
      for (int k = 0; k < per_piece; ++k) {
        const double t = static_cast<double>(k) / per_piece;
        result.push_back(piece.curve ? piece.curve->at(piece.ends[0] * (1 - t) + piece.ends[1] * t).point
                                     : lerp(piece.start, piece.end, t));
      }
    return result;
  }

 private:
  struct Piece {
    Vec2 start, end;
    const PlanarCurve* curve;
    std::array<double, 2> ends;
    double bulge;  // more than the curve leaves its chord
  };

  // On a facet the distance has one minimum at most: where its derivative
  // changes its sign, by bisection.
  static double to_curve(const Piece& piece, Vec2 p) {
    auto [low, high] = piece.ends;
    const auto slope = [&](double t) {
      const CurvePoint c = piece.curve->at(t);
      return dot(c.point - p, c.velocity) * (piece.ends[1] > piece.ends[0] ? 1 : -1);
    };
    double best = std::min(distance(p, piece.start), distance(p, piece.end));
    if (slope(low) >= 0 || slope(high) <= 0) return best;
    for (int i = 0; i < 60; ++i) {
      const double middle = (low + high) / 2;
      (slope(middle) > 0 ? high : low) = middle;
    }
    return std::min(best, distance(p, piece.curve->at(low).point));
  }

  std::vector<Piece> pieces_;
};

/// A stretch of an exact axis: points for t from 0 to 1.
struct AxisCurve {
  std::function<Vec2(double)> at;
  int samples = 400;  ///< so dense that between two of them the distance to a
                      ///< near point has one minimum
};

/// Where the tests expect the axis. Straight stretches and others.
using Axis = std::vector<AxisCurve>;

inline AxisCurve straight(Vec2 a, Vec2 b) {
  return {[=](double t) { return lerp(a, b, t); }, 100};
}

/// Equidistant from a point and a line through `on` in `direction`: the points
/// whose projections on the line run from `from` to `to` (lengths from `on`).
inline AxisCurve parabola(Vec2 focus, Vec2 on, Vec2 direction, double from, double to) {
  const Vec2 d = normalized(direction);
  const Vec2 up = dot(focus - on, left_normal(d)) > 0 ? left_normal(d) : -left_normal(d);
  const double height = dot(focus - on, up), foot = dot(focus - on, d);
  return {[=](double t) {
    const double s = from + (to - from) * t, x = s - foot;
    return on + d * s + up * ((x * x + height * height) / (2 * height));
  }};
}

/// Distances between the axis that was found and the one that is known, both
/// ways.
struct Hausdorff {
  double found_to_known = 0, known_to_found = 0;
};

/// A polyline with its bounding box.
class Polyline {
 public:
  explicit Polyline(std::vector<Vec2> points)
      : points_(std::move(points)), low_(points_[0]), high_(points_[0]) {
    for (const Vec2 p : points_) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
  }

  const std::vector<Vec2>& points() const { return points_; }
  /// No more than the distance of p to the polyline.
  double distance_to_box(Vec2 p) const {
    return norm(
        Vec2{std::max({low_.x - p.x, 0.0, p.x - high_.x}), std::max({low_.y - p.y, 0.0, p.y - high_.y})});
  }
  double distance_to(Vec2 p) const {
    double best = points_.size() == 1 ? distance(p, points_[0]) : std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < points_.size(); ++i)
      best = std::min(best, distance_to_segment(p, points_[i], points_[i + 1]));
    return best;
  }

 private:
  std::vector<Vec2> points_;
  Vec2 low_, high_;
};

/// All edges in parts of at most 32 segments; the closing segment of a closed
/// edge included.
inline std::vector<Polyline> parts_of(const MedialObject& object) {
  std::vector<Polyline> parts;
  for (const MedialVertex& vertex : object.vertices) parts.emplace_back(std::vector<Vec2>{vertex.point});
  for (const MedialEdge& edge : object.edges) {
    std::vector<Vec2> points;
    for (const MedialPoint& point : edge.points) points.push_back(point.point);
    if (edge.type == MedialEdgeType::N) points.push_back(points.front());
    for (std::size_t i = 0; i + 1 < points.size(); i += 32)
      parts.emplace_back(
          std::vector<Vec2>(points.begin() + static_cast<std::ptrdiff_t>(i),
                            points.begin() + static_cast<std::ptrdiff_t>(std::min(i + 33, points.size()))));
  }
  return parts;
}

/// The samples find the neighbourhood, a search by thirds the point.
inline double distance_to_curve(Vec2 p, const AxisCurve& curve, const std::vector<Vec2>& samples) {
  const auto near = std::min_element(samples.begin(), samples.end(), [&](Vec2 a, Vec2 b) {
    return squared_norm(p - a) < squared_norm(p - b);
  });
  const double n = static_cast<double>(samples.size() - 1), at = static_cast<double>(near - samples.begin());
  double low = std::max(0.0, (at - 1) / n), high = std::min(1.0, (at + 1) / n);
  for (int i = 0; i < 80; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    if (distance(p, curve.at(a)) < distance(p, curve.at(b)))
      high = b;
    else
      low = a;
  }
  return distance(p, curve.at((low + high) / 2));
}

inline Hausdorff hausdorff(const MedialObject& object, const Axis& axis) {
  const std::vector<Polyline> found = parts_of(object);
  std::vector<Polyline> known;
  for (const AxisCurve& curve : axis) {
    std::vector<Vec2> samples;
    for (int i = 0; i <= curve.samples; ++i)
      samples.push_back(curve.at(static_cast<double>(i) / curve.samples));
    known.emplace_back(std::move(samples));
  }
  Hausdorff result;
  const auto to_known = [&](Vec2 p) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < axis.size(); ++k) {
      const auto& samples = known[k].points();
      const double margin = distance(samples[0],
                                     samples[1]);  // the curve may leave the box of its samples by less
      if (known[k].distance_to_box(p) - margin < best)
        best = std::min(best, distance_to_curve(p, axis[k], samples));
    }
    return best;
  };
  const auto to_found = [&](Vec2 p) {
    double best = std::numeric_limits<double>::infinity();
    for (const Polyline& part : found)
      if (part.distance_to_box(p) < best) best = std::min(best, part.distance_to(p));
    return best;
  };
  for (const Polyline& part : found)
    for (std::size_t i = 0; i < part.points().size(); ++i) {
      const Vec2 p = part.points()[i], next = part.points()[std::min(i + 1, part.points().size() - 1)];
      result.found_to_known = std::max({result.found_to_known, to_known(p), to_known(lerp(p, next, 0.5))});
    }
  for (const Polyline& curve : known)
    for (const Vec2 p : curve.points()) result.known_to_found = std::max(result.known_to_found, to_found(p));
  return result;
}

/// The greatest difference between a stored radius and the distance to the
/// boundary by brute force.
inline double radius_error(const MedialObject& object, const Boundary& boundary) {
  double most = 0;
  for (const MedialVertex& vertex : object.vertices)
    most = std::max(most, std::abs(vertex.radius - boundary.distance_to(vertex.point)));
  for (const MedialEdge& edge : object.edges)
    for (const MedialPoint& point : edge.points)
      most = std::max(most, std::abs(point.radius - boundary.distance_to(point.point)));
  return most;
}

inline Axis rectangle_axis(double a, double b) {
  const double h = b / 2;
  return {straight({0, 0}, {h, h}), straight({0, b}, {h, h}), straight({a, 0}, {a - h, h}),
          straight({a, b}, {a - h, h}), straight({h, h}, {a - h, h})};
}

/// Arms of the same width along the axes, sharp; from (0, 0) to (x, 0) and (0,
/// y).
inline Axis l_axis(double width, double x, double y) {
  const double h = width / 2, joint = width * (2 - std::sqrt(2));
  const Vec2 reflex{width, width};
  return {straight({x, 0}, {x - h, h}),     straight({x, width}, {x - h, h}),
          straight({x - h, h}, {width, h}), parabola(reflex, {0, 0}, {1, 0}, joint, width),
          straight({0, 0}, {joint, joint}), parabola(reflex, {0, 0}, {0, 1}, joint, width),
          straight({h, width}, {h, y - h}), straight({h, y - h}, {0, y}),
          straight({h, y - h}, {width, y})};
}

/// A sharp T: a bar from (-bar, -h) to (bar, h), a stem of the same width 2 h
/// down to y = -stem.
inline Axis t_axis(double h, double bar, double stem) {
  Axis axis{straight({0, -stem + h}, {0, -h / 4}), straight({-h, -stem}, {0, -stem + h}),
            straight({h, -stem}, {0, -stem + h})};
  for (const double side : {-1.0, 1.0}) {
    axis.push_back(parabola({side * h, -h}, {0, h}, {side, 0}, 0, h));
    axis.push_back(straight({side * h, 0}, {side * (bar - h), 0}));
    axis.push_back(straight({side * (bar - h), 0}, {side * bar, h}));
    axis.push_back(straight({side * (bar - h), 0}, {side * bar, -h}));
  }
  return axis;
}

/// The sharp comb of exact_shapes::comb_corners.
inline Axis comb_axis(int teeth, double width, double pitch, double length) {
  const double h = width / 2, joint = width * (2 - std::sqrt(2)), end = (teeth - 1) * pitch + width;
  Axis axis;
  const auto mirrored = [&](double x, bool right) { return right ? end - x : x; };
  for (const bool right : {false, true}) {
    const auto m = [&](double x, double y) { return Vec2{mirrored(x, right), y}; };
    axis.push_back(straight(m(0, width), m(joint, width - joint)));
    axis.push_back(parabola(m(width, 0), m(0, width), m(1, 0) - m(0, 0), joint, width));
    axis.push_back(parabola(m(width, 0), m(0, width), {0, -1}, joint, width));
  }
  for (int k = 0; k < teeth; ++k) {
    const double x = k * pitch, middle = x + h, tip = -length + h;
    const bool outer = k == 0 || k == teeth - 1;
    axis.push_back(straight({x, -length}, {middle, tip}));
    axis.push_back(straight({x + width, -length}, {middle, tip}));
    axis.push_back(straight({middle, tip}, {middle, outer ? 0 : 0.75 * h}));
    if (!outer)
      for (const double side : {-1.0, 1.0})
        axis.push_back(parabola({middle + side * h, 0}, {middle, width}, {side, 0}, 0, h));
    if (k + 1 < teeth) axis.push_back(straight({x + width, h}, {x + pitch, h}));
  }
  return axis;
}

/// exact_shapes::holed_plate: diagonals, and parabolas about the middle of the
/// hole.
inline Axis holed_plate_axis(double half, double r) {
  const double far = half + r, joint = far * (std::sqrt(2) - 1);
  Axis axis;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0}) axis.push_back(straight(Vec2{x, y} * half, Vec2{x, y} * joint));
  for (const Vec2 out : {Vec2{1, 0}, Vec2{0, 1}, Vec2{-1, 0}, Vec2{0, -1}})
    axis.push_back(parabola({0, 0}, out * far, left_normal(out), -joint, joint));
  return axis;
}

/// Equidistant from the circle of radius `outer` about (0, 0), inside, and a
/// circle in it: an ellipse with the two centres as foci.
inline Axis annulus_axis(double outer, double inner, Vec2 inner_centre) {
  const double a = (outer + inner) / 2, focal = norm(inner_centre) / 2, b = std::sqrt(a * a - focal * focal);
  const Vec2 along = focal > 0 ? normalized(inner_centre) : Vec2{1, 0}, middle = inner_centre / 2;
  return {{[=](double t) {
             return middle + along * (a * std::cos(2 * pi * t)) +
                    left_normal(along) * (b * std::sin(2 * pi * t));
           },
           2000}};
}

}  // namespace beadmesh::reference
