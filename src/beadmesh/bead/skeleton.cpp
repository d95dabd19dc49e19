#include "beadmesh/bead/skeleton.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

void reverse(std::vector<MedialPoint>& points) {
  std::reverse(points.begin(), points.end());
  for (MedialPoint& p : points) std::swap(p.feet[0], p.feet[1]);
}

class Simplifier {
 public:
  Simplifier(const MedialObject& medial, const SkeletonOptions& options) : options_(options) {
    for (Index v = 0; v < Index(medial.vertices.size()); ++v) {
      const MedialVertex& vertex = medial.vertices[v];
      nodes_.push_back({vertex.point, vertex.radius, vertex.type, vertex.edges, v});
    }
    for (const MedialEdge& edge : medial.edges) arms_.push_back({edge.start, edge.end, edge.points});
    alive_.assign(arms_.size(), true);
  }

  Skeleton run() {
    while (drop_shortest_spur()) {
    }
    merge_near_junctions();
    return packed();
  }

 private:
  Index other_end(Index arm, Index node) const {
    return arms_[arm].start == node ? arms_[arm].end : arms_[arm].start;
  }

  bool is_leaf(Index node) const { return nodes_[node].arms.size() == 1; }

  void detach(Index node, Index arm) {
    auto& list = nodes_[node].arms;
    const auto at = std::find(list.begin(), list.end(), arm);
    if (at != list.end()) list.erase(at);
  }

  /// Drops one leaf arm that is short against the thickness at its junction; false where none is left.
  bool drop_shortest_spur() {
    Index best = no_index;
    double best_length = 0;
    for (Index a = 0; a < Index(arms_.size()); ++a) {
      if (!alive_[a] || arms_[a].start == no_index) continue;
      const bool start_leaf = is_leaf(arms_[a].start), end_leaf = is_leaf(arms_[a].end);
      if (start_leaf == end_leaf) continue;
      const Index junction = start_leaf ? arms_[a].end : arms_[a].start;
      const double length = length_of(arms_[a]);
      if (nodes_[junction].arms.size() < 3) continue;
      if (length > options_.spur_length * 2 * nodes_[junction].radius) continue;
      if (best == no_index || length < best_length) {
        best = a;
        best_length = length;
      }
    }
    if (best == no_index) return false;
    remove_spur(best);
    return true;
  }

  void remove_spur(Index arm) {
    const Index leaf = is_leaf(arms_[arm].start) ? arms_[arm].start : arms_[arm].end;
    const Index junction = other_end(arm, leaf);
    alive_[arm] = false;
    nodes_[leaf].arms.clear();
    detach(junction, arm);
    dissolve_if_degree_two(junction);
  }

  void dissolve_if_degree_two(Index node) {
    if (nodes_[node].arms.size() != 2) return;
    const Index a = nodes_[node].arms[0], b = nodes_[node].arms[1];
    if (a == b) return;  // a closed arm that hangs on this node alone: kept, the node is its seam
    if (arms_[a].end != node) turn(a);
    if (arms_[b].start != node) turn(b);
    SkeletonArm& joined = arms_[a];
    joined.points.insert(joined.points.end(), arms_[b].points.begin() + 1, arms_[b].points.end());
    joined.end = arms_[b].end;
    alive_[b] = false;
    nodes_[node].arms.clear();
    auto& list = nodes_[joined.end].arms;
    // A cycle through two nodes becomes a closed arm: its one node then lists it twice.
    std::replace(list.begin(), list.end(), b, a);
  }

  void turn(Index arm) {
    std::swap(arms_[arm].start, arms_[arm].end);
    reverse(arms_[arm].points);
  }

  void merge_near_junctions() {
    for (Index a = 0; a < Index(arms_.size()); ++a) {
      if (!alive_[a] || arms_[a].start == no_index || arms_[a].start == arms_[a].end) continue;
      const Index s = arms_[a].start, e = arms_[a].end;
      if (nodes_[s].arms.size() < 3 || nodes_[e].arms.size() < 3) continue;
      const double limit = options_.merge_distance * (nodes_[s].radius + nodes_[e].radius);
      if (length_of(arms_[a]) >= limit || !forms_cross(a)) continue;
      merge_ends(a);
    }
  }

