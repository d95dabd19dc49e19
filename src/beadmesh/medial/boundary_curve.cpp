#include "beadmesh/medial/boundary_curve.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

double signed_angle(Vec2 a, Vec2 b) {
  return std::atan2(cross(a, b), dot(a, b));
}

Vec2 rotated(Vec2 v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {v.x * c - v.y * s, v.x * s + v.y * c};
}

}  // namespace

BoundaryCurve::BoundaryCurve(const PlanarRegion& region, double corner_angle)
    : region_(region), size_(diagonal(region)) {
  std::vector<double> wobble;
  for (PlanarLoop& loop : region_.loops) {
    Loop made = make_loop(loop);
    const bool tagged = loop.corner.size() == loop.points.size();
    if (!tagged) {
      loop.corner.assign(loop.points.size(), false);
      for (std::size_t i = 0; i < loop.points.size(); ++i)
        loop.corner[i] = std::abs(made.turn[i]) > pi - corner_angle;
    }
    for (std::size_t i = 0; i < loop.points.size(); ++i)
      made.wall_end.push_back(loop.corner[i] && made.turn[i] > 0);
    bend_pieces(made, smooth_points(made, loop.corner, tagged));
    measure_deviations(made, loop.corner, wobble);
    loops_.push_back(std::move(made));
  }
  if (wobble.size() < 8) return;
  const auto middle = wobble.begin() + static_cast<std::ptrdiff_t>(wobble.size() / 2);
  std::nth_element(wobble.begin(), middle, wobble.end());
  // The wobble (fourth difference / 4) of points off by sigma each has the median 1.41 sigma; 2 sigma is the
  // amplitude.
  const double amplitude = *middle * (2 / 1.41);
  if (amplitude > 1e-9 * size_) noise_ = amplitude;
}

BoundaryCurve::Loop BoundaryCurve::make_loop(const PlanarLoop& loop) {
  Loop made;
  const std::size_t n = loop.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    Piece piece;
    piece.a = loop.points[i];
    piece.b = loop.points[(i + 1) % n];
    piece.start = made.length;
    piece.length = distance(piece.a, piece.b);
    made.length += piece.length;
    made.pieces.push_back(piece);
    made.turn.push_back(signed_angle(loop.points[i] - loop.points[(i + n - 1) % n], piece.b - piece.a));
  }
  return made;
}

std::vector<char> BoundaryCurve::smooth_points(const Loop& loop, const std::vector<bool>& corner,
                                               bool tagged) const {
  constexpr double greatest_turn = radians(60);
  constexpr double greatest_bulge = 1e-3;  // of the size, without tags
  const std::size_t n = loop.pieces.size();
  std::vector<char> candidate(n), smooth(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double turn = std::abs(loop.turn[i]);
    const double bulge = turn / 8 * std::min(loop.pieces[i].length, loop.pieces[(i + n - 1) % n].length);
    candidate[i] = !corner[i] && turn < greatest_turn && (tagged || bulge < greatest_bulge * size_);
  }
  // A single blunt point between corners is a polygon's, not a curve's.
  for (std::size_t i = 0; i < n; ++i)
    smooth[i] = candidate[i] && (tagged || candidate[(i + 1) % n] || candidate[(i + n - 1) % n]);
  return smooth;
}

// The tangent at a smooth point splits the turn so that both neighbouring pieces bulge by the same height. On
// evenly spaced points of a circle that is the circle's tangent; where a long straight segment meets a
// facetted arc it is nearly the segment's direction, and the straight side stays straight.
void BoundaryCurve::bend_pieces(Loop& loop, const std::vector<char>& smooth) {
  const std::size_t n = loop.pieces.size();
  for (std::size_t i = 0; i < n; ++i) {
    Piece& piece = loop.pieces[i];
    const std::size_t next = (i + 1) % n, before = (i + n - 1) % n;
    const double length_before = loop.pieces[before].length, length_after = loop.pieces[next].length;
    double leave = -loop.turn[i] * length_before / (length_before + piece.length);
    double arrive = loop.turn[next] * length_after / (length_after + piece.length);
    if (!smooth[i] && !smooth[next])
      leave = arrive = 0;
    else if (!smooth[i])
      leave = -arrive;
    else if (!smooth[next])
      arrive = -leave;
    piece.straight = std::max(std::abs(leave), std::abs(arrive)) < 1e-12;
    const Vec2 chord = piece.b - piece.a;
    const double half_leave = std::cos(leave / 2), half_arrive = std::cos(arrive / 2);
    piece.leave = rotated(chord, leave) / (half_leave * half_leave);
    piece.arrive = rotated(chord, arrive) / (half_arrive * half_arrive);
  }
}

