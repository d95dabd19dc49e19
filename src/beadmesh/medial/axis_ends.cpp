#include <algorithm>
#include <optional>

#include "beadmesh/medial/axis_pruning.h"
#include "beadmesh/medial/circle_fit.h"

namespace beadmesh {
namespace {

constexpr double least_contact = radians(60);  ///< a shorter arc of contact does not fix a centre

std::vector<Vec2> points_of(const BoundarySamples& samples, Sector sector) {
  std::vector<Vec2> points{samples.samples[sector.first].point};
  for (Index i = sector.first; i != sector.last;) {
    i = next_sample(samples, i);
    points.push_back(samples.samples[i].point);
  }
  return points;
}

/// Enough of the points to find an arc's circle.
std::vector<Vec2> some_of(const std::vector<Vec2>& points) {
  constexpr std::size_t most = 256;
  if (points.size() <= 2 * most) return points;
  std::vector<Vec2> some;
  for (std::size_t i = 0; i < points.size(); i += points.size() / most) some.push_back(points[i]);
  some.push_back(points.back());
  return some;
}

/// The circle of the arc at the end of an axis: first through all that is near the disc, then through what
/// lies on it.
std::optional<Circle> end_arc(const std::vector<Vec2>& points, const Circle& start, double noise) {
  const auto arc_near = [](const std::vector<Vec2>& of, const Circle& circle,
                           double band) -> std::optional<Circle> {
    const std::vector<Vec2> on = points_near(of, circle, band);
    if (on.size() < 4 || arc_of(on, circle.centre) < least_contact) return std::nullopt;
    return fitted_circle(on, circle);
  };
  const std::vector<Vec2> some = some_of(points);
  const double fine = std::max(1.5 * noise, 1e-4 * start.radius);
  Circle circle = start;
  for (double band = 0.04 * start.radius;; band = std::max(band / 3, fine)) {
    const std::optional<Circle> fit = arc_near(some, circle, band);
    if (!fit || distance(fit->centre, start.centre) > 0.3 * start.radius) return std::nullopt;
    circle = *fit;
    if (band <= fine) return arc_near(points, circle, fine);
  }
}

/// The half-edges from a leaf on that can be closed before its tip protrudes by more than `tolerance`, and
/// the one after them.
std::vector<Index> noisy_part(const AxisTriangles& axis, Index leaf, double tolerance) {
  const Circle tip = axis.tip(axis.cluster_of(leaf));
  std::vector<Index> passed{leaf};
  for (;;) {
    if (protrusion(tip, axis.cluster(axis.cluster_of(axis.twin(passed.back()))).circle) > tolerance)
      return passed;
    const Index out = axis.next_in_chain(passed.back());
    if (out == no_index || out == leaf) return passed;
    passed.push_back(out);
  }
}

void settle_end(AxisTriangles& axis, const BoundaryCurve& curve, const BoundarySamples& samples,
                const PruneTolerance& tolerance, Index leaf) {
  const Circle tip = axis.cluster(axis.cluster_of(leaf)).circle;
  const double local =
      std::min(std::max(tolerance.at(axis.left(leaf)), tolerance.at(axis.right(leaf))), 0.25 * tip.radius);
  const auto cut_back = [&](const std::vector<Index>& part, std::size_t count, const Circle& circle) {
    const Index keep = axis.cluster_of(leaf);
    for (std::size_t i = 0; i < count; ++i) axis.close(part[i], keep);
    axis.cluster(keep).circle = circle;
  };
  const std::vector<Index> part = noisy_part(axis, leaf, local);
  for (std::size_t count = part.size(); count-- > 0;) {
    const Circle inner = axis.cluster(axis.cluster_of(part[count])).circle;
    const Sector sector{axis.left(part[count]), axis.right(part[count])};
    if (const auto arc = end_arc(points_of(samples, sector), inner, curve.noise()))
      return cut_back(part, count, *arc);
  }
  if (curve.noise() == 0) return;
  const std::vector<Index> noisy = noisy_part(axis, leaf, tolerance.noise());
  if (noisy.size() > 1) cut_back(noisy, noisy.size() - 1, axis.cluster(axis.cluster_of(noisy.back())).circle);
}

}  // namespace

void settle_ends(AxisTriangles& axis, const BoundaryCurve& curve, const BoundarySamples& samples,
                 const PruneTolerance& tolerance) {
  for (const Index leaf : axis.leaves())
    if (axis.next_open(leaf) == leaf && axis.cluster(axis.cluster_of(leaf)).corner == no_index)
      settle_end(axis, curve, samples, tolerance, leaf);
}

}  // namespace beadmesh
