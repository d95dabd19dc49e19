#include "beadmesh/medial/boundary_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace beadmesh {
namespace {

Vec2 mirrored(Vec2 v, Vec2 axis) {
  return axis * (2 * dot(v, axis) / squared_norm(axis)) - v;
}

bool is_zero(Vec2 v) {
  return v.x == 0 && v.y == 0;
}

}  // namespace

CurvePoint BoundaryPiece::at(double t) const {
  if (curve) {
    const double scale = to - from;
    const CurvePoint p = curve->at(from + t * scale);
    return {p.point, p.velocity * scale, p.acceleration * (scale * scale)};
  }
  if (straight) return {lerp(a, b, t), b - a, {}};
  const Vec2 bend = quadratic + cubic * (3 * t);
  return {a + (linear + (quadratic + cubic * t) * t) * t, linear + (quadratic + bend) * t, bend * 2};
}

double BoundaryCurve::chord(Index loop, Index segment) const {
  const Loop& on = loops_[loop];
  return (segment + 1 < segments(loop) ? on.start[segment + 1] : on.length) - on.start[segment];
}

bool BoundaryCurve::is_straight(Index loop, Index segment) const {
  const std::vector<char>& bent = loops_[loop].bent;
  return bent.empty() || !bent[segment];
}

bool BoundaryCurve::is_facet(Index loop, Index segment) const {
  return region_.loops[loop].curve.empty() && !is_straight(loop, segment);
}

double BoundaryCurve::position(const BoundaryPlace& place) const {
  const Loop& on = loops_[place.loop];
  const double s = on.start[place.segment] + place.t * chord(place.loop, place.segment);
  return s < on.length ? s : s - on.length;
}

BoundaryPlace BoundaryCurve::place_at(Index loop, double position) const {
  const Loop& on = loops_[loop];
  double s = std::fmod(position, on.length);
  if (s < 0) s += on.length;
  const auto after = std::upper_bound(on.start.begin(), on.start.end(), s);
  const auto segment = static_cast<Index>(std::max<std::ptrdiff_t>(0, after - on.start.begin() - 1));
  return {loop, segment, std::clamp((s - on.start[segment]) / chord(loop, segment), 0.0, 1.0)};
}

BoundaryPiece BoundaryCurve::piece(Index loop, Index segment) const {
  const PlanarLoop& of = region_.loops[loop];
  const Index next = segment + 1 < segments(loop) ? segment + 1 : 0;
  BoundaryPiece made;
  made.a = of.points[segment];
  made.b = of.points[next];
  if (!of.curve.empty()) {
    if (of.curve[segment] == no_index) return made;
    made.straight = false;
    made.curve = region_.curves[of.curve[segment]].get();
    made.from = of.parameters[segment][0];
    made.to = of.parameters[segment][1];
    return made;
  }
  if (loops_[loop].tangent.empty()) return made;
  Vec2 leave = loops_[loop].tangent[segment], arrive = loops_[loop].tangent[next];
  if (is_zero(leave) && is_zero(arrive)) return made;
  const Vec2 chord = made.b - made.a;
  if (is_zero(leave)) leave = mirrored(arrive, chord);
  if (is_zero(arrive)) arrive = mirrored(leave, chord);
  const double length = norm(chord);
  made.straight = std::max(std::abs(cross(leave, chord)), std::abs(cross(arrive, chord))) < 1e-12 * length;
  // Scaled so that the cubic is a circular arc's best fit: by 1 / cos^2 of half the angle to the chord.
  leave = leave * (2 * length / (1 + dot(leave, chord) / length));
  arrive = arrive * (2 * length / (1 + dot(arrive, chord) / length));
  made.linear = leave;
  made.quadratic = chord * 3 - leave * 2 - arrive;
  made.cubic = leave + arrive - chord * 2;
  return made;
}

Vec2 BoundaryCurve::point(const BoundaryPlace& place) const {
  return piece(place.loop, place.segment).at(place.t).point;
}

Vec2 BoundaryCurve::chord_point(const BoundaryPlace& place) const {
  const std::vector<Vec2>& points = region_.loops[place.loop].points;
  const Index next = place.segment + 1 < segments(place.loop) ? place.segment + 1 : 0;
  return lerp(points[place.segment], points[next], place.t);
}

