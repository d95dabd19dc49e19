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

/// The circle of the arc at the end of an axis: first through all that is near the disc, then through what
/// lies on it.
std::optional<Circle> end_arc(const std::vector<Vec2>& points, const Circle& start, double noise) {
  Circle circle = start;
  const double fine = std::max(1.5 * noise, 1e-4 * start.radius);
  for (double band = 0.04 * start.radius;; band = std::max(band / 3, fine)) {
    const std::vector<Vec2> on = points_near(points, circle, band);
    if (on.size() < 4 || arc_of(on, circle.centre) < least_contact) return std::nullopt;
    const std::optional<Circle> fit = fitted_circle(on, circle);
    if (!fit || distance(fit->centre, start.centre) > 0.3 * start.radius) return std::nullopt;
    const bool done = band <= fine && distance(fit->centre, circle.centre) < 0.1 * fine;
    circle = *fit;
    if (done) return circle;
    if (band <= fine) {
      const std::vector<Vec2> last = points_near(points, circle, fine);
      if (last.size() < 4 || arc_of(last, circle.centre) < least_contact) return std::nullopt;
      return fitted_circle(last, circle);
    }
  }
}

/// How many half-edges of the chain from a leaf can be closed before its tip protrudes by more than
/// `tolerance`.
std::size_t noise_length(const AxisTriangles& axis, const std::vector<Index>& chain, double tolerance) {
  const Circle& tip = axis.cluster(axis.cluster_of(chain[0])).tip;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i)
    if (protrusion(tip, axis.cluster(axis.cluster_of(axis.twin(chain[i]))).circle) > tolerance) return i;
  return chain.size() - 1;
}

void settle_end(AxisTriangles& axis, const BoundaryCurve& curve, const BoundarySamples& samples,
                const PruneTolerance& tolerance, Index leaf) {
  const std::vector<Index> chain = axis.chain(leaf);
  const Circle tip = axis.cluster(axis.cluster_of(leaf)).circle;
  const double local =
      std::min(std::max(tolerance.at(axis.left(leaf)), tolerance.at(axis.right(leaf))), 0.25 * tip.radius);
  const auto cut_back = [&](std::size_t count, const Circle& circle) {
    const Index keep = axis.cluster_of(leaf);
    for (std::size_t i = 0; i < count; ++i) axis.close(chain[i], keep);
    axis.cluster(keep).circle = circle;
  };
  for (std::size_t count = noise_length(axis, chain, local);; --count) {
    const Circle inner = axis.cluster(axis.cluster_of(chain[count])).circle;
    const Sector sector{axis.left(chain[count]), axis.right(chain[count])};
    if (const auto arc = end_arc(points_of(samples, sector), inner, curve.noise()))
      return cut_back(count, *arc);
    if (count == 0) break;
  }
  const std::size_t noisy = curve.noise() > 0 ? noise_length(axis, chain, tolerance.noise()) : 0;
  if (noisy > 0) cut_back(noisy, axis.cluster(axis.cluster_of(chain[noisy])).circle);
}

}  // namespace

void settle_ends(AxisTriangles& axis, const BoundaryCurve& curve, const BoundarySamples& samples,
                 const PruneTolerance& tolerance) {
  for (const AxisNode& node : axis.march().nodes) {
    if (node.out.size() != 1 || axis.cluster(node.triangle).corner != no_index) continue;
    settle_end(axis, curve, samples, tolerance, node.out[0]);
  }
}

}  // namespace beadmesh
