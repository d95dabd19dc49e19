#include "beadmesh/mesh/size_field.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

/// Change of the target size per length outside a ball: elements grow by about a quarter from one to the
/// next.
constexpr double growth = 0.25;
/// A step of sampling is at most this share of the least target size.
constexpr double step_share = 0.2;
/// Triangles are halved at most so often: 2^24 pieces of a facet where the size changes.
constexpr int most_halvings = 24;

/// Largest normal curvature along the sides of a facet, by the normals at its corners, 1/mm.
double curvature_of(const Facets& facets, Index triangle) {
  double largest = 0;
  for (int k = 0; k < 3; ++k) {
    const Triangle& t = facets.triangles[triangle];
    const Vec3 side = facets.points[t[(k + 1) % 3]] - facets.points[t[k]];
    const Vec3 turn = corner_normal(facets, triangle, (k + 1) % 3) - corner_normal(facets, triangle, k);
    if (squared_norm(side) > 0) largest = std::max(largest, std::abs(dot(turn, side)) / squared_norm(side));
  }
  return largest;
}

/// Curvature along a polyline, averaged over a window about each place.
class PolylineCurvature {
 public:
  PolylineCurvature(const Panel& panel, const Chain& chain, double reach)
      : arc_(chain.arc_length), reach_(reach), turned_{0} {
    for (size_t i = 1; i < chain.points.size(); ++i) {
      const bool inner = i + 1 < chain.points.size();
      const Vec3 at = panel.points[chain.points[i]];
      turned_.push_back(turned_.back() + (inner ? angle_between(at - panel.points[chain.points[i - 1]],
                                                                panel.points[chain.points[i + 1]] - at)
                                                : 0));
    }
  }

  double at(double place) const {
    const double low = std::max(0.0, place - reach_), high = std::min(arc_.back(), place + reach_);
    // Turns strictly inside the window; they stand for half a segment on either side of it.
    const auto first = std::upper_bound(arc_.begin(), arc_.end(), low) - arc_.begin();
    const auto last = std::lower_bound(arc_.begin(), arc_.end(), high) - arc_.begin();
    if (first < 1 || last <= first) return 0;
    const double from = (arc_[first - 1] + arc_[first]) / 2;
    const double to = (arc_[last - 1] + arc_[std::min<size_t>(last, arc_.size() - 1)]) / 2;
    return to > from ? (turned_[last - 1] - turned_[first - 1]) / (to - from) : 0;
  }

 private:
  const std::vector<double>& arc_;
  double reach_;
  std::vector<double> turned_;  ///< up to and at each point
};

}  // namespace

Result<void> check_local_sizes(const std::vector<LocalSize>& local, double min_edge) {
  const auto is_length = [](double x) { return std::isfinite(x) && x > 0; };
  for (const LocalSize& one : local) {
    if (!std::isfinite(norm(one.point)) || !is_length(one.radius) || !is_length(one.size))
      return fail("control.local_size", "a local size has a point, radius or size that is no length",
                  "radius and size must be above 0");
    if (one.size < min_edge)
      return fail("control.local_size", "a local size is below the minimum edge length",
                  "the minimum edge length holds everywhere");
  }
  return {};
}

std::vector<double> ChainSizing::stations(int elements) const {
  std::vector<double> out{0};
  size_t i = 1;
  for (int k = 1; k < elements; ++k) {
    const double target = count() * k / elements;
    while (i + 1 < at.size() && at[i] < target) ++i;
    const double share = (target - at[i - 1]) / std::max(at[i] - at[i - 1], 1e-300);
    out.push_back(arc_length[i - 1] + share * (arc_length[i] - arc_length[i - 1]));
  }
  out.push_back(arc_length.back());
  return out;
}

double SizeField::at(Vec3 point) const {
  double size = size_;
  for (const LocalSize& one : local_) {
    const double change = growth * std::max(0.0, distance(point, one.point) - one.radius);
    size = std::clamp(size, one.size - change, one.size + change);
  }
  return size;
}

