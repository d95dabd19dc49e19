#include "beadmesh/read/outline_lines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "beadmesh/geometry/line_smoothing.h"

namespace beadmesh {
namespace {

constexpr double spike = radians(100);  // turn of what leads nowhere
constexpr double corner = radians(65);
constexpr double sharp_turn = radians(40);  // more than a facet turns along a round end
constexpr double corner_reach = 3;          // mm
constexpr double facets_per_wave = 6;       // a smooth line bends within so many facets
constexpr double even_facets_per_wave = 16;
constexpr double shortest_wave = 3;                 // mm
constexpr double worth = 1.02, slack = radians(4);  // turning that a longer wave has to save
constexpr double least_noise = 0.03;                // mm
constexpr double samples_per_wave = 10;
constexpr double samples_per_facet = 3;  // fewer would beat with the teeth
constexpr double most_samples = 20000;

double middle(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

/// Points of a line with the normals of the sheet there.
struct PointsAndNormals {
  std::vector<Vec3> points, normals;
  std::size_t size() const { return points.size(); }
};

class LineFairer {
 public:
  LineFairer(const FacetMesh& mesh, const FacetGroups& groups, const OutlineLine& line, bool even)
      : mesh_(mesh), groups_(groups), line_(line), even_(even) {}

  /// Of ever longer waves the first that the next cannot calm any further. Among facets of one size a line
  /// with more than a few spikes follows facets that do not know the outline: there the next wave gives it
  /// the better curvature.
  std::optional<FairedOutline> run() {
    read();
    double calm = turning(raw_.points);
    const bool ragged = even_ && sharpest_turn() > sharp_turn;
    drop_spikes();
    if (raw_.size() < 5) return std::nullopt;
    length_ = 0;
    for (std::size_t i = 0; i < raw_.size(); ++i)
      length_ += distance(raw_.points[i], raw_.points[(i + 1) % raw_.size()]);
    const double longest = std::min(
        std::max(shortest_wave, (even_ ? even_facets_per_wave : facets_per_wave) * facet_), length_ / 8);
    double wave = 0;
    std::optional<PointsAndNormals> best;
    for (double next = shortest_wave; next / 2 < longest; next *= 2) {
      auto line = smooth_line(std::min(next, longest));
      if (!line) break;
      const double turned = turning(line->points);
      const bool worse = calm < worth * turned + slack;
      if (worse && (best || !ragged)) break;
      if (ragged && next < 4 * facet_) continue;
      calm = turned;
      wave = next;
      best = std::move(line);
    }
    if (!best) return std::nullopt;
    if (even_ && wave > shortest_wave)
      if (auto longer = smooth_line(std::min(2 * wave, longest))) best = std::move(longer);
    return FairedOutline{{std::move(best->points), std::move(best->normals)}, facet_};
  }

 private:
  /// Normals are those of the sheet; of both sides between two features.
  void read() {
    std::vector<double> across;
    const bool both = groups_.is_feature[line_.outside];
    for (const Index h : line_.half_edges) {
      const Index inner = h / 3, outer = mesh_.beyond(h);
      across.push_back(mesh_.lowest_height(inner));
      Vec3 normal = normalized(mesh_.area_vectors[outer]);
      if (both) normal += normalized(mesh_.area_vectors[inner]);
      raw_.points.push_back(mesh_.points[mesh_.tail(h)]);
      raw_.normals.push_back(normalized(normal));
    }
    facet_ = middle(across);
  }

  /// Nothing where that leaves the facets of the line.
  std::optional<PointsAndNormals> smooth_line(double wave) const {
    double wanted = wave / samples_per_wave;
    if (even_) wanted = std::min(wanted, facet_ / samples_per_facet);
    const std::size_t count = std::size_t(std::min(length_ / wanted, most_samples));
    if (count < 20) return std::nullopt;
    const double step = length_ / double(count);
    PointsAndNormals samples = sampled(step, count);
    LineSmoothingOptions options;
    options.wavelength = wave;
    options.least_noise = std::max(least_noise, 0.1 * facet_);
    std::vector<Vec3> line = smoothed_line(samples.points, step, corners(samples, step), options);
    if (even_ && leaves(samples.points, line)) return std::nullopt;
    samples.points = std::move(line);
    return samples;
  }

  /// Less than a corner.
  double sharpest_turn() const {
    double most = 0;
    const std::size_t n = raw_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 here = raw_.points[i];
      const double turn = angle_between(here - raw_.points[(i + n - 1) % n], raw_.points[(i + 1) % n] - here);
      if (turn < corner) most = std::max(most, turn);
    }
    return most;
  }

  /// Does it leave the facets on which the line lies, for more than a tooth here and there?
  bool leaves(const std::vector<Vec3>& points, const std::vector<Vec3>& line) const {
    std::size_t far = 0;
    for (std::size_t i = 0; i < points.size(); ++i) far += distance(points[i], line[i]) > facet_;
    return far * 10 > points.size();
  }

  /// To either side, in all: 360 degrees and more.
  static double turning(const std::vector<Vec3>& points) {
    double sum = 0;
    const std::size_t n = points.size();
    for (std::size_t i = 0; i < n; ++i)
      sum += angle_between(points[i] - points[(i + n - 1) % n], points[(i + 1) % n] - points[i]);
    return sum;
  }

  /// Points where the line turns back on itself, until there are none.
  void drop_spikes() {
    bool found = true;
    for (int round = 0; found && round < 50; ++round) {
      found = false;
      PointsAndNormals kept;
      const std::size_t n = raw_.size();
      bool last_dropped = false;
      for (std::size_t i = 0; i < n; ++i) {
        const Vec3 here = raw_.points[i];
        const Vec3 in = here - raw_.points[(i + n - 1) % n], out = raw_.points[(i + 1) % n] - here;
        const bool drop = !last_dropped && angle_between(in, out) > spike;
        last_dropped = drop;
        if (drop) {
          found = true;
          continue;
        }
        kept.points.push_back(here);
        kept.normals.push_back(raw_.normals[i]);
      }
      raw_ = std::move(kept);
      if (raw_.size() < 5) return;
    }
  }

  PointsAndNormals sampled(double step, std::size_t count) const {
    PointsAndNormals samples;
    double left = 0;  // of the segment before
    const std::size_t n = raw_.size();
    for (std::size_t i = 0; i < n && samples.size() < count; ++i) {
      const std::size_t j = (i + 1) % n;
      const double length = distance(raw_.points[i], raw_.points[j]);
      double at = left;
      for (; at < length && samples.size() < count; at += step) {
        samples.points.push_back(lerp(raw_.points[i], raw_.points[j], at / length));
        samples.normals.push_back(lerp(raw_.normals[i], raw_.normals[j], at / length));
      }
      left = at - length;
    }
    return samples;
  }

  /// Where the line turns sharply within its reach, at the sharpest sample of each.
  std::vector<bool> corners(const PointsAndNormals& samples, double step) const {
    const std::size_t n = samples.size();
    const std::size_t reach = std::clamp<std::size_t>(
        std::size_t(std::max(corner_reach, even_ ? 3 * facet_ : facet_) / step), 1, n / 4);
    std::vector<double> turns;
    for (std::size_t i = 0; i < n; ++i)
      turns.push_back(angle_between(samples.points[i] - samples.points[(i + n - reach) % n],
                                    samples.points[(i + reach) % n] - samples.points[i]));
    std::vector<bool> result(n, false);
    for (std::size_t i = 0; i < n; ++i) {
      if (turns[i] < corner) continue;
      bool sharpest = true;
      for (std::size_t k = 1; k <= reach; ++k)
        sharpest = sharpest && turns[i] > turns[(i + k) % n] && turns[i] >= turns[(i + n - k) % n];
      result[i] = sharpest;
    }
    return result;
  }

  const FacetMesh& mesh_;
  const FacetGroups& groups_;
  const OutlineLine& line_;
  const bool even_;
  PointsAndNormals raw_;
  double facet_ = 0, length_ = 0;
};

/// Half-edges between two faces, the feature (or the feature of lower number) on their left.
bool is_outline(const FacetMesh& mesh, const FacetGroups& groups, Index h) {
  const Index other = mesh.beyond(h);
  if (other == no_index) return false;
  const Index a = groups.face[h / 3], b = groups.face[other];
  if (a == b || !groups.is_feature[a]) return false;
  return !groups.is_feature[b] || a < b;
}

}  // namespace

std::vector<OutlineLine> outline_lines(const FacetMesh& mesh, const FacetGroups& groups) {
  std::map<Index, Index> next;  // per point the half-edge that leaves it
  std::map<Index, int> uses;    // more than 1: another line meets there
  for (Index h = 0; h < 3 * mesh.triangle_count(); ++h) {
    const Index other = mesh.beyond(h);
    const bool is_line = other == no_index || groups.face[other] != groups.face[h / 3];
    if (!is_line) continue;
    if (is_outline(mesh, groups, h))
      ++uses[mesh.tail(h)], next[mesh.tail(h)] = h;
    else if (other == no_index || !is_outline(mesh, groups, mesh.partner[h]))
      uses[mesh.tail(h)] += 2, uses[mesh.head(h)] += 2;
  }
  std::vector<OutlineLine> lines;
  std::map<Index, bool> done;
  for (const auto& [first, half_edge] : next) {
    OutlineLine line;
    line.inside = groups.face[half_edge / 3];
    line.outside = groups.face[mesh.beyond(half_edge)];
    Index at = first;
    while (!done[at] && next.contains(at) && uses[at] == 1) {
      done[at] = true;
      line.half_edges.push_back(next[at]);
      at = mesh.head(next[at]);
    }
    if (at == first && line.half_edges.size() > 5) lines.push_back(std::move(line));
  }
  return lines;
}

std::optional<FairedOutline> faired_outline(const FacetMesh& mesh, const FacetGroups& groups,
                                            const OutlineLine& line, bool even) {
  return LineFairer(mesh, groups, line, even).run();
}

}  // namespace beadmesh