bool BoundaryCurve::is_before(Vec2 point, const BoundaryPlace& place) const {
  const CurvePoint at = piece(place.loop, place.segment).at(place.t);
  return cross(at.velocity, point - at.point) >= 0;
}

double BoundaryCurve::signed_radius(const BoundaryPlace& place, Vec2& inward_normal) const {
  const CurvePoint p = piece(place.loop, place.segment).at(place.t);
  const double speed = norm(p.velocity), turn = cross(p.velocity, p.acceleration);
  inward_normal = left_normal(p.velocity) / speed;
  return turn == 0 ? std::numeric_limits<double>::infinity() : speed * speed * speed / turn;
}

double BoundaryCurve::tolerance(Index loop, Index segment) const {
  const std::vector<float>& of = loops_[loop].tolerance;
  return of.empty() ? 0 : of[segment];
}

// Newton on the distance, safeguarded: at a centre of curvature the second derivative vanishes, beyond it the
// distance has a maximum.
Contact BoundaryCurve::nearest_on_piece(Vec2 from, const BoundaryPiece& on, const BoundaryPlace& start) {
  if (on.straight) {
    const Vec2 chord = on.b - on.a;
    const double t = std::clamp(dot(from - on.a, chord) / squared_norm(chord), 0.0, 1.0);
    const Vec2 point = t == 1 ? on.b : on.a + chord * t;
    return {{start.loop, start.segment, t}, point, distance(from, point)};
  }
  double t = start.t;
  CurvePoint at = on.at(t);
  constexpr int most_steps = 30;
  constexpr double longest_step = 0.3;
  for (int step = 0; step < most_steps; ++step) {
    const Vec2 gap = at.point - from;
    const double square = squared_norm(at.velocity);
    double stiffness = square + dot(gap, at.acceleration);
    const bool is_quadratic = stiffness >= 0.05 * square;
    stiffness = stiffness > 0 ? std::max(stiffness, 1e-6 * square) : square;
    const double wanted = std::clamp(-dot(gap, at.velocity) / stiffness, -longest_step, longest_step);
    const double moved = std::clamp(t + wanted, 0.0, 1.0), change = std::abs(moved - t);
    if (change == 0) break;
    t = moved;
    at = on.at(t);
    // After a quadratic step the next is the square of it, and the distance does not feel the square of that.
    if (change < (is_quadratic ? 1e-5 : 1e-12)) break;
  }
  return {{start.loop, start.segment, t}, at.point, distance(from, at.point)};
}

Index BoundaryCurve::neighbour(Index loop, Index segment, int direction) const {
  const Index n = segments(loop);
  return direction > 0 ? (segment + 1 < n ? segment + 1 : 0) : (segment > 0 ? segment - 1 : n - 1);
}

// From one piece to the next while that is nearer; past a convex corner nothing faces the same wall.
Contact BoundaryCurve::downhill(Vec2 from, Contact best, Index most) const {
  const Index loop = best.place.loop;
  for (; most > 0 && (best.place.t == 0 || best.place.t == 1); --most) {
    const int direction = best.place.t == 1 ? 1 : -1;
    const Index next = neighbour(loop, best.place.segment, direction);
    if (loops_[loop].convex_corner[direction > 0 ? next : best.place.segment]) break;
    const Contact other = nearest_on_piece(from, piece(loop, next), {loop, next, direction > 0 ? 0.0 : 1.0});
    if (!(other.distance < best.distance)) break;
    best = other;
  }
  return best;
}

Contact BoundaryCurve::nearest(Vec2 from, const BoundaryPlace& start) const {
  return downhill(from, nearest_on_piece(from, piece(start.loop, start.segment), start),
                  segments(start.loop));
}

