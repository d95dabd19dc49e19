#include "same_accuracy.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "beadmesh/medial/medial_object.h"
#include "candidates.h"
#include "domains.h"
#include "measurement.h"

namespace beadmesh::bench {
namespace {

constexpr double angle = 0.3;
constexpr std::size_t most_checked = 20'000;

double best_time(const Run& run, double seconds) {
  double best = std::numeric_limits<double>::infinity(), spent = 0;
  for (int runs = 0; runs < 200 && (runs < 2 || spent < seconds); ++runs) {
    const double start = thread_seconds();
    run();
    const double taken = thread_seconds() - start;
    best = std::min(best, taken);
    spent += taken;
  }
  return best;
}

/// Discs that are next to nothing are the ends in corners, where any diagram is exact.
double worst_error(const Domain& domain, const std::vector<Disc>& discs, double size) {
  const PlanarRegion polygon = cut(domain, 2'000, angle);
  const std::size_t step = discs.size() / most_checked + 1;
  double worst = 0;
  for (std::size_t i = 0; i < discs.size(); i += step) {
    const Disc& disc = discs[i];
    if (disc.radius < 1e-3 * size || !contains(polygon, disc.centre)) continue;
    worst = std::max(worst, std::abs(disc.radius - distance_to_outline(domain, angle, disc.centre)));
  }
  return worst / size;
}

std::vector<Disc> discs_of(const MedialObject& object) {
  std::vector<Disc> discs;
  for (const MedialEdge& edge : object.edges)
    for (const MedialPoint& point : edge.points) discs.push_back({point.point, point.radius});
  return discs;
}

void write(const Domain& domain, const std::string& candidate, std::size_t count, double seconds,
           double error) {
  std::printf(
      "{\"accuracy\": \"%s\", \"candidate\": \"%s\", \"count\": %zu, \"seconds\": %.9g, \"error\": %.3g}\n",
      domain.name.c_str(), candidate.c_str(), count, seconds, error);
  std::fflush(stdout);
}

std::size_t points_of(const PlanarRegion& region) {
  std::size_t count = 0;
  for (const PlanarLoop& loop : region.loops) count += loop.points.size();
  return count;
}

/// `coarse`: points of the axis where the samples are, none between them that only serve straight lines.
void measure_ours(const Domain& domain, const PlanarRegion& drawn, const std::string& name, bool coarse,
                  double seconds) {
  const auto region = checked_region(drawn);
  if (!region) throw std::runtime_error(to_line(region.error()));
  const double size = diagonal(*region);
  MedialOptions options;
  if (coarse) options.chord = size;
  const auto object = medial_object(*region, options);
  if (!object) throw std::runtime_error(to_line(object.error()));
  const Run run = [&] {
    const auto again = medial_object(*region, options);
    return std::to_string(again ? again->edges.size() : 0);
  };
  const double time = best_time(run, seconds);
  write(domain, name, points_of(*region), time, worst_error(domain, discs_of(*object), size));
}

void measure_boost(const Domain& domain, const PlanarRegion& region, double seconds) {
  const double time = best_time(boost_candidates()[0].prepare(region), seconds);
  write(domain, "Boost Voronoi", points_of(region), time,
        worst_error(domain, boost_discs(region), diagonal(region)));
}

}  // namespace

void compare_accuracy(double seconds) {
  for (const Domain& domain : {i_bead(), gasket(), comb()}) {
    const PlanarRegion outline = exact(domain, angle);
    measure_ours(domain, outline, "medial object", false, seconds);
    measure_ours(domain, outline, "medial object, no points for chords", true, seconds);
    if (domain.name == "comb") measure_boost(domain, outline, seconds);
    for (const int segments : {1'000, 10'000, 100'000, 1'000'000})
      if (domain.name != "comb") measure_boost(domain, cut(domain, segments, angle), seconds);
  }
  measure_ours(i_bead(), cut(i_bead(), 300, angle), "medial object of a bead, 300 segments", false, seconds);
}

}  // namespace beadmesh::bench
