#include "beadmesh/medial/axis_polish.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace beadmesh {
namespace {

constexpr double exact_share = 0.02;  // of the rounding: nothing is gained by another step

struct Spread {
  double least, most, mean;
};

Spread spread_of(const std::vector<Contact>& feet) {
  Spread spread{feet[0].distance, feet[0].distance, 0};
  for (const Contact& foot : feet) {
    spread.least = std::min(spread.least, foot.distance);
    spread.most = std::max(spread.most, foot.distance);
    spread.mean += foot.distance / static_cast<double>(feet.size());
  }
  return spread;
}

/// Step of least norm that evens out the distances, to first order: their gradients are the unit vectors away
/// from the feet. False where these are nearly one.
bool even_step(const std::vector<Contact>& feet, Vec2 centre, double mean_distance, Vec2& step) {
  Vec2 mean;
  for (const Contact& foot : feet) mean += normalized(centre - foot.point) / static_cast<double>(feet.size());
  double xx = 0, xy = 0, yy = 0;
  Vec2 right;
  for (const Contact& foot : feet) {
    const Vec2 u = normalized(centre - foot.point) - mean;
    xx += u.x * u.x, xy += u.x * u.y, yy += u.y * u.y;
    right += u * (mean_distance - foot.distance);
  }
  const double half = (xx + yy) / 2, root = std::hypot((xx - yy) / 2, xy);
  const double large = half + root, small = half - root;
  if (large < 2e-4) return false;  // feet within about one degree
  const Vec2 axis = normalized(xx >= yy ? Vec2{(xx - yy) / 2 + root, xy} : Vec2{xy, (yy - xx) / 2 + root});
  step = axis * (dot(axis, right) / large);
  const Vec2 other = left_normal(axis);
  if (small > 1e-10 * large) step += other * (dot(other, right) / small);
  return true;
}

}  // namespace

SegmentRun run_of(const BoundaryCurve& curve, const BoundarySamples& samples, Sector sector) {
  const Index before = previous_sample(samples, sector.first), after = next_sample(samples, sector.last);
  const BoundarySample &from = samples.samples[before], &to = samples.samples[after];
  const Index loop = from.loop, n = curve.segments(loop);
  const Index first = from.segment;
  const Index last = to.t > 0 ? to.segment : (to.segment > 0 ? to.segment - 1 : n - 1);
  const Index loop_samples = samples.first[loop + 1] - samples.first[loop];
  Index span = sector.last - sector.first;
  if (span < 0) span += loop_samples;
  if (span + 2 >= loop_samples) return {loop, first, n};
  const bool around = first == last && to.segment == first && to.t < from.t;
  if (around) return {loop, first, n};
  return {loop, first, (last >= first ? last - first : last - first + n) + 1};
}

bool polish(const BoundaryCurve& curve, AxisPoint& point) {
  constexpr double least_apart = 4e-4;  // square of the distance of the unit vectors: about one degree
  constexpr int most_rounds = 20, patience = 6;
  const Vec2 start = point.circle.centre;
  const double reach = point.circle.radius, precise = exact_share * curve.tolerances().rounding;
  FootFollower left(curve, point.feet[0]), right(curve, point.feet[1]);
  Vec2 centre = start;
  AxisPoint best;
  double best_gap = std::numeric_limits<double>::infinity(), best_square = 0;
  for (int round = 0; round < most_rounds && best_gap > precise; ++round) {
    const Contact &l = left.follow(centre), &r = right.follow(centre);
    const Vec2 to_left = l.distance > 0 ? (centre - l.point) / l.distance : Vec2{};
    const Vec2 apart = to_left - (r.distance > 0 ? (centre - r.point) / r.distance : Vec2{});
    const double gap = l.distance - r.distance, square = squared_norm(apart);
    if (std::abs(gap) < best_gap) {
      best_gap = std::abs(gap);
      best_square = square;
      best = {{centre, std::min(l.distance, r.distance)}, {l.place, r.place}, l.point - r.point};
    } else if (round > patience || best_gap < curve.tolerances().rounding) {
      break;
    }
    if (square < least_apart) return false;
    const double longest = 0.5 * reach / std::sqrt(square);
    centre -= apart * std::clamp(gap / square, -longest, longest);
    if (!(squared_norm(centre - start) <= 2.25 * reach * reach)) break;
  }
  if (!(best_gap <= 1e-7 * best.circle.radius) || best_square < least_apart) return false;
  point = best;
  return true;
}

double set_feet(const BoundaryCurve& curve, AxisPoint& point) {
  const Contact left = curve.nearest(point.circle.centre, point.feet[0]);
  const Contact right = curve.nearest(point.circle.centre, point.feet[1]);
  point.circle.radius = std::min(left.distance, right.distance);
  point.feet = {left.place, right.place};
  point.across = left.point - right.point;
  return std::abs(left.distance - right.distance);
}

std::vector<Contact> feet_of(const BoundaryCurve& curve, const std::vector<SegmentRun>& runs, Vec2 centre) {
  std::vector<Contact> feet;
  for (const SegmentRun& run : runs) feet.push_back(curve.nearest(centre, run));
  return feet;
}

std::vector<Contact> polish(const BoundaryCurve& curve, const std::vector<SegmentRun>& runs, Circle& circle) {
  const double reach = circle.radius;
  Vec2 centre = circle.centre, best = centre;
  std::vector<Contact> feet = feet_of(curve, runs, centre), best_feet = feet;
  double best_gap = spread_of(feet).most - spread_of(feet).least;
  for (int round = 0; round < 20 && best_gap > exact_share * curve.tolerances().rounding; ++round) {
    Vec2 step;
    if (!even_step(feet, centre, spread_of(feet).mean, step)) return {};
    const double longest = 0.5 * reach;
    if (norm(step) > longest) step = step * (longest / norm(step));
    centre += step;
    if (!std::isfinite(centre.x) || !std::isfinite(centre.y) || distance(centre, circle.centre) > 1.5 * reach)
      return {};
    feet = feet_of(curve, runs, centre);
    const Spread spread = spread_of(feet);
    if (spread.most - spread.least < best_gap) {
      best_gap = spread.most - spread.least;
      best = centre, best_feet = feet;
    } else if (round > 6 || best_gap < curve.tolerances().rounding) {
      break;
    }
  }
  const double least = spread_of(best_feet).least;
  Vec2 step;
  const double allowed = runs.size() > 3 ? 1e-3 * least : 1e-7 * least;
  if (best_gap > allowed || !even_step(best_feet, best, least, step)) return {};
  circle = {best, least};
  return best_feet;
}

std::vector<Contact> polish_merged(const BoundaryCurve& curve, const std::vector<SegmentRun>& runs,
                                   Circle& circle) {
  const std::vector<Contact> feet = feet_of(curve, runs, circle.centre);
  std::vector<std::size_t> order(feet.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return feet[a].distance < feet[b].distance; });
  AxisPoint moved{circle, {feet[order[0]].place, feet[order[1]].place}, {}};
  polish(curve, moved);
  const std::vector<Contact> moved_feet = feet_of(curve, runs, moved.circle.centre);
  circle = {moved.circle.centre, spread_of(moved_feet).least};
  return moved_feet;
}

}  // namespace beadmesh
