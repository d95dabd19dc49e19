#include "beadmesh/mesh/bead_section.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

constexpr double across_angle = radians(172);  ///< touching lines below it run askew
constexpr int samples = 24;                    ///< of half a section
constexpr int most_sections = 40;

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 u = b - a;
  const double uu = squared_norm(u);
  const double t = uu > 0 ? std::clamp(dot(p - a, u) / uu, 0.0, 1.0) : 0;
  return distance(p, a + u * t);
}

/// Largest distance of half a section from its polygon of equal parts.
double half_deviation(Vec2 foot, Vec2 crest, const SurfaceMap& map, int parts) {
  std::vector<Vec3> points;
  std::vector<double> arcs;
  FacetPoint at;
  for (int i = 0; i <= samples; ++i) {
    at = map.locate(lerp(foot, crest, double(i) / samples), at.triangle);
    points.push_back(map.surface_point(at));
    arcs.push_back(i ? arcs.back() + distance(points[i - 1], points[i]) : 0);
  }
  const auto point_at = [&](double arc) {
    const size_t next = std::upper_bound(arcs.begin(), arcs.end(), arc) - arcs.begin();
    const size_t i = std::clamp<size_t>(next, 1, samples);
    const double step = arcs[i] - arcs[i - 1];
    return lerp(points[i - 1], points[i], step > 0 ? std::clamp((arc - arcs[i - 1]) / step, 0.0, 1.0) : 0);
  };
  double worst = 0;
  for (int k = 0; k < parts; ++k) {
    const double low = arcs.back() * k / parts, high = arcs.back() * (k + 1) / parts;
    const Vec3 a = point_at(low), b = point_at(high);
    for (int i = 0; i <= samples; ++i)
      if (arcs[i] > low && arcs[i] < high) worst = std::max(worst, distance_to_segment(points[i], a, b));
  }
  return worst;
}

}  // namespace

double section_deviation(const Skeleton& crest, const SurfaceMap& map, int elements_across) {
  std::vector<const MedialPoint*> sections;
  for (const SkeletonArm& arm : crest.arms)
    for (const MedialPoint& p : arm.points)
      if (p.subtended_angle >= across_angle) sections.push_back(&p);
  if (sections.empty()) return 0;
  std::vector<double> deviations;
  const size_t step = (sections.size() + most_sections - 1) / most_sections;
  for (size_t i = 0; i < sections.size(); i += step)
    for (const Foot& foot : sections[i]->feet)
      deviations.push_back(half_deviation(foot.point, sections[i]->point, map, elements_across / 2));
  const auto typical = deviations.begin() + std::ptrdiff_t(deviations.size() * 3 / 4);
  std::nth_element(deviations.begin(), typical, deviations.end());
  return *typical;
}

}  // namespace beadmesh
