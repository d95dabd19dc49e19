#include "beadmesh/medial/sample_refinement.h"

#include <algorithm>
#include <vector>

#include "beadmesh/medial/triangle_type.h"

namespace beadmesh {
namespace {

constexpr double longest_edge = 0.8;  ///< of the circumradius

double length_after(const BoundarySamples& samples, Index i) {
  return distance(samples.samples[i].point, samples.samples[next_sample(samples, i)].point);
}

bool is_convex_corner(const BoundarySamples& samples, Index i) {
  if (!samples.samples[i].corner) return false;
  const Vec2 at = samples.samples[i].point;
  return cross(at - samples.samples[previous_sample(samples, i)].point,
               samples.samples[next_sample(samples, i)].point - at) > 0;
}

/// Per sample the distances after it at which new samples are wanted.
std::vector<std::vector<double>> wanted_splits(const BoundarySamples& samples,
                                               const Triangulation& triangulation) {
  const std::size_t count = samples.samples.size();
  std::vector<std::vector<double>> wanted(count);
  std::vector<char> is_ear(count, 0);
  const std::vector<TriangleType> types = triangle_types(triangulation, samples);
  for (std::size_t t = 0; t < triangulation.triangles.size(); ++t) {
    const Triangle& corners = triangulation.triangles[t];
    if (types[t] == TriangleType::C) {
      is_ear[ear_tip(triangulation, static_cast<Index>(t))] = 1;
      continue;
    }
    const Circle circle = circumcircle(triangulation.points[corners[0]], triangulation.points[corners[1]],
                                       triangulation.points[corners[2]]);
    for (int k = 0; k < 3; ++k) {
      if (triangulation.neighbours[t][k] != no_index) continue;
      const Index from = corners[(k + 1) % 3];
      const double length = length_after(samples, from);
      if (length > longest_edge * circle.radius) wanted[from].push_back(length / 2);
    }
  }
  for (Index i = 0; i < static_cast<Index>(count); ++i) {
    if (is_ear[i] || !is_convex_corner(samples, i)) continue;
    const Index before = previous_sample(samples, i);
    const double length = length_after(samples, before), leg = std::min(length, length_after(samples, i)) / 2;
    wanted[i].push_back(leg);
    wanted[before].push_back(length - leg);
  }
  return wanted;
}

/// Adds samples at the distances wanted after each one; leaves out those too near to another.
std::optional<BoundarySamples> split(const BoundarySamples& samples, std::vector<std::vector<double>> wanted,
                                     const BoundaryCurve& curve) {
  BoundarySamples refined;
  refined.loop_length = samples.loop_length;
  const double least = 1e-7 * curve.size();
  for (std::size_t loop = 0; loop + 1 < samples.first.size(); ++loop) {
    refined.first.push_back(static_cast<Index>(refined.samples.size()));
    for (Index i = samples.first[loop]; i < samples.first[loop + 1]; ++i) {
      const BoundarySample& sample = samples.samples[i];
      refined.samples.push_back(sample);
      std::sort(wanted[i].begin(), wanted[i].end());
      const double length = length_after(samples, i);
      double last = 0;
      for (const double distance_after : wanted[i]) {
        const double gap = std::max(least, 0.05 * length);
        if (distance_after - last < gap || length - distance_after < gap) continue;
        BoundarySample added = sample;
        added.corner = false;
        added.position = sample.position + distance_after;
        added.point = curve.curve_point(sample.loop, added.position);
        refined.samples.push_back(added);
        last = distance_after;
      }
    }
  }
  refined.first.push_back(static_cast<Index>(refined.samples.size()));
  if (refined.samples.size() == samples.samples.size()) return std::nullopt;
  return refined;
}

}  // namespace

std::optional<BoundarySamples> refined_samples(const BoundarySamples& samples,
                                               const Triangulation& triangulation,
                                               const BoundaryCurve& curve) {
  return split(samples, wanted_splits(samples, triangulation), curve);
}

std::optional<BoundarySamples> with_contacts(const BoundarySamples& samples,
                                             const std::vector<Contact>& contacts,
                                             const BoundaryCurve& curve) {
  std::vector<std::vector<double>> wanted(samples.samples.size());
  for (const Contact& contact : contacts) {
    const auto begin = samples.samples.begin() + samples.first[contact.loop];
    const auto end = samples.samples.begin() + samples.first[contact.loop + 1];
    const double position = curve.position(contact.loop, contact.segment, contact.t);
    const auto after = std::upper_bound(
        begin, end, position, [](double s, const BoundarySample& sample) { return s < sample.position; });
    if (after == begin) continue;
    const auto i = static_cast<std::size_t>(after - 1 - samples.samples.begin());
    wanted[i].push_back(position - samples.samples[i].position);
  }
  return split(samples, std::move(wanted), curve);
}

}  // namespace beadmesh
