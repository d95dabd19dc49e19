#include "beadmesh/mesh/mesh_trial.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

constexpr int passes = 8;
constexpr double good_enough = 0.8;     // scaled Jacobian that a move may cost
constexpr double irregular_cost = 0.2;  // against one inverted element of 1 + poor_cost
constexpr double poor_jacobian = 0.65, poor_cost = 3;
constexpr double short_edge = 0.6, short_cost = 3;  // in sizes
constexpr double triangle_cost = 2;

class Trial {
 public:
  Trial(MeshDraft& draft, const MeshDraft::Mark& mark) : draft_(draft), mark_(mark) {
    const auto& elements = draft.elements();
    const std::size_t fresh = draft.nodes().size() - mark.nodes;
    start_.assign(fresh + 1, 0);
    const auto for_fresh_corners = [&](auto visit) {
      for (std::size_t e = mark.elements; e < elements.size(); ++e) {
        for (const Index node : elements[e]) {
          if (node >= static_cast<Index>(mark.nodes)) visit(node - mark.nodes, static_cast<Index>(e));
        }
      }
    };
    for_fresh_corners([&](std::size_t node, Index) { ++start_[node + 1]; });
    for (std::size_t i = 0; i < fresh; ++i) start_[i + 1] += start_[i];
    around_.resize(start_.back());
    std::vector<Index> next(start_.begin(), start_.end() - 1);
    for_fresh_corners([&](std::size_t node, Index element) { around_[next[node]++] = element; });
  }

  void relax() {
    for (int pass = 0; pass < passes; ++pass) {
      for (std::size_t i = mark_.nodes; i < draft_.nodes().size(); ++i) move(static_cast<Index>(i));
    }
  }

  Judgement judge() const {
    double cost = 0, worst = 1;
    std::vector<Index> touched;
    for (std::size_t e = mark_.elements; e < draft_.elements().size(); ++e) {
      const MeshElement& element = draft_.elements()[e];
      const double quality = jacobian(element), lack = 1 - quality;
      const double poor = std::max(0.0, poor_jacobian - quality) / poor_jacobian;
      worst = std::min(worst, quality);
      cost += lack * lack + poor_cost * poor + (is_quad(element) ? 0 : triangle_cost);
      const int corners = is_quad(element) ? 4 : 3;
      for (int i = 0; i < corners; ++i) {
        const double length = draft_.surface_length(element[i], element[(i + 1) % corners]) / draft_.size();
        cost += short_cost * std::max(0.0, short_edge - length);
        if (element[i] >= draft_.fixed_nodes()) touched.push_back(element[i]);
      }
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    for (const Index node : touched) cost += irregular_cost * std::abs(draft_.valence(node) - 4);
    return {cost, worst};
  }

 private:
  double jacobian(const MeshElement& element) const {
    const int corners = is_quad(element) ? 4 : 3;
    double worst = 1;
    for (int i = 0; i < corners; ++i) {
      const Vec2 p = draft_.at(element[i]);
      const Vec2 a = draft_.at(element[(i + 1) % corners]) - p,
                 b = draft_.at(element[(i + corners - 1) % corners]) - p;
      const double length = norm(a) * norm(b);
      worst = std::min(worst, length > 0 ? cross(a, b) / length : -1.0);
    }
    return worst;
  }

  double worst_around(Index node) const {
    double worst = 1;
    const std::size_t i = node - mark_.nodes;
    for (Index k = start_[i]; k < start_[i + 1]; ++k) {
      worst = std::min(worst, jacobian(draft_.elements()[around_[k]]));
    }
    return worst;
  }

  void move(Index node) {
    const Vec2 old = draft_.at(node);
    Vec2 sum;
    double weights = 0;
    const std::size_t i = node - mark_.nodes;
    for (Index k = start_[i]; k < start_[i + 1]; ++k) {
      const MeshElement& element = draft_.elements()[around_[k]];
      const int corners = is_quad(element) ? 4 : 3;
      const int at = static_cast<int>(std::find(element.begin(), element.end(), node) - element.begin());
      for (const int step : {1, corners - 1}) {
        const Vec2 other = draft_.at(element[(at + step) % corners]);
        const double weight = distance(other, old) + 1e-3 * draft_.size();
        sum += weight * other, weights += weight;
      }
    }
    if (!(weights > 0)) return;
    const double before = worst_around(node);
    draft_.move_node(node, sum / weights);
    const double after = worst_around(node);
    if (after < before && after < good_enough) draft_.move_node(node, old);
  }

  MeshDraft& draft_;
  const MeshDraft::Mark mark_;
  std::vector<Index> start_, around_;
};

}  // namespace

Judgement relax_and_judge(MeshDraft& draft, const MeshDraft::Mark& mark) {
  Trial trial(draft, mark);
  trial.relax();
  return trial.judge();
}

}  // namespace beadmesh
