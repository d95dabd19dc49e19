// Random domains with holes: what holds for every medial object.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "beadmesh/medial/medial_object.h"
#include "medial/axis_comparison.h"
#include "medial/exact_region.h"
#include "medial/reference_axis.h"

namespace beadmesh {
namespace {

using namespace exact_shapes;
using namespace reference;

double between(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 100001) * 1e-5;
}

/// r(angle) = mean (1 + a few waves), always positive: a smooth star about a centre.
class WavyCircle final : public PlanarCurve {
 public:
  static constexpr int waves = 5;

  WavyCircle(Vec2 centre, double mean, double strength) : centre_(centre), mean_(mean) {
    for (int k = 0; k < waves; ++k) {
      cosine_[k] = between(-strength, strength) / (waves * (k + 1));
      sine_[k] = between(-strength, strength) / (waves * (k + 1));
    }
  }
  CurvePoint at(double t) const override {
    double r = 1, dr = 0, ddr = 0;
    for (int k = 0; k < waves; ++k) {
      const double n = k + 1, c = std::cos(n * t), s = std::sin(n * t);
      r += cosine_[k] * c + sine_[k] * s;
      dr += n * (sine_[k] * c - cosine_[k] * s);
      ddr -= n * n * (cosine_[k] * c + sine_[k] * s);
    }
    const Vec2 out{std::cos(t), std::sin(t)}, side = left_normal(out);
    return {centre_ + out * (mean_ * r), (out * dr + side * r) * mean_,
            (out * (ddr - r) + side * (2 * dr)) * mean_};
  }

 private:
  Vec2 centre_;
  double mean_, cosine_[waves], sine_[waves];
};

/// Up to five, between two circles; far enough from each other for radii of a third of `low`.
std::vector<Vec2> hole_centres(double low, double high) {
  const int holes = *rc::gen::inRange(0, 6);
  const double first = between(0, 2 * pi);
  std::vector<Vec2> centres;
  for (int i = 0; i < holes; ++i) {
    const double angle = first + 2 * pi * i / holes;
    centres.push_back(Vec2{std::cos(angle), std::sin(angle)} * between(low, high));
  }
  return centres;
}

PlanarRegion smooth_region() {
  PlanarRegion region;
  const Accuracy fine{true, radians(5), 0};
  // Radii between 41 and 79, and up to 8.
  LoopBuilder(region, fine).closed_curve(std::make_shared<WavyCircle>(Vec2{}, 60, 0.35)).close();
  for (const Vec2 centre : hole_centres(24, 30))
    LoopBuilder(region, fine).closed_curve(std::make_shared<WavyCircle>(centre, between(2, 6), 0.35)).close();
  return finished(std::move(region), fine);
}

std::vector<Vec2> star(Vec2 centre, double low, double high) {
  const int n = *rc::gen::inRange(3, 14);
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i)
    points.push_back(centre + Vec2{std::cos(2 * pi * i / n), std::sin(2 * pi * i / n)} * between(low, high));
  return points;
}

PlanarRegion polygonal_region() {
  std::vector<std::vector<Vec2>> loops;
  // So many points that no chord of the outer loop comes near the holes.
  const int n = *rc::gen::inRange(8, 40);
  for (auto& points : {&loops.emplace_back()})
    for (int i = 0; i < n; ++i)
      points->push_back(Vec2{std::cos(2 * pi * i / n), std::sin(2 * pi * i / n)} * between(52, 90));
  for (const Vec2 centre : hole_centres(28, 34)) loops.push_back(star(centre, 2, 9));
  return polygon(loops);
}

/// No circle is larger than its distance to the boundary; its feet are on the boundary and as far as it says.
/// Those of a vertex that stands for several near ones may lie outside of it, by as much as these were apart.
void expect_inscribed(const MedialObject& object, const PlanarRegion& region, double tolerance) {
  const Boundary boundary(region);
  RC_ASSERT(radius_error(object, boundary) <= tolerance);
  const auto touches = [&](const Foot& foot, Vec2 centre, double radius, double most) {
    return boundary.distance_to(foot.point) <= tolerance &&
           std::abs(distance(foot.point, centre) - radius) <= most;
  };
  const auto is_merged = [&](Index vertex) { return vertex != no_index && object.vertices[vertex].merged; };
  const auto most = [&](bool merged, double radius) {
    return merged ? 2 * MedialOptions{}.contraction * radius : tolerance;
  };
  // The outer two touching points of a smooth end are the ends of the stretch that nearly touches.
  const double end_of_contact = 1e-8 * object.size;
  const auto is_smooth_end = [&](Index vertex) {
    return vertex != no_index && object.vertices[vertex].type == MedialVertexType::S;
  };
  for (const MedialEdge& edge : object.edges)
    for (std::size_t i = 0; i < edge.points.size(); ++i) {
      const MedialPoint& point = edge.points[i];
      const bool merged =
          (i == 0 && is_merged(edge.start)) || (i + 1 == edge.points.size() && is_merged(edge.end));
      const bool end =
          (i == 0 && is_smooth_end(edge.start)) || (i + 1 == edge.points.size() && is_smooth_end(edge.end));
      for (const Foot& foot : point.feet)
        RC_ASSERT(
            touches(foot, point.point, point.radius, end ? end_of_contact : most(merged, point.radius)));
    }
  for (const MedialVertex& vertex : object.vertices) {
    if (vertex.type == MedialVertexType::J) RC_ASSERT(vertex.touching_points.size() >= 3u);
    if (vertex.type == MedialVertexType::C) RC_ASSERT(vertex.radius <= tolerance);
    const bool end = vertex.type == MedialVertexType::S;
    for (const Foot& foot : vertex.touching_points)
      RC_ASSERT(touches(foot, vertex.point, vertex.radius,
                        end ? end_of_contact : most(vertex.merged, vertex.radius)));
  }
}

