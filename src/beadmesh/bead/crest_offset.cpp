#include "beadmesh/bead/crest_offset.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace beadmesh {
namespace {

/// Shares of the height between which the middle of the two walls is followed upwards.
constexpr double low_level = 0.45, high_level = 0.72;
constexpr int samples = 48;

/// The surface over a touching line: distance along the chord of its feet and height over it.
struct Section {
  std::vector<double> along, height;
  double top = 0;
};

Section section_over(const MedialPoint& medial, const SurfaceMap& map) {
  const Vec2 left = medial.feet[0].point, right = medial.feet[1].point;
  FacetPoint at = map.locate(left);
  const Vec3 a = map.surface_point(at), b = map.surface_point(map.locate(right));
  const Vec3 chord = normalized(b - a);
  Section out;
  for (int i = 0; i <= samples; ++i) {
    at = map.locate(lerp(left, right, double(i) / samples), at.triangle);
    const Vec3 p = map.surface_point(at) - a;
    out.along.push_back(dot(p, chord));
    out.height.push_back(norm(p - chord * out.along.back()));
  }
  out.top = *std::max_element(out.height.begin(), out.height.end());
  return out;
}

/// What of a section lies above a level: the samples, and the middle between the walls there.
struct Above {
  int first = 0, last = 0;
  double middle = 0;
};

std::optional<Above> above(const Section& section, double level) {
  const auto& h = section.height;
  Above out{0, samples, 0};
  while (h[out.first] < level) ++out.first;
  while (h[out.last] < level) --out.last;
  if (out.first == 0 || out.last == samples) return std::nullopt;
  const auto along_at = [&](int inner, int outer) {
    const double t = (h[inner] - level) / (h[inner] - h[outer]);
    return section.along[inner] + t * (section.along[outer] - section.along[inner]);
  };
  out.middle = (along_at(out.first, out.first - 1) + along_at(out.last, out.last + 1)) / 2;
  return out;
}

/// Flat offset of the crest from the medial point, to the left of the arm's direction; none where the
/// touching line says nothing: oblique, or the crest would be far off. The line of the walls' middles,
/// carried on to the top, runs along the direction of drawing, whether tops are round or flat.
std::optional<double> offset_at(const MedialPoint& medial, const SurfaceMap& map) {
  if (medial.radius <= 0 || medial.subtended_angle < radians(173)) return std::nullopt;
  const Section section = section_over(medial, map);
  if (section.top < 0.02 * medial.radius) return std::nullopt;
  const double low = low_level * section.top, high = high_level * section.top;
  const auto lower = above(section, low), upper = above(section, high);
  if (!lower || !upper) return std::nullopt;
  const double lean = (upper->middle - lower->middle) / (high - low);
  const auto beside = [&](int i) {
    return section.along[i] - upper->middle - lean * (section.height[i] - high);
  };
  int i = upper->first;
  while (i < upper->last && beside(i + 1) <= 0) ++i;
  if (beside(i) > 0 || i == upper->last) return std::nullopt;
  const double share = (i + beside(i) / (beside(i) - beside(i + 1))) / samples;
  const Vec2 left = medial.feet[0].point, right = medial.feet[1].point;
  const double offset = dot(lerp(left, right, share) - medial.point, normalized(left - right));
  if (std::abs(offset) > 0.4 * medial.radius) return std::nullopt;
  return offset;
}

/// Gaps are bridged linearly, the ends carried on.
std::vector<double> filled(const std::vector<std::optional<double>>& given) {
  const int n = int(given.size());
  std::vector<double> out(n, 0);
  int before = -1;
  for (int i = 0; i < n; ++i) {
    if (!given[i]) continue;
    out[i] = *given[i];
    for (int k = before + 1; k < i; ++k)
      out[k] = before < 0 ? *given[i]
                          : *given[before] + (*given[i] - *given[before]) * (k - before) / (i - before);
    before = i;
  }
  for (int k = before + 1; before >= 0 && k < n; ++k) out[k] = *given[before];
  return out;
}

/// Median of five, then mean of five: single facets must not kink the crest.
std::vector<double> calmed(const std::vector<double>& values, bool closed) {
  const int n = int(values.size());
  const auto index = [&](int i) { return closed ? (i % n + n) % n : std::clamp(i, 0, n - 1); };
  std::vector<double> median(n), mean(n);
  for (int i = 0; i < n; ++i) {
    double window[5];
    for (int k = -2; k <= 2; ++k) window[k + 2] = values[index(i + k)];
    std::nth_element(window, window + 2, window + 5);
    median[i] = window[2];
  }
  for (int i = 0; i < n; ++i)
    for (int k = -2; k <= 2; ++k) mean[i] += median[index(i + k)] / 5;
  return mean;
}

Vec2 left_of(const SkeletonArm& arm, int i) {
  const int n = int(arm.points.size());
  const bool closed = arm.start == no_index;
  const int before = closed ? (i + n - 1) % n : std::max(i - 1, 0),
            after = closed ? (i + 1) % n : std::min(i + 1, n - 1);
  return left_normal(normalized(arm.points[after].point - arm.points[before].point));
}

std::vector<double> offsets_of(const SkeletonArm& arm, const SurfaceMap& map) {
  std::vector<std::optional<double>> given;
  for (const MedialPoint& p : arm.points) given.push_back(offset_at(p, map));
  return calmed(filled(given), arm.start == no_index);
}

/// The shift of a node that suits the offsets of all its arms best (least squares).
Vec2 node_shift(const std::vector<std::pair<Vec2, double>>& demands) {
  double xx = 0, xy = 0, yy = 0, bx = 0, by = 0;
  for (const auto& [n, offset] : demands) {
    xx += n.x * n.x;
    xy += n.x * n.y;
    yy += n.y * n.y;
    bx += n.x * offset;
    by += n.y * offset;
  }
  const double det = xx * yy - xy * xy;
  if (det > 1e-3) return {(bx * yy - by * xy) / det, (by * xx - bx * xy) / det};
  return xx + yy > 0 ? Vec2{bx, by} / (xx + yy) : Vec2{0, 0};
}

}  // namespace

Skeleton moved_to_crest(const Skeleton& skeleton, const SurfaceMap& map) {
  Skeleton out = skeleton;
  std::vector<std::vector<std::pair<Vec2, double>>> demands(skeleton.nodes.size());
  for (SkeletonArm& arm : out.arms) {
    const int n = int(arm.points.size());
    if (n < 3) continue;
    const std::vector<double> offsets = offsets_of(arm, map);
    std::vector<Vec2> normals;
    for (int i = 0; i < n; ++i) normals.push_back(left_of(arm, i));
    for (int i = 0; i < n; ++i) arm.points[i].point += normals[i] * offsets[i];
    if (arm.start == no_index) continue;
    demands[arm.start].emplace_back(normals.front(), offsets.front());
    demands[arm.end].emplace_back(normals.back(), offsets.back());
  }
  for (size_t k = 0; k < out.nodes.size(); ++k) out.nodes[k].point += node_shift(demands[k]);
  for (SkeletonArm& arm : out.arms) {
    if (arm.start == no_index) continue;
    arm.points.front().point = out.nodes[arm.start].point;
    arm.points.back().point = out.nodes[arm.end].point;
  }
  return out;
}

}  // namespace beadmesh
