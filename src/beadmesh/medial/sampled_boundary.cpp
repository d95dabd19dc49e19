#include "beadmesh/medial/sampled_boundary.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "beadmesh/delaunay/boundary_splitter.h"

namespace beadmesh {
namespace {

constexpr double radius_share = 0.5;          // greatest length of a segment / circumradius of its triangle
constexpr double facet_share = 0.8;           // the same for a facet of a curve
constexpr double straight_share = 1.0 / 128;  // of a straight side that faces another, where they are near
constexpr double least_gap = 1e-3;            // of a contact to the samples beside it / length between these
constexpr double least_part = 0.05;           // of a segment that is cut off

Result<Triangulation> triangulated(const BoundarySamples& samples) {
  std::vector<Vec2> points;
  points.reserve(samples.samples.size());
  std::vector<std::vector<Index>> loops(samples.first.size() - 1);
  for (std::size_t l = 0; l < loops.size(); ++l) loops[l].reserve(samples.first[l + 1] - samples.first[l]);
  for (const BoundarySample& sample : samples.samples) {
    loops[sample.loop].push_back(static_cast<Index>(points.size()));
    points.push_back(sample.point);
  }
  return triangulate(points, loops);
}

/// Enough segments between two corners, at even distances, where no facet forbids it.
BoundarySamples with_least_segments(const BoundaryCurve& curve, int least) {
  BoundarySamples given = samples_of(curve.tagged_region()), made;
  made.samples.reserve(given.samples.size());
  for (std::size_t l = 0; l + 1 < given.first.size(); ++l) {
    made.first.push_back(static_cast<Index>(made.samples.size()));
    const auto loop = static_cast<Index>(l), n = given.first[l + 1] - given.first[l];
    // From a corner to the next one, or once around a loop without any.
    Index first = 0;
    while (first < n && !curve.is_corner(loop, first)) ++first;
    std::vector<int> parts(n, 1);
    bool any = false;
    for (Index at = 0; at < n;) {
      Index count = 1;
      const auto segment = [&](Index k) { return (first + at + k) % n; };
      while (at + count < n && !curve.is_corner(loop, segment(count))) ++count;
      for (Index k = 0; k < count && count < least; ++k)
        if (!curve.is_facet(loop, segment(k))) {
          parts[segment(k)] = (least + count - 1) / count;
          any = true;
        }
      at += count;
    }
    if (!any) {
      made.samples.insert(made.samples.end(), given.samples.begin() + given.first[l],
                          given.samples.begin() + given.first[l + 1]);
      continue;
    }
    for (Index i = 0; i < n; ++i) {
      BoundarySample sample = given.samples[given.first[l] + i];
      made.samples.push_back(sample);
      for (int part = 1; part < parts[i]; ++part) {
        sample.corner = false;
        sample.t = static_cast<double>(part) / parts[i];
        sample.point = curve.point({loop, i, sample.t});
        made.samples.push_back(sample);
      }
    }
  }
  made.first.push_back(static_cast<Index>(made.samples.size()));
  return made;
}

class Sampler {
 public:
  Sampler(const BoundaryCurve& curve, const SamplingOptions& options, BoundarySplitter& splitter)
      : curve_(curve), options_(options), splitter_(splitter), least_(curve.tolerances().segment) {}

  /// False where there would be too many samples.
  bool run() {
    std::vector<Index> round(splitter_.count());
    for (Index i = 0; i < splitter_.count(); ++i) round[i] = i;
    while (!round.empty()) {
      touched_.clear();
      for (const Index i : round) {
        if (splitter_.count() > options_.max_samples && splitter_.count() > splitter_.given()) return false;
        look_at(i);
      }
      std::sort(touched_.begin(), touched_.end());
      touched_.erase(std::unique(touched_.begin(), touched_.end()), touched_.end());
      round.swap(touched_);
    }
    return true;
  }