/// The discs of the axis make up the region: every point of the boundary is on one of them, up to a
/// tolerance.
void expect_covered(const MedialObject& object, const PlanarRegion& region, double tolerance) {
  std::vector<std::array<MedialPoint, 2>> stretches;
  for (const MedialEdge& edge : object.edges) {
    const std::size_t n = edge.points.size();
    for (std::size_t i = 0; i + (edge.type == MedialEdgeType::N ? 0 : 1) < n; ++i)
      stretches.push_back({edge.points[i], edge.points[(i + 1) % n]});
  }
  const auto gap = [&](Vec2 p) {
    double best = std::numeric_limits<double>::infinity();
    for (const MedialVertex& vertex : object.vertices)
      best = std::min(best, distance(p, vertex.point) - vertex.radius);
    for (const auto& [a, b] : stretches) {
      if (distance(p, a.point) - distance(a.point, b.point) - std::max(a.radius, b.radius) >= best) continue;
      for (int k = 0; k <= 16; ++k)
        best = std::min(best, distance(p, lerp(a.point, b.point, k / 16.0)) -
                                  (a.radius + (b.radius - a.radius) * k / 16.0));
    }
    return best;
  };
  for (const Vec2 p : Boundary(region).points(3)) RC_ASSERT(gap(p) <= tolerance);
}

void expect_typed(const MedialObject& object, const PlanarRegion& region) {
  RC_ASSERT(cycles(object) == static_cast<Index>(region.loops.size()) - 1);
  for (const MedialVertex& vertex : object.vertices)
    RC_ASSERT(vertex.edges.size() != 2u &&
              (vertex.type == MedialVertexType::J) == (vertex.edges.size() >= 3));
  for (std::size_t e = 0; e < object.edges.size(); ++e) {
    const MedialEdge& edge = object.edges[e];
    RC_ASSERT((edge.start == no_index) == (edge.type == MedialEdgeType::N));
    for (const Index end : {edge.start, edge.end}) {
      if (end == no_index) continue;
      const auto& edges = object.vertices[end].edges;
      RC_ASSERT(std::count(edges.begin(), edges.end(), static_cast<Index>(e)) ==
                (edge.start == edge.end ? 2 : 1));
    }
  }
}

RC_GTEST_PROP(MedialProperties, polygons_with_holes, ()) {
  const PlanarRegion region = polygonal_region();
  const auto object = medial_object(region);
  RC_ASSERT(object.has_value());
  expect_typed(*object, region);
  expect_inscribed(*object, region, 1e-10 * object->size);
  expect_covered(*object, region, 2e-3 * object->size);
  // Every convex corner is the end of an edge, nothing else is.
  int corners = 0;
  for (const PlanarLoop& loop : region.loops)
    for (std::size_t i = 0, n = loop.points.size(); i < n; ++i)
      corners +=
          cross(loop.points[i] - loop.points[(i + n - 1) % n], loop.points[(i + 1) % n] - loop.points[i]) > 0;
  const MedialCounts counts = medial_counts(*object);
  RC_ASSERT((counts.count("C") ? counts.at("C") : 0) == corners);
  RC_ASSERT(counts.count("S") == 0u);
}

RC_GTEST_PROP(MedialProperties, smooth_regions_with_holes, ()) {
  const PlanarRegion region = smooth_region();
  MedialOptions options;
  options.chord = 1e-5 * diagonal(region);  // fewer points to be looked at by brute force
  const auto object = medial_object(region, options);
  RC_ASSERT(object.has_value());
  expect_typed(*object, region);
  expect_inscribed(*object, region, 1e-8 * object->size);
  expect_covered(*object, region, 2e-3 * object->size);
  RC_ASSERT(medial_counts(*object).count("C") == 0u);
}

}  // namespace
}  // namespace beadmesh