/// Beyond the rim of a ball: how far its size is felt at most.
double SizeField::ramp_width(const LocalSize& local) const {
  double change = std::abs(size_ - local.size);
  for (const LocalSize& one : local_) change = std::max(change, std::abs(one.size - local.size));
  return change / growth;
}

/// Does the size change within `reach` of the point?
bool SizeField::varies_near(Vec3 centre, double reach) const {
  return std::any_of(local_.begin(), local_.end(), [&](const LocalSize& one) {
    const double beyond = distance(centre, one.point) - one.radius;
    return beyond >= -reach && beyond <= ramp_width(one) + reach;
  });
}

/// Facets where the size changes are halved until they are smaller than an element.
double SizeField::elements_in(Vec3 a, Vec3 b, Vec3 c, double largest, int depth) const {
  const double ab = distance(a, b), bc = distance(b, c), ca = distance(c, a);
  if (bc > std::max(ab, ca)) return elements_in(b, c, a, largest, depth);
  if (ca > std::max(ab, bc)) return elements_in(c, a, b, largest, depth);
  const Vec3 centre = (a + b + c) / 3;
  const double size = std::min(at(centre), largest);
  if (ab <= size || depth == most_halvings || !varies_near(centre, ab))
    return norm(cross(b - a, c - a)) / 2 / (size * size);
  const Vec3 middle = (a + b) / 2;
  return elements_in(a, middle, c, largest, depth + 1) + elements_in(middle, b, c, largest, depth + 1);
}

double SizeField::size_on_curvature(double curvature) const {
  if (chord_.deviation <= 0 || curvature <= 0) return 1e300;
  return std::max(chord_.finest, std::sqrt(8 * chord_.deviation / curvature));
}

double SizeField::of_face(const Facets& facets) const {
  if (is_uniform()) return size_;
  double area = 0, elements = 0;
  for (Index k = 0; k < Index(facets.triangles.size()); ++k) {
    const Triangle& t = facets.triangles[k];
    const Vec3 a = facets.points[t[0]], b = facets.points[t[1]], c = facets.points[t[2]];
    const double largest = chord_.deviation > 0 ? size_on_curvature(curvature_of(facets, k)) : 1e300;
    area += norm(cross(b - a, c - a)) / 2;
    elements += elements_in(a, b, c, largest, 0);
  }
  const bool untouched = std::abs(elements * size_ * size_ - area) <= 1e-9 * area;
  return untouched ? size_ : std::sqrt(area / elements);
}

ChainSizing SizeField::along(const Panel& panel, const Chain& chain) const {
  double least = size_;
  for (const LocalSize& one : local_) least = std::min(least, one.size);
  if (chord_.deviation > 0) least = std::min(least, std::max(chord_.finest, 0.1 * size_));
  const PolylineCurvature curvature(panel, chain, size_ / 2);
  ChainSizing out{{0}, {0}, at(panel.points[chain.points[0]])};
  for (size_t i = 1; i < chain.points.size(); ++i) {
    const Vec3 a = panel.points[chain.points[i - 1]], b = panel.points[chain.points[i]];
    const double length = chain.arc_length[i] - chain.arc_length[i - 1];
    const int steps = is_uniform() ? 1 : std::max(1, int(std::ceil(length / (step_share * least))));
    for (int k = 0; k < steps; ++k) {
      double size = at(lerp(a, b, (k + 0.5) / steps));
      if (chord_.deviation > 0)
        size = std::min(
            size, size_on_curvature(curvature.at(chain.arc_length[i - 1] + length * (k + 0.5) / steps)));
      out.finest = std::min(out.finest, size);
      out.arc_length.push_back(chain.arc_length[i - 1] + length * (k + 1) / steps);
      out.at.push_back(out.at.back() + length / steps / size);
    }
  }
  return out;
}

}  // namespace beadmesh