 private:
  double length(Index edge) const {
    return distance(splitter_.sample(edge).point, splitter_.sample(splitter_.next(edge)).point);
  }
  bool is_convex_corner(Index i) const {
    const BoundarySample& sample = splitter_.sample(i);
    return sample.corner && curve_.is_convex_corner(sample.loop, sample.segment);
  }
  bool is_facet(Index edge) const {
    return curve_.is_facet(splitter_.sample(edge).loop, splitter_.sample(edge).segment);
  }

  void look_at(Index edge) {
    const double long_is = length(edge);
    const bool may_halve =
        long_is >= 2 * least_ && (is_too_long(edge, long_is) || is_ungraded(edge, long_is));
    if (may_halve) return halve(edge, long_is);
    make_ear(edge);
    make_ear(splitter_.next(edge));
  }

  bool is_too_long(Index edge, double length) const {
    if (options_.spacing > 0 && length > options_.spacing && !is_facet(edge)) return true;
    const Index next = splitter_.next(edge), apex = splitter_.apex(edge);
    if (apex == splitter_.next(next) && is_convex_corner(next)) return false;  // an ear
    if (apex == splitter_.previous(edge) && is_convex_corner(edge)) return false;
    const Vec2 a = splitter_.sample(edge).point, b = splitter_.sample(next).point,
               c = splitter_.sample(apex).point;
    const bool facet = is_facet(edge);
    // length = 2 R sin(angle at the apex)
    const double cosine = dot(a - c, b - c), sine = cross(a - c, b - c);
    const double greatest_sine = (facet ? facet_share : radius_share) / 2;
    const bool thick = sine * sine <= greatest_sine * greatest_sine * (sine * sine + cosine * cosine);
    if (cosine >= 0 && (thick || (options_.spacing > 0 && !facet))) return false;
    return !(is_dense_beside_straight(edge, length) && faces_straight(edge, apex));
  }

  /// Between two straight sides the triangles are in the right order at any density, however near these come
  /// to each other, at a corner for instance.
  bool is_dense_beside_straight(Index edge, double length) const {
    const BoundarySample& from = splitter_.sample(edge);
    return curve_.is_straight(from.loop, from.segment) &&
           length < straight_share * curve_.chord(from.loop, from.segment);
  }
  bool faces_straight(Index edge, Index apex) const {
    const BoundarySample &from = splitter_.sample(edge), &to = splitter_.sample(apex);
    const bool itself = from.loop == to.loop && from.segment == to.segment;
    return !itself && to.t > 0 && curve_.is_straight(to.loop, to.segment);
  }

  bool is_ungraded(Index edge, double length) const {
    if (is_facet(edge)) return false;
    const Index next = splitter_.next(edge), before = splitter_.previous(edge);
    return length > options_.grading * (1 + 1e-9) * this->length(next) ||
           length > options_.grading * (1 + 1e-9) * this->length(before);
  }

  /// The two legs of a convex corner: cut to the shorter one, then both to half while they have no triangle.
  void make_ear(Index edge) {
    if (!is_convex_corner(edge)) return;
    const Index before = splitter_.previous(edge);
    const double length = this->length(edge), other = this->length(before), shorter = std::min(length, other);
    if (std::abs(length - other) > 1e-9 * length) {
      cut_from_start(edge, length, shorter);
      cut_from_end(before, other, shorter);
    }
    if (splitter_.is_ear(edge) || shorter < 2 * curve_.tolerances().leg) return;
    split(edge, shorter / 2 / this->length(edge));
    split(splitter_.previous(edge), 1 - shorter / 2 / this->length(splitter_.previous(edge)));
  }

  void cut_from_start(Index edge, double length, double wanted) {
    if (!is_facet(edge) && wanted > least_part * length && wanted < (1 - least_part) * length)
      split(edge, wanted / length);
  }
  void cut_from_end(Index edge, double length, double wanted) {
    cut_from_start(edge, length, length - wanted);
  }

