#include "beadmesh/mesh/loop_splitting.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "beadmesh/mesh/loop_template.h"
#include "beadmesh/mesh/mapped_area.h"
#include "beadmesh/mesh/segment_grid.h"

namespace beadmesh {
namespace {

constexpr int closure_cap = 10;
constexpr double clearance_weight = 4;
constexpr double wanted_clearance = 0.8;  // in sizes
constexpr double least_clearance = 0.45;
constexpr std::size_t all_pairs_limit = 80;
constexpr double first_radius = 3;   // in sizes: where larger loops look first
constexpr int nodes_per_line = 150;  // a larger loop is split by several lines at once
constexpr double cost_span = 0.4;    // between them

// What of a line's cost is known: most lines lie so far behind that the rest is never asked for. The cost
// only grows from one to the next.
enum class Known { angles, shape, all };

struct SplitLine {
  int from = 0, to = 0;  // positions, from < to
  int edges = 0;         // 0 while only the angles are known
  double cost = 0;
  Known known = Known::angles;
};

class SplitSearch {
 public:
  SplitSearch(const MeshDraft& draft, const NodeLoop& loop, const std::vector<double>& angles,
              const SplitWeights& weights)
      : draft_(draft),
        loop_(loop),
        angles_(angles),
        weights_(weights),
        walk_(angles),
        size_(static_cast<int>(loop.size())) {}

  // The cheapest visible line; for a large loop several at once, far from each other.
  std::vector<SplitLine> best() const {
    const double reach = 2 * extent();
    for (double radius = first_radius * draft_.size();; radius *= 2) {
      const bool all = loop_.size() <= all_pairs_limit || radius > reach;
      std::vector<SplitLine> found = cheapest(all ? all_pairs() : pairs_within(radius));
      if (!found.empty() || all) return found;
    }
  }

 private:
  std::vector<std::array<Index, 2>> edges() const {
    std::vector<std::array<Index, 2>> edges;
    for (int i = 0; i < size_; ++i) edges.push_back({loop_[i], loop_[(i + 1) % size_]});
    return edges;
  }

  double extent() const {
    double extent = 0;
    for (const Index node : loop_) extent = std::max(extent, distance(draft_.at(node), draft_.at(loop_[0])));
    return extent;
  }

  std::vector<SplitLine> cheapest(std::vector<SplitLine> lines) const {
    if (lines.empty()) return {};
    const SegmentGrid grid(draft_.nodes(), edges(), wanted_clearance * draft_.size());
    const auto dearer = [](const SplitLine& a, const SplitLine& b) {
      return std::tie(a.cost, a.from, a.to, a.edges) > std::tie(b.cost, b.from, b.to, b.edges);
    };
    const std::size_t wanted = 1 + loop_.size() / nodes_per_line;
    std::vector<SplitLine> chosen;
    std::make_heap(lines.begin(), lines.end(), dearer);
    while (!lines.empty() && chosen.size() < wanted) {
      std::pop_heap(lines.begin(), lines.end(), dearer);
      SplitLine line = lines.back();
      lines.pop_back();
      if (!chosen.empty() && line.cost > chosen.front().cost + cost_span) break;
      if (!is_far_from(line, chosen)) continue;
      if (line.known == Known::all) {
        chosen.push_back(line);
        continue;
      }
      if (line.known == Known::angles) {
        for (const SplitLine& shaped : with_edges(line)) {
          lines.push_back(shaped);
          std::push_heap(lines.begin(), lines.end(), dearer);
        }
        continue;
      }
      const Index a = loop_[line.from], b = loop_[line.to];
      const double clearance = grid.clearance(a, b) / draft_.scale(a, b);
      if (clearance < least_clearance) continue;
      const double lack = std::max(0.0, wanted_clearance - clearance) / wanted_clearance;
      line.cost += clearance_weight * lack * lack;
      line.known = Known::all;
      lines.push_back(line);
      std::push_heap(lines.begin(), lines.end(), dearer);
    }
    return chosen;
  }

  // Lines that do not interleave do not cross; those that keep a distance do not disturb each other's angles.
  bool is_far_from(const SplitLine& line, const std::vector<SplitLine>& others) const {
    const auto apart = [&](int a, int b) {
      const int steps = std::abs(a - b);
      return std::min(steps, size_ - steps) >= nodes_per_line / 4;
    };
    const auto between = [](int x, const SplitLine& other) { return other.from < x && x < other.to; };
    return std::all_of(others.begin(), others.end(), [&](const SplitLine& other) {
      return apart(line.from, other.from) && apart(line.from, other.to) && apart(line.to, other.from) &&
             apart(line.to, other.to) && between(line.from, other) == between(line.to, other);
    });
  }

  std::vector<SplitLine> all_pairs() const {
    std::vector<SplitLine> lines;
    for (int i = 0; i < size_; ++i) {
      for (int j = i + 2; j < size_; ++j) consider(i, j, lines);
    }
    return lines;
  }

