#include "beadmesh/read/outline_straightening.h"

#include <algorithm>
#include <map>
#include <utility>

namespace beadmesh {
namespace {

constexpr int fairing_rounds = 40;

/// Facets of uncertain side.
class ToothRemover {
 public:
  ToothRemover(const FacetMesh& mesh, FacetGroups& groups, const OutlineOptions& options)
      : mesh_(mesh), groups_(groups), options_(options), normals_(mesh.points.size()) {
    for (Index t = 0; t < mesh.triangle_count(); ++t)
      if (!is_feature(t))
        for (const Index v : mesh.triangles[t]) normals_[v] += mesh.area_vectors[t];
    for (Vec3& n : normals_) n = normalized(n);
  }

  void run() {
    std::vector<Index> waiting;
    for (Index t = 0; t < mesh_.triangle_count(); ++t) waiting.push_back(t);
    for (int pass = 0; pass < 20 && !waiting.empty(); ++pass) {
      std::vector<Index> next;
      for (const Index t : waiting)
        if (turn_over(t))
          for (Index h = 3 * t; h < 3 * t + 3; ++h)
            if (mesh_.beyond(h) != no_index) next.push_back(mesh_.beyond(h));
      std::sort(next.begin(), next.end());
      next.erase(std::unique(next.begin(), next.end()), next.end());
      waiting = std::move(next);
    }
  }

 private:
  bool is_feature(Index t) const { return groups_.is_feature[groups_.face[t]]; }

  bool turn_over(Index t) {
    std::map<Index, double> length;  // per face beyond the sides
    double inner = 0;
    for (Index h = 3 * t; h < 3 * t + 3; ++h) {
      const Index other = mesh_.beyond(h);
      if (other == no_index) return false;
      if (groups_.face[other] == groups_.face[t])
        inner += mesh_.length(h);
      else if (is_feature(other) != is_feature(t))
        length[groups_.face[other]] += mesh_.length(h);
    }
    for (const auto& [face, outer] : length)
      if (outer > options_.tooth * inner && may_turn(t)) {
        groups_.face[t] = face;
        return true;
      }
    return false;
  }

  bool may_turn(Index t) const {
    double highest = 0, longest = 0;
    for (const Index v : mesh_.triangles[t])
      for (const Index w : mesh_.triangles[t]) {
        const Vec3 way = mesh_.points[w] - mesh_.points[v];
        highest = std::max(highest, std::abs(dot(way, normals_[v])));
        longest = std::max(longest, norm(way));
      }
    if (is_feature(t)) return highest < options_.flat;
    return 2 * mesh_.area(t) < options_.sliver * longest * longest;
  }

  const FacetMesh& mesh_;
  FacetGroups& groups_;
  const OutlineOptions& options_;
  std::vector<Vec3> normals_;  ///< per point: of the sheet alone; zero inside features
};

/// Points of outlines that zigzag.
class OutlineFairer {
 public:
  OutlineFairer(FacetMesh& mesh, const FacetGroups& groups, const OutlineOptions& options)
      : mesh_(mesh), groups_(groups), options_(options) {}

  void run() {
    find_outlines();
    find_fans();
    for (const std::vector<Index>& line : outlines_)
      if (zigzags(line)) fair(line);
  }

 private:
  /// Closed lines between a feature and what lies around it; where two lines meet is none.
  void find_outlines() {
    std::map<Index, Index> next;
    std::map<Index, int> uses;
    for (Index h = 0; h < Index(mesh_.partner.size()); ++h) {
      const Index other = mesh_.beyond(h);
      const bool differs = other == no_index || groups_.face[other] != groups_.face[h / 3];
      if (!differs) continue;
      const bool outline = other != no_index && groups_.is_feature[groups_.face[h / 3]] &&
                           !groups_.is_feature[groups_.face[other]];
      uses[mesh_.tail(h)] += outline ? 1 : other == no_index ? 4 : 0;
      if (outline) next[mesh_.tail(h)] = mesh_.head(h);
    }
    std::map<Index, bool> done;
    for (const auto& [first, second] : next) {
      std::vector<Index> line;
      Index at = first;
      while (!done[at] && next.contains(at) && uses[at] == 1) {
        done[at] = true;
        line.push_back(at);
        at = next[at];
      }
      if (at == first && line.size() > 5) outlines_.push_back(std::move(line));
    }
  }