Contact BoundaryCurve::nearest(Vec2 from, const SegmentRun& run) const {
  const std::vector<Vec2>& points = region_.loops[run.loop].points;
  // By the chords first: only pieces that can bulge up to the nearest one are looked at.
  constexpr double greatest_bulge = 0.14;  // of the chord: a third of a half circle
  const bool curved = !loops_[run.loop].bent.empty(), exact = !region_.loops[run.loop].curve.empty();
  const std::vector<Vec2>& tangent = loops_[run.loop].tangent;
  double reach = std::numeric_limits<double>::infinity();
  const auto foot = [&](Index segment, double& t, double& bulge) {
    const Index next = segment + 1 < segments(run.loop) ? segment + 1 : 0;
    const Vec2 a = points[segment], chord = points[next] - a;
    const double square = squared_norm(chord);
    t = std::clamp(dot(from - a, chord) / square, 0.0, 1.0);
    if (!curved)
      bulge = 0;
    else if (exact)
      bulge = greatest_bulge * std::sqrt(square);
    else
      bulge = 0.5 * std::max(std::abs(cross(tangent[segment], chord)), std::abs(cross(tangent[next], chord)));
    return distance(from, a + chord * t);
  };
  double t, bulge;
  Index segment = run.segment;
  for (Index k = 0; k < run.count; ++k, segment = neighbour(run.loop, segment, 1))
    reach = std::min(reach, foot(segment, t, bulge) + bulge);
  Contact best;
  best.distance = std::numeric_limits<double>::infinity();
  segment = run.segment;
  for (Index k = 0; k < run.count; ++k, segment = neighbour(run.loop, segment, 1)) {
    const double to_chord = foot(segment, t, bulge);
    if (to_chord - bulge > reach) continue;
    const Contact other = nearest_on_piece(from, piece(run.loop, segment), {run.loop, segment, t});
    if (other.distance < best.distance) best = other;
  }
  return downhill(from, best, segments(run.loop) - run.count);
}

BoundaryPlace BoundaryCurve::nearest_chord(Vec2 from, const SegmentRun& run) const {
  const std::vector<Vec2>& points = region_.loops[run.loop].points;
  constexpr double from_behind = 1e6;
  const double region_square = size_ * size_;
  BoundaryPlace best{run.loop, run.segment, 0};
  double least = std::numeric_limits<double>::infinity();
  Index segment = run.segment;
  for (Index k = 0; k < run.count; ++k) {
    const Index next = segment + 1 < segments(run.loop) ? segment + 1 : 0;
    const Vec2 a = points[segment], chord = points[next] - a;
    const double t = std::clamp(dot(from - a, chord) / squared_norm(chord), 0.0, 1.0);
    double square = squared_norm(a + chord * t - from);
    // The back of a wall, around a concave corner, is no contact; where all are seen from behind, any start
    // will do.
    if (t > 0 && t < 1 && cross(chord, from - a) < 0) square += from_behind * region_square;
    if (square < least) least = square, best = {run.loop, segment, t};
    segment = next;
  }
  return best;
}

const Contact& FootFollower::follow(Vec2 from) {
  const Index segment = foot_.place.segment;
  foot_ = BoundaryCurve::nearest_on_piece(from, piece_, foot_.place);
  if (foot_.place.t > 0 && foot_.place.t < 1) return foot_;
  foot_ = curve_.downhill(from, foot_, curve_.segments(foot_.place.loop));
  if (foot_.place.segment != segment) piece_ = curve_.piece(foot_.place.loop, foot_.place.segment);
  return foot_;
}

double BoundaryCurve::turning(const BoundaryPlace& place, double reach) const {
  const PlanarLoop& loop = region_.loops[place.loop];
  const Index n = segments(place.loop);
  double sum = 0;
  Index at = place.segment;
  double ahead = (1 - place.t) * chord(place.loop, at);
  for (Index k = 1; k <= n && ahead < reach; ++k) {
    at = neighbour(place.loop, at, 1);
    sum += turn(loop, static_cast<std::size_t>(at));
    ahead += chord(place.loop, at);
  }
  at = place.segment;
  double behind = place.t * chord(place.loop, at);
  for (Index k = 0; k < n && behind <= reach; ++k) {
    sum += turn(loop, static_cast<std::size_t>(at));
    at = neighbour(place.loop, at, -1);
    behind += chord(place.loop, at);
  }
  return sum;
}

}  // namespace beadmesh