  /// Two T's nearer than the width are one X only where their outer arms pair up into two through lines.
  bool forms_cross(Index arm) const {
    const Index s = arms_[arm].start, e = arms_[arm].end;
    if (nodes_[s].arms.size() != 3 || nodes_[e].arms.size() != 3) return false;
    const double reach = nodes_[s].radius + nodes_[e].radius;
    std::vector<Vec2> at_start, at_end;
    for (Index a : nodes_[s].arms)
      if (a != arm) at_start.push_back(direction_at(arms_[a], arms_[a].end == s, reach));
    for (Index a : nodes_[e].arms)
      if (a != arm) at_end.push_back(direction_at(arms_[a], arms_[a].end == e, reach));
    if (at_start.size() != 2 || at_end.size() != 2) return false;
    const auto through = [](Vec2 a, Vec2 b) { return angle_between(a, b) > radians(150); };
    return (through(at_start[0], at_end[0]) && through(at_start[1], at_end[1])) ||
           (through(at_start[0], at_end[1]) && through(at_start[1], at_end[0]));
  }

  void merge_ends(Index arm) {
    const Index s = arms_[arm].start, e = arms_[arm].end;
    const auto& around_s = nodes_[s].arms;
    const auto& around_e = nodes_[e].arms;
    const size_t at_s = std::find(around_s.begin(), around_s.end(), arm) - around_s.begin();
    const size_t at_e = std::find(around_e.begin(), around_e.end(), arm) - around_e.begin();
    std::vector<Index>
        merged;  // counter-clockwise about both: the arms of s after the bridge, then those of e
    for (size_t k = 1; k < around_s.size(); ++k) merged.push_back(around_s[(at_s + k) % around_s.size()]);
    for (size_t k = 1; k < around_e.size(); ++k) merged.push_back(around_e[(at_e + k) % around_e.size()]);
    nodes_[s].point = lerp(nodes_[s].point, nodes_[e].point, 0.5);
    nodes_[s].radius = std::max(nodes_[s].radius, nodes_[e].radius);
    for (Index a : around_e) {
      if (a == arm) continue;
      if (arms_[a].start == e) arms_[a].start = s;
      if (arms_[a].end == e) arms_[a].end = s;
    }
    alive_[arm] = false;
    nodes_[e].arms.clear();
    nodes_[s].arms = merged;
  }

  Skeleton packed() const {
    Skeleton out;
    std::vector<Index> node_of(nodes_.size(), no_index), arm_of(arms_.size(), no_index);
    for (size_t n = 0; n < nodes_.size(); ++n)
      if (!nodes_[n].arms.empty() || arms_.empty()) {
        node_of[n] = Index(out.nodes.size());
        out.nodes.push_back(nodes_[n]);
      }
    for (size_t a = 0; a < arms_.size(); ++a) {
      if (!alive_[a]) continue;
      arm_of[a] = Index(out.arms.size());
      SkeletonArm arm = arms_[a];
      if (arm.start != no_index) arm.start = node_of[arm.start];
      if (arm.end != no_index) arm.end = node_of[arm.end];
      out.arms.push_back(std::move(arm));
    }
    for (SkeletonNode& node : out.nodes)
      for (Index& a : node.arms) a = arm_of[a];
    return out;
  }

  SkeletonOptions options_;
  std::vector<SkeletonNode> nodes_;
  std::vector<SkeletonArm> arms_;
  std::vector<bool> alive_;
};

}  // namespace

Skeleton skeleton_of(const MedialObject& medial, const SkeletonOptions& options) {
  return Simplifier(medial, options).run();
}

double length_of(const SkeletonArm& arm) {
  double length = 0;
  for (size_t i = 1; i < arm.points.size(); ++i)
    length += distance(arm.points[i - 1].point, arm.points[i].point);
  if (arm.start == no_index && arm.points.size() > 1)
    length += distance(arm.points.back().point, arm.points.front().point);
  return length;
}

Vec2 direction_at(const SkeletonArm& arm, bool at_end, double reach) {
  const auto& points = arm.points;
  const size_t n = points.size();
  if (n < 2) return {0, 0};
  const Vec2 from = at_end ? points.back().point : points.front().point;
  double walked = 0;
  for (size_t k = 1; k < n; ++k) {
    const Vec2 a = points[at_end ? n - k : k - 1].point, b = points[at_end ? n - 1 - k : k].point;
    const double step = distance(a, b);
    if (walked + step >= reach && step > 0) return normalized(lerp(a, b, (reach - walked) / step) - from);
    walked += step;
  }
  return normalized((at_end ? points.front().point : points.back().point) - from);
}

}  // namespace beadmesh