  void find_fans() {
    std::map<Index, bool> on_line;
    for (const auto& line : outlines_)
      for (const Index v : line) on_line[v] = true;
    for (Index t = 0; t < mesh_.triangle_count(); ++t)
      for (const Index v : mesh_.triangles[t])
        if (on_line.contains(v)) fans_[v].push_back(t);
  }

  Vec3 at(const std::vector<Index>& line, std::size_t i) const { return mesh_.points[line[i % line.size()]]; }

  /// Does it turn to and fro? A smooth line turns by as much in all as from one end to the other.
  bool zigzags(const std::vector<Index>& line) const {
    const std::size_t n = line.size();
    int kinks = 0;
    Vec3 last;
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3 in = at(line, i + n - 1), here = at(line, i), out = at(line, i + 1);
      const Vec3 turn = cross(normalized(here - in), normalized(out - here));
      const bool sharp = angle_between(here - in, out - here) > options_.most_turn;
      if (sharp && dot(turn, last) < 0) ++kinks;
      if (sharp) last = turn;
    }
    return kinks * 12 > int(n) || kinks > 8;
  }

  /// Two steps, one that smooths and one that swells again.
  void fair(const std::vector<Index>& line) {
    for (int round = 0; round < fairing_rounds; ++round)
      for (const double step : {0.5, -0.526}) {
        std::vector<Vec3> to;
        const std::size_t n = line.size();
        for (std::size_t i = 0; i < n; ++i)
          to.push_back(at(line, i) + ((at(line, i + n - 1) + at(line, i + 1)) / 2 - at(line, i)) * step);
        for (std::size_t i = 0; i < n; ++i) move(line[i], to[i]);
      }
  }

  /// Along the sheet, unless a facet would turn over or lose most of its area.
  void move(Index v, Vec3 to) {
    Vec3 normal;
    for (const Index t : fans_[v])
      if (!groups_.is_feature[groups_.face[t]]) normal += mesh_.area_vectors[t];
    normal = normalized(normal);
    const Vec3 from = mesh_.points[v];
    to = to - normal * dot(to - from, normal);
    for (const double part : {1.0, 0.5, 0.25}) {
      mesh_.points[v] = lerp(from, to, part);
      if (fan_is_sound(v)) return;
    }
    mesh_.points[v] = from;
  }

  bool fan_is_sound(Index v) const {
    const std::vector<Index>& fan = fans_.at(v);
    return std::all_of(fan.begin(), fan.end(), [&](Index t) {
      return dot(area_vector(t), mesh_.area_vectors[t]) >= 0.05 * squared_norm(mesh_.area_vectors[t]);
    });
  }

  Vec3 area_vector(Index t) const {
    const Triangle& v = mesh_.triangles[t];
    const Vec3 a = mesh_.points[v[0]];
    return cross(mesh_.points[v[1]] - a, mesh_.points[v[2]] - a) / 2;
  }

  FacetMesh& mesh_;
  const FacetGroups& groups_;
  const OutlineOptions& options_;
  std::vector<std::vector<Index>> outlines_;  ///< points, not repeated at the end
  std::map<Index, std::vector<Index>> fans_;  ///< triangles around the points of the outlines
};

/// Some faces were nothing but teeth.
void drop_empty(FacetGroups& groups) {
  FacetGroups kept;
  std::map<Index, Index> number;
  for (Index& f : groups.face) {
    const auto [found, is_new] = number.try_emplace(f, Index(number.size()));
    if (is_new) kept.is_feature.push_back(groups.is_feature[f]);
    kept.face.push_back(found->second);
  }
  groups = std::move(kept);
}

}  // namespace

void straighten_outlines(FacetMesh& mesh, FacetGroups& groups, const OutlineOptions& options) {
  ToothRemover(mesh, groups, options).run();
  drop_empty(groups);
  OutlineFairer(mesh, groups, options).run();
}

}  // namespace beadmesh