  // By a sweep over x.
  std::vector<SplitLine> pairs_within(double radius) const {
    std::vector<SplitLine> lines;
    std::vector<int> order(size_);
    for (int i = 0; i < size_; ++i) order[i] = i;
    const auto x = [&](int position) { return draft_.at(loop_[position]).x; };
    std::sort(order.begin(), order.end(), [&](int a, int b) { return x(a) != x(b) ? x(a) < x(b) : a < b; });
    for (int a = 0; a < size_; ++a) {
      const Vec2 p = draft_.at(loop_[order[a]]);
      for (int b = a + 1; b < size_ && x(order[b]) - p.x <= radius; ++b) {
        const Vec2 q = draft_.at(loop_[order[b]]);
        if (std::abs(q.y - p.y) > radius) continue;
        const int i = std::min(order[a], order[b]), j = std::max(order[a], order[b]);
        if (j >= i + 2) consider(i, j, lines);
      }
    }
    return lines;
  }

  // Angle from the edge that leaves `at` to the line towards `other`.
  double part_at(int at, int other) const {
    const Vec2 p = draft_.at(loop_[at]);
    return turn_from(draft_.at(loop_[(at + 1) % size_]) - p, draft_.at(loop_[other]) - p);
  }

  // Sees without an angle that the line towards `other` lies outside the corner; lines near its sides are
  // left to the angles.
  bool leaves_corner(int at, int other) const {
    const Vec2 p = draft_.at(loop_[at]), line = draft_.at(loop_[other]) - p;
    const bool left_of_next = cross(draft_.at(loop_[(at + 1) % size_]) - p, line) > 0;
    const bool right_of_previous = cross(line, draft_.at(loop_[(at + size_ - 1) % size_]) - p) > 0;
    return angles_[at] < pi ? !left_of_next || !right_of_previous : !left_of_next && !right_of_previous;
  }

  void consider(int i, int j, std::vector<SplitLine>& lines) const {
    if (size_ - (j - i) < 2 || loop_[i] == loop_[j] || leaves_corner(i, j) || leaves_corner(j, i)) return;
    const double at_i = part_at(i, j);
    const double cost_i = split_angle_cost(angles_[i], at_i);
    if (cost_i < 0) return;
    const double at_j = part_at(j, i);
    const double cost_j = split_angle_cost(angles_[j], at_j);
    if (cost_j < 0) return;
    lines.push_back({i, j, 0, cost_i + cost_j - largest_bonus(), Known::angles});
  }

  // Where the angles of the parts round to fewer quads than the whole, defect_cost is negative.
  double largest_bonus() const { return 2 * weights_.singularity; }

  // The line with the numbers of edges that suit it, at most two.
  std::vector<SplitLine> with_edges(const SplitLine& bare) const {
    std::vector<SplitLine> lines;
    const int i = bare.from, j = bare.to;
    const double at_i = part_at(i, j), at_j = part_at(j, i);
    const double of_angles = split_angle_cost(angles_[i], at_i) + split_angle_cost(angles_[j], at_j);
    const double wanted = draft_.edge_count(loop_[i], loop_[j]);
    const int step = size_ % 2 == 0 ? 2 : 1;
    const int inner = j - i, outer = size_ - inner;
    const int floor = static_cast<int>(wanted);
    int first = std::max(1, floor - 1);
    if (step == 2 && (first + inner) % 2 != 0) ++first;
    for (int edges = first, tried = 0; tried < 2; edges += step, ++tried) {
      // Both parts must be smaller than the whole: recursion ends.
      if (edges >= inner || edges >= outer) break;
      if (edges == 1 && draft_.has_edge(loop_[i], loop_[j])) continue;
      SplitLine line{i, j, edges, of_angles, Known::shape};
      line.cost += weights_.misfit * misfit_cost(wanted, edges) + weights_.length * edges;
      const double share = static_cast<double>(inner) / size_;
      line.cost += weights_.balance * (1 - 4 * share * (1 - share));
      line.cost += defect_cost(line, at_i, at_j);
      lines.push_back(line);
    }
    return lines;
  }

  double defect_cost(const SplitLine& line, double at_i, double at_j) const {
    const int i_inner = quads_in_angle(at_i), i_outer = quads_in_angle(angles_[line.from] - at_i);
    const int j_outer = quads_in_angle(at_j), j_inner = quads_in_angle(angles_[line.to] - at_j);
    const auto inner = walk_.defect(line.from, line.to, line.edges, i_inner, j_inner);
    const auto outer = walk_.defect(line.to, line.from, line.edges, j_outer, i_outer);
    const int singularity = std::abs(inner[0]) + std::abs(outer[0]) - std::abs(walk_.net_singularity());
    return weights_.singularity * singularity +
           weights_.closure * (std::min(inner[1], closure_cap) + std::min(outer[1], closure_cap));
  }

  const MeshDraft& draft_;
  const NodeLoop& loop_;
  const std::vector<double>& angles_;
  const SplitWeights& weights_;
  LatticeWalk walk_;
  int size_;
};

class LoopSplitting {
 public:
  LoopSplitting(MeshDraft& draft, const SplitWeights& weights) : draft_(draft), weights_(weights) {}

