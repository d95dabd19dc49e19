#include "beadmesh/read/sheet_growth.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace beadmesh {
namespace {

class SheetGrower {
 public:
  SheetGrower(const FacetMesh& mesh, const SheetGrowthOptions& options)
      : mesh_(mesh),
        options_(options),
        patch_(mesh.triangles.size(), no_index),
        direction_(mesh.triangles.size()) {}

  std::vector<Index> run() {
    for (const Index seed : seeds())
      if (patch_[seed] == no_index) grow(seed, count_++);
    trim();
    number_anew();
    drop_narrow();
    return std::move(patch_);
  }

 private:
  struct Step {
    double turn;
    Index triangle, from;
    bool operator<(const Step& other) const {  // the queue takes the largest first
      return turn != other.turn ? turn > other.turn : triangle > other.triangle;
    }
  };

  bool is_joined(Index h) const { return mesh_.partner[h] != no_index; }

  /// Triangles, those first whose neighbourhood is the flattest; of equally flat ones the largest.
  std::vector<Index> seeds() const {
    std::vector<double> unrest(mesh_.triangles.size());
    for (Index t = 0; t < mesh_.triangle_count(); ++t) unrest[t] = unrest_at(t);
    constexpr double bin = radians(0.25);
    std::vector<Index> order(mesh_.triangles.size());
    for (Index t = 0; t < mesh_.triangle_count(); ++t) order[t] = t;
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
      const double ua = std::floor(unrest[a] / bin), ub = std::floor(unrest[b] / bin);
      if (ua != ub) return ua < ub;
      return mesh_.area(a) != mesh_.area(b) ? mesh_.area(a) > mesh_.area(b) : a < b;
    });
    return order;
  }

  /// Mean turn to the neighbours, each weighing with its area.
  double unrest_at(Index t) const {
    double turn = 0, area = mesh_.area(t);
    for (Index h = 3 * t; h < 3 * t + 3; ++h) {
      if (!is_joined(h)) continue;
      const double weight = mesh_.area(mesh_.partner[h] / 3);
      turn += weight * std::max(0.0, mesh_.turn(h) - mesh_.reach(h) / options_.least_radius);
      area += weight;
    }
    return area > 0 ? turn / area : radians(180);
  }

  void grow(Index seed, Index number) {
    std::priority_queue<Step> queue;
    queue.push({0, seed, no_index});
    while (!queue.empty()) {
      const Step step = queue.top();
      queue.pop();
      if (patch_[step.triangle] != no_index) continue;
      patch_[step.triangle] = number;
      direction_[step.triangle] = direction_after(step);
      for (Index h = 3 * step.triangle; h < 3 * step.triangle + 3; ++h) {
        if (!is_joined(h) || patch_[mesh_.partner[h] / 3] != no_index) continue;
        const Index next = mesh_.partner[h] / 3;
        const double turn = turn_from(direction_[step.triangle], next);
        const double limit = options_.turn + mesh_.reach(h) / options_.least_radius;
        if (turn <= std::min(limit, options_.most_turn)) queue.push({turn, next, step.triangle});
      }
    }
  }

  double turn_from(Vec3 direction, Index t) const {
    const Vec3 normal = mesh_.area_vectors[t];
    return squared_norm(normal) == 0 ? 0 : angle_between(direction, normal);
  }

  /// Of the patch beside a facet and of the facet itself. Thin facets tell little, whichever way they are
  /// long. All neighbours count: along its own row a fillet never turns.
  Vec3 direction_after(const Step& step) const {
    const Vec3 own = normalized(mesh_.area_vectors[step.triangle]);
    if (step.from == no_index) return own;
    Vec3 around;
    for (Index h = 3 * step.triangle; h < 3 * step.triangle + 3; ++h)
      if (is_joined(h) && patch_[mesh_.beyond(h)] == patch_[step.triangle])
        around += direction_[mesh_.beyond(h)];
    const double trust = std::min(1.0, mesh_.lowest_height(step.triangle) / options_.memory);
    return normalized(lerp(normalized(around), own, trust));
  }

  /// Growth runs a little way up each fillet, more here and less there. What leans from the sheet at its rim
  /// is taken back.
  void trim() {
    std::vector<Index> waiting;
    for (Index t = 0; t < mesh_.triangle_count(); ++t) waiting.push_back(t);
    while (!waiting.empty()) {
      std::vector<Index> next;
      for (const Index t : waiting) {
        if (patch_[t] == no_index || !on_rim(t) || lean(t) <= trim_limit(t)) continue;
        patch_[t] = no_index;
        for (Index h = 3 * t; h < 3 * t + 3; ++h)
          if (mesh_.beyond(h) != no_index) next.push_back(mesh_.beyond(h));
      }
      waiting = std::move(next);
    }
  }

  /// From the direction of the sheet beside it; along its own row a fillet never turns.
  double lean(Index t) const {
    double most = 0;
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
      if (is_joined(h) && patch_[mesh_.beyond(h)] == patch_[t])
        most = std::max(most, turn_from(direction_[mesh_.beyond(h)], t));
    return most;
  }

  double trim_limit(Index t) const {
    return std::min(options_.rim_turn + mesh_.lowest_height(t) / options_.least_radius, options_.most_turn);
  }

  bool on_rim(Index t) const {
    for (Index h = 3 * t; h < 3 * t + 3; ++h)
      if (is_joined(h) && patch_[mesh_.beyond(h)] != patch_[t]) return true;
    return false;
  }

  /// What trimming has cut apart is several patches.
  void number_anew() {
    const std::vector<Index> before = std::move(patch_);
    patch_.assign(before.size(), no_index);
    count_ = 0;
    std::vector<Index> stack;
    for (Index seed = 0; seed < mesh_.triangle_count(); ++seed) {
      if (before[seed] == no_index || patch_[seed] != no_index) continue;
      patch_[seed] = count_;
      for (stack.push_back(seed); !stack.empty();) {
        const Index t = stack.back();
        stack.pop_back();
        for (Index h = 3 * t; h < 3 * t + 3; ++h) {
          const Index next = mesh_.beyond(h);
          if (next == no_index || before[next] != before[seed] || patch_[next] != no_index) continue;
          patch_[next] = count_;
          stack.push_back(next);
        }
      }
      ++count_;
    }
  }

  void drop_narrow() {
    std::vector<double> areas(count_, 0), circumferences(count_, 0);
    for (Index h = 0; h < Index(mesh_.partner.size()); ++h) {
      const Index p = patch_[h / 3];
      if (p == no_index) continue;
      if (h % 3 == 0) areas[p] += mesh_.area(h / 3);
      if (mesh_.partner[h] == no_index || patch_[mesh_.partner[h] / 3] != p)
        circumferences[p] += mesh_.length(h);
    }
    std::vector<Index> number(count_, no_index);
    Index kept = 0;
    for (Index p = 0; p < count_; ++p)
      if (2 * areas[p] >= options_.least_width * circumferences[p]) number[p] = kept++;
    for (Index& p : patch_)
      if (p != no_index) p = number[p];
  }

  const FacetMesh& mesh_;
  const SheetGrowthOptions& options_;
  std::vector<Index> patch_;     ///< per triangle
  std::vector<Vec3> direction_;  ///< per triangle: of the sheet around it
  Index count_ = 0;
};

}  // namespace

std::vector<Index> grow_sheets(const FacetMesh& mesh, const SheetGrowthOptions& options) {
  return SheetGrower(mesh, options).run();
}

}  // namespace beadmesh
