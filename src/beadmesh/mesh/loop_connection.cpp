#include "beadmesh/mesh/loop_connection.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "beadmesh/mesh/loop_splitting.h"
#include "beadmesh/mesh/segment_grid.h"

namespace beadmesh {
namespace {

constexpr double misfit_weight = 3;
constexpr double length_weight = 0.3;  // per edge
constexpr double wanted_clearance = 0.8, least_clearance = 0.3;
constexpr double clearance_weight = 2;

struct Connector {
  int at_joined = 0, at_loop = 0;  // positions
  int edges = 0;
  double cost = 0;
};

class LoopConnection {
 public:
  LoopConnection(MeshDraft& draft, const std::vector<NodeLoop>& loops, bool against_vote)
      : draft_(draft), loops_(loops), against_vote_(against_vote) {
    joined_ = loops[0];
    nearest_.assign(loops.size(), 1e300);
    done_.assign(loops.size(), false);
    done_[0] = true;
    for (const NodeLoop& loop : loops) enter_edges(loop);
    update_nearest(joined_);
  }

  NodeLoop connect() {
    for (std::size_t step = 1; step < loops_.size(); ++step) {
      std::vector<std::size_t> order;
      for (std::size_t k = 0; k < loops_.size(); ++k) {
        if (!done_[k]) order.push_back(k);
      }
      std::stable_sort(order.begin(), order.end(),
                       [&](std::size_t a, std::size_t b) { return nearest_[a] < nearest_[b]; });
      const bool joined = std::any_of(order.begin(), order.end(), [&](std::size_t k) { return join(k); });
      if (!joined) return {};
    }
    return joined_;
  }

 private:
  void enter_edges(const NodeLoop& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) edges_.push_back({loop[i], loop[(i + 1) % loop.size()]});
  }

  void update_nearest(const NodeLoop& fresh) {
    for (std::size_t k = 1; k < loops_.size(); ++k) {
      if (done_[k]) continue;
      for (const Index a : loops_[k]) {
        for (const Index b : fresh) {
          nearest_[k] = std::min(nearest_[k], a == b ? -1.0 : squared_norm(draft_.at(a) - draft_.at(b)));
        }
      }
    }
  }

  bool join(std::size_t k) {
    const NodeLoop& loop = loops_[k];
    std::vector<Index> line;
    Connector connector;
    if (nearest_[k] < 0) {
      connector = common_node(loop);
      line = {joined_[connector.at_joined]};
    } else {
      connector = best_line(loop, std::sqrt(nearest_[k]));
      if (connector.edges == 0) return false;
      line = draft_.add_line(joined_[connector.at_joined], loop[connector.at_loop], connector.edges);
      for (std::size_t i = 0; i + 1 < line.size(); ++i) edges_.push_back({line[i], line[i + 1]});
    }
    NodeLoop merged(joined_.begin(), joined_.begin() + connector.at_joined);
    merged.insert(merged.end(), line.begin(), line.end());
    const std::size_t n = loop.size();
    // Once around the hole; a common node is not visited by the line, so the last step returns to it.
    for (std::size_t i = 1; i < n; ++i) merged.push_back(loop[(connector.at_loop + i) % n]);
    merged.insert(merged.end(), line.rbegin(), line.rend());
    merged.insert(merged.end(), joined_.begin() + connector.at_joined + 1, joined_.end());
    joined_ = std::move(merged);
    done_[k] = true;
    update_nearest(loop);
    update_nearest(line);
    return true;
  }

  // Positions of the same node, such that the scar leaves inside the interior angle.
  Connector common_node(const NodeLoop& loop) const {
    const std::vector<double> angles = interior_angles(draft_.nodes(), joined_);
    Connector found;
    for (std::size_t j = 0; j < loop.size(); ++j) {
      for (std::size_t i = 0; i < joined_.size(); ++i) {
        if (loop[j] != joined_[i]) continue;
        found.at_joined = static_cast<int>(i), found.at_loop = static_cast<int>(j);
        const Vec2 p = draft_.at(loop[j]);
        const Vec2 leaving = draft_.at(loop[(j + 1) % loop.size()]) - p;
        if (turn_from(draft_.at(joined_[(i + 1) % joined_.size()]) - p, leaving) < angles[i]) return found;
      }
    }
    return found;
  }