  void fill(const NodeLoop& whole) {
    waiting_.push_back(whole);
    while (!waiting_.empty()) {
      const NodeLoop loop = std::move(waiting_.back());
      waiting_.pop_back();
      fill_one(loop);
    }
  }

 private:
  void fill_one(const NodeLoop& loop) {
    const bool small = loop.size() <= largest_template && loop.size() != 7;
    if (small) {
      if (!fill_by_template(draft_, loop)) put_ring_inside(loop);
      return;
    }
    const std::vector<double> angles = interior_angles(draft_.nodes(), loop);
    if (fill_by_mapping(draft_, loop, angles)) return;
    if (const auto lines = SplitSearch(draft_, loop, angles, weights_).best(); !lines.empty()) {
      split(loop, lines);
    } else if (const auto ear = least_bad_ear(loop, angles)) {
      split(loop, {*ear});
    } else {
      put_ring_inside(loop);
    }
  }

  // Lines in position order: parts are cut off from the innermost outwards.
  void split(const NodeLoop& loop, std::vector<SplitLine> lines) {
    std::sort(lines.begin(), lines.end(),
              [](const SplitLine& a, const SplitLine& b) { return a.to - a.from < b.to - b.from; });
    struct Place {
      Index node;
      int position;  // in the loop as it was, -1 for nodes of the lines
    };
    std::vector<Place> rest;
    for (std::size_t i = 0; i < loop.size(); ++i) rest.push_back({loop[i], static_cast<int>(i)});
    for (const SplitLine& line : lines) {
      const auto at = [&](int position) {
        return std::find_if(rest.begin(), rest.end(), [=](const Place& p) { return p.position == position; });
      };
      const auto from = at(line.from), to = at(line.to);
      const std::vector<Index> across = draft_.add_line(from->node, to->node, line.edges);
      NodeLoop part;
      for (auto place = from; place <= to; ++place) part.push_back(place->node);
      part.insert(part.end(), across.rbegin() + 1, across.rend() - 1);
      waiting_.push_back(std::move(part));
      std::vector<Place> inner;
      for (std::size_t i = 1; i + 1 < across.size(); ++i) inner.push_back({across[i], -1});
      rest.insert(rest.erase(from + 1, to), inner.begin(), inner.end());
    }
    NodeLoop last;
    for (const Place& place : rest) last.push_back(place.node);
    waiting_.push_back(std::move(last));
  }

  // Where nothing is visible (a folded loop): the chord over three edges that is nearest to a good quad.
  // Topology stays valid, the shape is left to the smoothing.
  std::optional<SplitLine> least_bad_ear(const NodeLoop& loop, const std::vector<double>& angles) const {
    const int n = static_cast<int>(loop.size());
    std::optional<SplitLine> best;
    for (int i = 0; i < n; ++i) {
      const int b = (i + 1) % n, c = (i + 2) % n, d = (i + 3) % n;
      if (loop[i] == loop[c] || loop[i] == loop[d] || loop[b] == loop[d] || draft_.has_edge(loop[i], loop[d]))
        continue;
      const double off = std::abs(angles[b] - pi / 2) + std::abs(angles[c] - pi / 2);
      if (!best || off < best->cost) best = SplitLine{std::min(i, d), std::max(i, d), 1, off};
    }
    return best;
  }

  // The last resort: a row of quads along the loop with all new inner nodes. Inside it nothing repeats.
  void put_ring_inside(const NodeLoop& loop) {
    const int n = static_cast<int>(loop.size());
    const std::vector<double> angles = interior_angles(draft_.nodes(), loop);
    NodeLoop ring;
    for (int i = 0; i < n; ++i) {
      const Vec2 p = draft_.at(loop[i]), ahead = draft_.at(loop[(i + 1) % n]) - p;
      const double half = angles[i] / 2, depth = 0.3 * norm(ahead);
      const Vec2 u = normalized(ahead);
      ring.push_back(draft_.add_node(p + depth * (std::cos(half) * u + std::sin(half) * left_normal(u))));
    }
    for (int i = 0; i < n; ++i) {
      const int j = (i + 1) % n;
      draft_.add_element({loop[i], loop[j], ring[j], ring[i]});
    }
    waiting_.push_back(std::move(ring));
  }

  MeshDraft& draft_;
  const SplitWeights& weights_;
  std::vector<NodeLoop> waiting_;
};

}  // namespace

double split_angle_cost(double whole, double part) {
  const double rest = whole - part;
  constexpr double least = 0.25;  // radians: a thinner corner is no candidate
  if (part < least || rest < least) return -1;
  const double a = (part - quads_in_angle(part) * pi / 2) / (pi / 4);
  const double b = (rest - quads_in_angle(rest) * pi / 2) / (pi / 4);
  return a * a + b * b;
}

double misfit_cost(double wanted, int edges) {
  const double ratio = std::log(wanted / edges);
  return ratio * ratio;
}

void fill_by_splitting(MeshDraft& draft, const NodeLoop& loop, const SplitWeights& weights) {
  if (loop.size() >= 3) LoopSplitting(draft, weights).fill(loop);
}

}  // namespace beadmesh