void BoundaryCurve::measure_deviations(Loop& loop, const std::vector<bool>& corner,
                                       std::vector<double>& wobble) {
  const std::size_t n = loop.pieces.size();
  std::vector<double> deviation(n, 0);  // of a smooth point from the chord of its neighbours
  for (std::size_t i = 0; i < n; ++i) {
    if (corner[i]) continue;
    const Vec2 a = loop.pieces[(i + n - 1) % n].a, b = loop.pieces[i].b;
    const double chord = distance(a, b);
    if (chord > 0) deviation[i] = cross(b - a, loop.pieces[i].a - a) / chord;
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n, next = (i + 1) % n;
    if (corner[before] || corner[i] || corner[next]) continue;
    wobble.push_back(std::abs(deviation[i] - (deviation[before] + deviation[next]) / 2));
  }
  loop.tolerance.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) {
    double most = 0;
    for (std::size_t k = 0; k < 6; ++k) most = std::max(most, std::abs(deviation[(i + n * 6 + k - 2) % n]));
    loop.tolerance[i] = 1.25 * most;
  }
}

Index BoundaryCurve::segment_at(Index loop, double position) const {
  const std::vector<Piece>& pieces = loops_[loop].pieces;
  const auto after = std::upper_bound(pieces.begin(), pieces.end(), position,
                                      [](double s, const Piece& piece) { return s < piece.start; });
  return static_cast<Index>(std::max<std::ptrdiff_t>(0, after - pieces.begin() - 1));
}

double BoundaryCurve::position(Index loop, Index segment, double t) const {
  const Loop& on = loops_[loop];
  const double s = on.pieces[segment].start + t * on.pieces[segment].length;
  return s < on.length ? s : s - on.length;
}

Vec2 BoundaryCurve::polyline_point(Index loop, Index segment, double t) const {
  const Piece& piece = loops_[loop].pieces[segment];
  return lerp(piece.a, piece.b, t);
}

Vec2 BoundaryCurve::curve_point(Index loop, double position) const {
  const Piece& piece = loops_[loop].pieces[segment_at(loop, position)];
  return evaluate(piece, std::clamp((position - piece.start) / piece.length, 0.0, 1.0));
}

Vec2 BoundaryCurve::evaluate(const Piece& piece, double t) {
  if (piece.straight) return lerp(piece.a, piece.b, t);
  const double u = 1 - t;
  return piece.a * (u * u * (1 + 2 * t)) + piece.b * (t * t * (1 + 2 * u)) + piece.leave * (t * u * u) -
         piece.arrive * (u * t * t);
}

Contact BoundaryCurve::nearest_on_piece(Vec2 from, Index loop, Index segment) const {
  const Piece& piece = loops_[loop].pieces[segment];
  const Vec2 chord = piece.b - piece.a;
  double t = std::clamp(dot(from - piece.a, chord) / squared_norm(chord), 0.0, 1.0);
  if (!piece.straight) {
    for (int step = 0; step < 12; ++step) {
      const double u = 1 - t;
      const Vec2 gap = evaluate(piece, t) - from;
      const Vec2 velocity =
          chord * (6 * t * u) + piece.leave * (u * (1 - 3 * t)) + piece.arrive * (t * (3 * t - 2));
      const Vec2 bend = chord * (6 - 12 * t) + piece.leave * (6 * t - 4) + piece.arrive * (6 * t - 2);
      const double slope = dot(gap, velocity);
      double stiffness = squared_norm(velocity) + dot(gap, bend);
      // Near the centre of curvature the full second derivative vanishes; the chord's alone still points
      // downhill.
      if (stiffness < 0.05 * squared_norm(velocity)) stiffness = squared_norm(velocity);
      const double moved = std::clamp(t - slope / stiffness, 0.0, 1.0);
      const double change = std::abs(moved - t);
      t = moved;
      if (change < 1e-15) break;
    }
  }
  const Vec2 point = evaluate(piece, t);
  return {loop, segment, t, point, distance(from, point)};
}

Contact BoundaryCurve::nearest(Vec2 from, const SegmentRun& run) const {
  const Index n = segments(run.loop);
  Contact best = nearest_on_piece(from, run.loop, run.segment);
  Index best_offset = 0;
  for (Index k = 1; k < run.count; ++k) {
    const Contact other = nearest_on_piece(from, run.loop, (run.segment + k) % n);
    if (other.distance < best.distance) best = other, best_offset = k;
  }
  const int direction = best_offset == run.count - 1 && best.t > 0.5 ? 1
                        : best_offset == 0 && best.t < 0.5           ? -1
                                                                     : 0;
  for (Index k = run.count; direction != 0 && k < n; ++k) {
    const Index next = (best.segment + direction + n) % n;
    if (loops_[run.loop].wall_end[direction > 0 ? next : best.segment]) break;
    const Contact other = nearest_on_piece(from, run.loop, next);
    if (!(other.distance < best.distance)) break;
    best = other;
  }
  return best;
}

double BoundaryCurve::turning(Index loop, double position, double reach) const {
  const Loop& on = loops_[loop];
  const Index n = segments(loop), at = segment_at(loop, position);
  double sum = 0;
  double ahead = on.pieces[at].start + on.pieces[at].length - position;
  for (Index k = 1; k <= n && ahead < reach; ++k) {
    const Index i = (at + k) % n;
    sum += on.turn[i];
    ahead += on.pieces[i].length;
  }
  double behind = position - on.pieces[at].start;
  for (Index k = 0; k < n && behind <= reach; ++k) {
    const Index i = (at - k + n) % n;
    sum += on.turn[i];
    behind += on.pieces[(i - 1 + n) % n].length;
  }
  return sum;
}

}  // namespace beadmesh
