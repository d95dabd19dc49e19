#include "beadmesh/delaunay/boundary_sampling.h"

#include <algorithm>
#include <cmath>

#include "beadmesh/delaunay/loop_division.h"
#include "beadmesh/delaunay/triangulation.h"

namespace beadmesh {
namespace {

using delaunay::LoopDivision;

constexpr double radius_share = 0.5;  // wanted length of a segment / circumradius of its triangle
constexpr int most_rounds = 8;        // of triangulation and refinement
constexpr int most_grading_rounds = 20;
constexpr double least_length = 1e-5;   // of a segment that is made by division / diagonal
constexpr double least_digits = 1e-11;  // the same / greatest coordinate

double circumradius(Vec2 a, Vec2 b, Vec2 c) {
  const double twice_area = std::abs(cross(b - a, c - a));
  return distance(a, b) * distance(b, c) * distance(c, a) / (2 * twice_area);
}

class Sampler {
 public:
  Sampler(const PlanarRegion& region, const SamplingOptions& options) : options_(options) {
    double greatest = 0;
    for (const PlanarLoop& loop : region.loops)
      for (const Vec2 p : loop.points) greatest = std::max({greatest, std::abs(p.x), std::abs(p.y)});
    const double least = std::max(least_length * diagonal(region), least_digits * greatest);
    for (const PlanarLoop& loop : region.loops)
      loops_.emplace_back(loop, static_cast<Index>(loops_.size()), options, least);
  }

  BoundarySamples run() {
    divide();
    for (int round = 0; round < most_rounds; ++round) {
      make_graded();
      if (!measure() || !divide()) break;
    }
    make_graded();
    return collected();
  }

 private:
  struct Place {  // a sample
    Index loop;
    std::size_t i;
  };

  // False where nothing was divided, since nothing asked for it or there would be too many samples.
  bool divide();
  void make_graded();
  bool measure();
  bool face_over_corner(Place edge, Place apex) const;
  BoundarySamples collected() const;

  SamplingOptions options_;
  std::vector<LoopDivision> loops_;
};

bool Sampler::divide() {
  double count = 0;
  for (LoopDivision& loop : loops_) count += loop.prepare();
  if (!(count <= options_.max_samples)) return false;
  bool grew = false;
  for (LoopDivision& loop : loops_) grew |= loop.divide();
  return grew;
}

void Sampler::make_graded() {
  for (int round = 0; round < most_grading_rounds; ++round) {
    bool any = false;
    for (LoopDivision& loop : loops_) any |= loop.limit_by_neighbours();
    if (!any || !divide()) return;
  }
}

// Two pieces that meet at a corner come as near to each other as one likes; that is no thickness.
bool Sampler::face_over_corner(Place edge, Place apex) const {
  const LoopDivision& loop = loops_[edge.loop];
  if (edge.loop != apex.loop || loop.pieces() < 2) return false;
  const Index n = loop.pieces(), piece = loop.piece(edge.i);
  const Index in = loop.piece(apex.i > 0 ? apex.i - 1 : loop.size() - 1), out = loop.piece(apex.i);
  if (in == piece || out == piece) return false;
  const auto beside = [&](Index other) { return (piece + 1) % n == other || (other + 1) % n == piece; };
  return beside(in) || beside(out);
}

// Limits each segment by its triangle. False where the samples cannot be triangulated.
bool Sampler::measure() {
  std::vector<Vec2> points;
  std::vector<Place> places;
  std::vector<std::vector<Index>> indices;
  for (std::size_t l = 0; l < loops_.size(); ++l) {
    auto& loop = indices.emplace_back();
    for (std::size_t i = 0; i < loops_[l].size(); ++i) {
      loop.push_back(static_cast<Index>(points.size()));
      points.push_back(loops_[l].samples()[i].point);
      places.push_back({static_cast<Index>(l), i});
    }
  }
  const auto triangulation = triangulate(points, indices);
  if (!triangulation) return false;
  for (std::size_t t = 0; t < triangulation->triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      if (triangulation->neighbours[t][k] != no_index) continue;
      const Triangle& corners = triangulation->triangles[t];
      const Index a = corners[(k + 1) % 3], b = corners[(k + 2) % 3], apex = corners[k];
      const Place edge = places[a];
      LoopDivision& loop = loops_[edge.loop];
      const bool encroached = dot(points[a] - points[apex], points[b] - points[apex]) < 0;
      if (encroached) loop.limit(edge.i, loop.segment_length(edge.i) / 2);
      if (options_.spacing <= 0 && !face_over_corner(edge, places[apex]))
        loop.limit(edge.i, radius_share * circumradius(points[a], points[b], points[apex]));
    }
  return true;
}

BoundarySamples Sampler::collected() const {
  BoundarySamples result;
  for (const LoopDivision& loop : loops_) {
    result.first.push_back(static_cast<Index>(result.samples.size()));
    result.samples.insert(result.samples.end(), loop.samples().begin(), loop.samples().end());
    result.loop_length.push_back(loop.length());
  }
  result.first.push_back(static_cast<Index>(result.samples.size()));
  return result;
}

}  // namespace

BoundarySamples sample_boundary(const PlanarRegion& region, const SamplingOptions& options) {
  return Sampler(region, options).run();
}

Index next_sample(const BoundarySamples& samples, Index i) {
  const Index loop = samples.samples[i].loop;
  return i + 1 < samples.first[loop + 1] ? i + 1 : samples.first[loop];
}

Index previous_sample(const BoundarySamples& samples, Index i) {
  const Index loop = samples.samples[i].loop;
  return i > samples.first[loop] ? i - 1 : samples.first[loop + 1] - 1;
}

}  // namespace beadmesh