  /// In the middle; at a corner so that the leg is as long as the other one, where that is about half.
  void halve(Index edge, double length) {
    double part = 0.5;
    const auto leg = [&](Index other) { return this->length(other) / length; };
    const auto is_about_half = [](double share) { return share > 0.3 && share < 0.7; };
    const Index next = splitter_.next(edge);
    if (is_convex_corner(edge) && is_about_half(leg(splitter_.previous(edge))))
      part = leg(splitter_.previous(edge));
    else if (is_convex_corner(next) && is_about_half(leg(next)))
      part = 1 - leg(next);
    split(edge, part);
  }

  void split(Index edge, double part) {
    const BoundarySample &from = splitter_.sample(edge), &to = splitter_.sample(splitter_.next(edge));
    BoundarySample added = from;
    added.corner = false;
    added.t = from.t + part * ((to.segment == from.segment && to.t > from.t ? to.t : 1.0) - from.t);
    added.point = curve_.point({from.loop, from.segment, added.t});
    const Vec2 on_chord = lerp(from.point, to.point, part);
    const Index made = splitter_.split(edge, added, on_chord, touched_);
    if (made == no_index) return;
    touched_.push_back(splitter_.previous(edge));
    touched_.push_back(splitter_.next(made));
  }

  const BoundaryCurve& curve_;
  const SamplingOptions& options_;
  BoundarySplitter& splitter_;
  double least_;
  std::vector<Index> touched_;
};

}  // namespace

Result<SampledBoundary> sampled_boundary(const BoundaryCurve& curve, const SamplingOptions& options) {
  BoundarySamples samples = with_least_segments(curve, options.min_segments);
  Result<Triangulation> triangulation = triangulated(samples);
  if (!triangulation) return Failure(triangulation.error());
  BoundarySplitter splitter(std::move(samples), std::move(*triangulation));
  if (!Sampler(curve, options, splitter).run())
    return fail(
        "medial.too_many_samples",
        "more than " + std::to_string(options.max_samples) + " samples of the boundary would be needed",
        "two sides of the boundary come very near to each other; allow more samples or simplify it");
  SampledBoundary sampled;
  splitter.finish(sampled.samples, sampled.triangulation);
  return sampled;
}

bool add_samples(SampledBoundary& sampled, const std::vector<BoundaryPlace>& places,
                 const BoundaryCurve& curve) {
  const auto before = [](const BoundarySample& sample, const BoundaryPlace& place) {
    return sample.segment != place.segment ? sample.segment < place.segment : sample.t < place.t;
  };
  const double least = curve.tolerances().contact;
  BoundarySplitter splitter(std::move(sampled.samples), std::move(sampled.triangulation));
  const std::vector<Index> first = splitter.firsts();
  const Index given = splitter.count();
  std::vector<Index> touched;
  for (const BoundaryPlace& place : places) {
    // The last given sample at or before the place, then onwards over those that came since.
    Index low = first[place.loop], high = first[place.loop + 1];
    while (high - low > 1) {
      const Index middle = (low + high) / 2;
      (before(splitter.sample(middle), place) ? low : high) = middle;
    }
    while (splitter.next(low) != first[place.loop] && before(splitter.sample(splitter.next(low)), place))
      low = splitter.next(low);
    const BoundarySample &from = splitter.sample(low), &to = splitter.sample(splitter.next(low));
    BoundarySample added{curve.point(place), place.t, place.loop, place.segment, false};
    const double gap = std::max(least, least_gap * distance(from.point, to.point));
    if (distance(from.point, added.point) < gap || distance(to.point, added.point) < gap) continue;
    const Vec2 along = to.point - from.point;
    const double part = std::clamp(dot(added.point - from.point, along) / squared_norm(along), 0.0, 1.0);
    splitter.split(low, added, lerp(from.point, to.point, part), touched);
  }
  const bool any = splitter.count() > given;
  splitter.finish(sampled.samples, sampled.triangulation);
  return any;
}

}  // namespace beadmesh
