#include "beadmesh/mesh/loop_template.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace beadmesh {
namespace {

// Corners below the loop's size are loop positions (turned by the rotation), the others inner nodes.
struct Template {
  int loop, inner, rotations;
  std::vector<std::array<int, 4>> elements;  // -1: no fourth corner
};

const std::vector<Template>& templates() {
  static const std::vector<Template> all{
      {3, 0, 1, {{0, 1, 2, -1}}},
      {4, 0, 1, {{0, 1, 2, 3}}},
      {5, 0, 5, {{0, 1, 2, 3}, {0, 3, 4, -1}}},
      {6, 0, 3, {{0, 1, 2, 3}, {0, 3, 4, 5}}},
      {6, 1, 2, {{0, 1, 2, 6}, {2, 3, 4, 6}, {4, 5, 0, 6}}},
      {8, 0, 4, {{0, 1, 2, 3}, {0, 3, 4, 7}, {4, 5, 6, 7}}},
      {8, 0, 8, {{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 7}}},
      {8, 1, 2, {{0, 1, 2, 8}, {2, 3, 4, 8}, {4, 5, 6, 8}, {6, 7, 0, 8}}},
      {8, 1, 8, {{0, 1, 2, 3}, {0, 3, 4, 8}, {4, 5, 6, 8}, {6, 7, 0, 8}}},
      {8, 1, 8, {{0, 1, 2, 3}, {3, 4, 5, 8}, {5, 6, 7, 8}, {7, 0, 3, 8}}},
      {8, 2, 8, {{0, 1, 2, 8}, {2, 3, 4, 8}, {8, 4, 5, 9}, {5, 6, 7, 9}, {9, 7, 0, 8}}},
  };
  return all;
}

double corner_quality(const std::array<Vec2, 4>& p, int corners) {
  double worst = 1;
  for (int i = 0; i < corners; ++i) {
    const Vec2 a = p[(i + 1) % corners] - p[i], b = p[(i + corners - 1) % corners] - p[i];
    const double length = norm(a) * norm(b);
    worst = std::min(worst, length > 0 ? cross(a, b) / length : -1.0);
  }
  return corners == 4 ? worst : worst * (2 / std::sqrt(3.0));
}

struct Filling {
  std::vector<Vec2> inner;
  std::vector<std::array<int, 4>> elements;
  double score = -1e300;
};

class TemplateFilling {
 public:
  TemplateFilling(const MeshDraft& draft, const NodeLoop& loop) : draft_(draft), loop_(loop) {
    for (const Index node : loop) points_.push_back(draft.at(node));
  }

  std::optional<Filling> best() const {
    std::optional<Filling> best;
    for (const Template& candidate : templates()) {
      if (candidate.loop != size()) continue;
      for (int rotation = 0; rotation < candidate.rotations; ++rotation) {
        Filling filling;
        filling.elements = turned(candidate, rotation);
        if (!is_allowed(filling.elements)) continue;
        filling.inner = relaxed(filling.elements, candidate.inner);
        filling.score = score(filling);
        if (!best || filling.score > best->score) best = filling;
      }
    }
    return best;
  }

 private:
  int size() const { return static_cast<int>(loop_.size()); }

  std::vector<std::array<int, 4>> turned(const Template& candidate, int rotation) const {
    auto elements = candidate.elements;
    for (auto& element : elements) {
      for (int& corner : element) {
        if (corner >= 0 && corner < size()) corner = (corner + rotation) % size();
      }
    }
    return elements;
  }

  bool is_allowed(const std::vector<std::array<int, 4>>& elements) const {
    for (const auto& element : elements) {
      const int corners = element[3] < 0 ? 3 : 4;
      for (int i = 0; i < corners; ++i) {
        for (int j = 0; j < i; ++j) {
          if (element[i] < size() && element[j] < size() && loop_[element[i]] == loop_[element[j]])
            return false;
        }
        const int a = element[i], b = element[(i + 1) % corners];
        if (a >= size() || b >= size() || (a + 1) % size() == b) continue;
        if (draft_.has_edge(loop_[a], loop_[b])) return false;
      }
    }
    return true;
  }

  Vec2 place(const Filling& filling, int corner) const {
    return corner < size() ? points_[corner] : filling.inner[corner - size()];
  }

  // Inner nodes to the mean of their neighbours, a few times.
  std::vector<Vec2> relaxed(const std::vector<std::array<int, 4>>& elements, int count) const {
    Vec2 centre;
    for (const Vec2& point : points_) centre += point;
    Filling filling{std::vector<Vec2>(count, centre / size()), elements, 0};
    for (int pass = 0; pass < 4 * count; ++pass) {
      const int node = size() + pass % count;
      Vec2 sum;
      int neighbours = 0;
      for (const auto& element : elements) {
        for (int i = 0; i < 4; ++i) {
          if (element[i] != node) continue;
          sum += place(filling, element[(i + 1) % 4]) + place(filling, element[(i + 3) % 4]);
          neighbours += 2;
        }
      }
      filling.inner[pass % count] = sum / neighbours;
    }
    return filling.inner;
  }

  // The worst element counts most; fewer elements win ties.
  double score(const Filling& filling) const {
    double worst = 1, sum = 0;
    for (const auto& element : filling.elements) {
      const int corners = element[3] < 0 ? 3 : 4;
      std::array<Vec2, 4> p;
      for (int i = 0; i < corners; ++i) p[i] = place(filling, element[i]);
      const double quality = corner_quality(p, corners);
      worst = std::min(worst, quality);
      sum += quality;
    }
    const double elements = static_cast<double>(filling.elements.size());
    return worst + sum / elements - 0.02 * elements;
  }

  const MeshDraft& draft_;
  const NodeLoop& loop_;
  std::vector<Vec2> points_;
};

}  // namespace

bool fill_by_template(MeshDraft& draft, const NodeLoop& loop) {
  const auto filling = TemplateFilling(draft, loop).best();
  if (!filling) return false;
  std::vector<Index> nodes = loop;
  for (const Vec2& point : filling->inner) nodes.push_back(draft.add_node(point));
  for (const auto& element : filling->elements) {
    MeshElement added;
    for (int i = 0; i < 4; ++i) added[i] = element[i] < 0 ? no_index : nodes[element[i]];
    draft.add_element(added);
  }
  return true;
}

}  // namespace beadmesh
