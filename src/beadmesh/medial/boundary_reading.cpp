// How a boundary is read: corners, smooth points and their tangents, noise.
#include <algorithm>
#include <cmath>

#include "beadmesh/medial/boundary_curve.h"

namespace beadmesh {
namespace {

double signed_angle(Vec2 a, Vec2 b) {
  return std::atan2(cross(a, b), dot(a, b));
}

}  // namespace

BoundaryCurve::BoundaryCurve(const PlanarRegion& region, double corner_angle)
    : region_(region),
      loops_(region.loops.size()),
      size_(diagonal(region)),
      tolerances_(tolerances_of(region)) {
  std::vector<double> wobble;
  for (std::size_t l = 0; l < loops_.size(); ++l) read(l, corner_angle, wobble);
  if (wobble.size() < 8) return;
  const auto middle = wobble.begin() + static_cast<std::ptrdiff_t>(wobble.size() / 2);
  std::nth_element(wobble.begin(), middle, wobble.end());
  // The wobble (fourth difference / 4) of points off by sigma each has the median 1.41 sigma; 2 sigma is the
  // amplitude.
  const double amplitude = *middle * (2 / 1.41);
  if (amplitude > tolerances_.contact) noise_ = amplitude;
}

void BoundaryCurve::read(std::size_t l, double corner_angle, std::vector<double>& wobble) {
  PlanarLoop& loop = region_.loops[l];
  Loop& made = loops_[l];
  const std::size_t n = loop.points.size();
  const bool exact = !loop.curve.empty(), tagged = loop.corner.size() == n;
  std::vector<double> turns(n);
  made.start.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    made.start.push_back(made.length);
    made.length += distance(loop.points[i], loop.points[(i + 1) % n]);
    turns[i] = exact ? exact_turn(loop, i) : turn(loop, i);
  }
  if (!tagged) {
    loop.corner.assign(n, false);
    for (std::size_t i = 0; i < n; ++i) loop.corner[i] = std::abs(turns[i]) > pi - corner_angle;
  }
  made.convex_corner.reserve(n);
  for (std::size_t i = 0; i < n; ++i) made.convex_corner.push_back(loop.corner[i] && turns[i] > 0);
  if (!exact) made.tangent = tangents(loop, turns, smooth_points(loop, turns, tagged));
  mark_bent(l);
  measure_deviations(l, wobble);
}

void BoundaryCurve::mark_bent(std::size_t l) {
  const PlanarLoop& loop = region_.loops[l];
  if (loop.curve.empty() && loops_[l].tangent.empty()) return;
  std::vector<char>& bent = loops_[l].bent;
  bent.resize(loop.points.size());
  for (std::size_t i = 0; i < bent.size(); ++i)
    bent[i] = !piece(static_cast<Index>(l), static_cast<Index>(i)).straight;
}

double BoundaryCurve::turn(const PlanarLoop& loop, std::size_t i) const {
  const std::size_t n = loop.points.size();
  return signed_angle(loop.points[i] - loop.points[i > 0 ? i - 1 : n - 1],
                      loop.points[i + 1 < n ? i + 1 : 0] - loop.points[i]);
}

double BoundaryCurve::exact_turn(const PlanarLoop& loop, std::size_t i) const {
  const auto l = static_cast<Index>(&loop - region_.loops.data());
  const auto n = static_cast<Index>(loop.points.size()), at = static_cast<Index>(i);
  return signed_angle(piece(l, at > 0 ? at - 1 : n - 1).at(1).velocity, piece(l, at).at(0).velocity);
}

std::vector<char> BoundaryCurve::smooth_points(const PlanarLoop& loop, const std::vector<double>& turns,
                                               bool tagged) const {
  constexpr double greatest_turn = radians(60);
  constexpr double greatest_bulge = 1e-3;  // of the size, without tags
  const std::size_t n = loop.points.size();
  std::vector<char> candidate(n), smooth(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double turn = std::abs(turns[i]);
    const auto bulge = [&] {
      return turn / 8 *
             std::min(distance(loop.points[i], loop.points[(i + 1) % n]),
                      distance(loop.points[i], loop.points[(i + n - 1) % n]));
    };
    candidate[i] = !loop.corner[i] && turn < greatest_turn && (tagged || bulge() < greatest_bulge * size_);
  }
  // A single blunt point between corners is a polygon's, not a curve's.
  for (std::size_t i = 0; i < n; ++i)
    smooth[i] =
        candidate[i] && (tagged || candidate[i + 1 < n ? i + 1 : 0] || candidate[i > 0 ? i - 1 : n - 1]);
  return smooth;
}

// The tangent at a smooth point splits the turn so that both neighbouring pieces bulge by the same height. On
// evenly spaced points of a circle that is the circle's tangent; where a long straight segment meets a
// facetted arc it is nearly the segment's direction, and the straight side stays straight.
std::vector<Vec2> BoundaryCurve::tangents(const PlanarLoop& loop, const std::vector<double>& turns,
                                          const std::vector<char>& smooth) {
  const std::size_t n = loop.points.size();
  bool bends = false;
  for (std::size_t i = 0; i < n; ++i) bends |= smooth[i] && std::abs(turns[i]) > 1e-12;
  if (!bends) return {};
  std::vector<Vec2> tangents(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (!smooth[i]) continue;
    const Vec2 in = loop.points[i] - loop.points[i > 0 ? i - 1 : n - 1];
    const Vec2 out = loop.points[i + 1 < n ? i + 1 : 0] - loop.points[i];
    const double before = norm(in), after = norm(out), back = -turns[i] * before / (before + after);
    const Vec2 ahead = out / after;
    tangents[i] = ahead * std::cos(back) + left_normal(ahead) * std::sin(back);
  }
  return tangents;
}

void BoundaryCurve::measure_deviations(std::size_t l, std::vector<double>& wobble) {
  const PlanarLoop& loop = region_.loops[l];
  const std::size_t n = loop.points.size();
  std::vector<double> deviation(n, 0);  // of a smooth point from the chord of its neighbours
  double greatest = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (loop.corner[i]) continue;
    const Vec2 a = loop.points[i > 0 ? i - 1 : n - 1], b = loop.points[i + 1 < n ? i + 1 : 0];
    const double chord = distance(a, b);
    if (chord > 0) deviation[i] = cross(b - a, loop.points[i] - a) / chord;
    greatest = std::max(greatest, std::abs(deviation[i]));
  }
  if (loop.curve.empty())
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t before = i > 0 ? i - 1 : n - 1, next = i + 1 < n ? i + 1 : 0;
      if (loop.corner[before] || loop.corner[i] || loop.corner[next]) continue;
      wobble.push_back(std::abs(deviation[i] - (deviation[before] + deviation[next]) / 2));
    }
  if (greatest == 0) return;
  // A deviation is four times the facets' bulge. Where the curve is known, one and a half bulges are what
  // samples may be wrong by; a facetted curve may be off by more.
  const double share = loop.curve.empty() ? 1.25 : 0.375;
  std::vector<float>& tolerance = loops_[l].tolerance;
  tolerance.resize(n);
  const auto at = [&](std::size_t i) { return std::abs(deviation[i < n ? i : i % n]); };
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t first = i >= 2 ? i - 2 : i + 2 * n - 2;  // loops may be shorter than the window
    double most = 0;
    for (std::size_t k = 0; k < 6; ++k) most = std::max(most, at(first + k));
    tolerance[i] = static_cast<float>(share * most);
  }
}

}  // namespace beadmesh