  Connector best_line(const NodeLoop& loop, double nearest) const {
    const std::vector<double> joined_angles = interior_angles(draft_.nodes(), joined_);
    const std::vector<double> loop_angles = interior_angles(draft_.nodes(), loop);
    const SegmentGrid grid(draft_.nodes(), edges_, wanted_clearance * draft_.size());
    for (double radius = 1.5 * nearest + draft_.size(); radius < 1e9 * (nearest + draft_.size());
         radius *= 2) {
      const std::vector<Connector> lines = candidates(loop, joined_angles, loop_angles, radius);
      for (const double least : {least_clearance, 0.0}) {
        const Connector best = cheapest(lines, grid, loop, least);
        if (best.edges > 0) return best;
      }
      if (radius > reach()) break;
    }
    return {};
  }

  double reach() const {
    double reach = 0;
    for (const Index a : joined_) reach = std::max(reach, distance(draft_.at(a), draft_.at(joined_[0])));
    return 2 * reach;
  }

  double angle_cost(const NodeLoop& loop, const std::vector<double>& angles, int at, Index other) const {
    const Vec2 p = draft_.at(loop[at]), next = draft_.at(loop[(at + 1) % loop.size()]);
    return split_angle_cost(angles[at], turn_from(next - p, draft_.at(other) - p));
  }

  std::vector<Connector> candidates(const NodeLoop& loop, const std::vector<double>& joined_angles,
                                    const std::vector<double>& loop_angles, double radius) const {
    std::vector<Connector> found;
    for (int j = 0; j < static_cast<int>(loop.size()); ++j) {
      for (int i = 0; i < static_cast<int>(joined_.size()); ++i) {
        const Index a = joined_[i], b = loop[j];
        if (squared_norm(draft_.at(a) - draft_.at(b)) > radius * radius) continue;
        const double at_joined = angle_cost(joined_, joined_angles, i, b);
        if (at_joined < 0) continue;
        const double at_loop = angle_cost(loop, loop_angles, j, a);
        if (at_loop < 0) continue;
        const double wanted = draft_.edge_count(a, b);
        const int edges = std::max(1, static_cast<int>(std::lround(wanted)));
        if (edges == 1 && draft_.has_edge(a, b)) continue;
        found.push_back(
            {i, j, edges,
             at_joined + at_loop + misfit_weight * misfit_cost(wanted, edges) + length_weight * edges});
      }
    }
    std::sort(found.begin(), found.end(), [](const Connector& a, const Connector& b) {
      return std::tie(a.cost, a.at_loop, a.at_joined) < std::tie(b.cost, b.at_loop, b.at_joined);
    });
    return found;
  }

  // The quads colour the nodes like a chessboard, so a line fixes the colours of the loop against those of
  // the rest. The good lines vote.
  Connector cheapest(const std::vector<Connector>& lines, const SegmentGrid& grid, const NodeLoop& loop,
                     double least) const {
    Connector best[2];
    double votes[2] = {0, 0};
    std::size_t seen = 0;
    for (const Connector& line : lines) {
      const Index a = joined_[line.at_joined], b = loop[line.at_loop];
      const double clearance = grid.clearance(a, b) / draft_.scale(a, b);
      if (clearance < least) continue;
      const double lack = std::max(0.0, wanted_clearance - clearance) / wanted_clearance;
      const double cost = line.cost + clearance_weight * lack * lack;
      const int colour = (line.at_joined + line.at_loop + line.edges) % 2;
      votes[colour] += std::exp(-2 * cost);
      if (best[colour].edges == 0 || cost < best[colour].cost) {
        best[colour] = line;
        best[colour].cost = cost;
      }
      if (++seen > 4 * loop.size() + 50) break;
    }
    if (best[0].edges == 0 || best[1].edges == 0) return best[0].edges > 0 ? best[0] : best[1];
    return best[(votes[0] >= votes[1]) == against_vote_ ? 1 : 0];
  }

  MeshDraft& draft_;
  const std::vector<NodeLoop>& loops_;
  const bool against_vote_;
  NodeLoop joined_;
  std::vector<double> nearest_;
  std::vector<bool> done_;
  std::vector<std::array<Index, 2>> edges_;
};

}  // namespace

NodeLoop connect_loops(MeshDraft& draft, const std::vector<NodeLoop>& loops, bool against_vote) {
  return LoopConnection(draft, loops, against_vote).connect();
}

}  // namespace beadmesh
