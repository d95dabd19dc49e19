#include "beadmesh/mesh/chain_counts.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <queue>

#include "beadmesh/mesh/strips.h"

namespace beadmesh {
namespace {

class ParitySolver {
 public:
  ParitySolver(const ChainSet& chains, const std::vector<bool>& free_faces, std::vector<int>& counts,
               const ChainCountOptions& options)
      : chains_(chains), free_faces_(free_faces), counts_(counts) {
    for (size_t c = 0; c < counts.size(); ++c) {
      const double length = chains.chains[c].length(), room = 1.04 * options.min_edge;
      const bool uniform = options.sizing.empty();
      const double count = uniform ? length / options.size : options.sizing[c].count();
      wanted_.push_back(options.longer.empty() ? count : count * (1 + options.longer[c] / length));
      room_.push_back(uniform ? length / room : count * options.sizing[c].finest / room);
      fixed_.push_back(counts[c] > 0);
      // A closed chain needs four nodes to bound anything; open ones may be a single element.
      least_.push_back(chains.chains[c].closed ? 4 : 1);
      if (!fixed_[c]) counts[c] = natural_count(Index(c));
    }
    strips_.emplace(chains, free_faces, wanted_);
  }

  void run() {
    for (const auto& group : strips_->groups()) give_one_count(group);
    for (Index face = 0; face < Index(free_faces_.size()); ++face)
      if (free_faces_[face]) give_loops_four_nodes(face);
    for (Index face = 0; face < Index(free_faces_.size()); ++face)
      if (free_faces_[face] && is_odd(face) && !mend(face, true)) mend(face, false);
  }

 private:
  int least_count(Index c) const { return least_[c]; }

  /// All chains across a run of strips: what is set already, else what suits them in the mean. Chains that
  /// have no room for it stay as they are.
  void give_one_count(const std::vector<Index>& group) {
    int set = 0, least = 1, most = 1 << 30;
    double wanted = 0;
    for (const Index c : group) {
      if (fixed_[c]) set = set == 0 ? counts_[c] : set;
      least = std::max(least, least_count(c)), most = std::min(most, most_count(c));
      wanted += wanted_[c] / double(group.size());
    }
    const int count = set > 0 ? set : std::clamp(int(std::lround(wanted)), least, std::max(least, most));
    for (const Index c : group)
      if (!fixed_[c] && count <= most_count(c)) counts_[c] = count;
  }

  /// A loop of a few short chains needs four nodes as well: without them its face would be lost.
  void give_loops_four_nodes(Index face) {
    for (const auto& loop : chains_.loops[face]) {
      int total = 0;
      Index longest = no_index;
      for (const ChainUse& use : loop) {
        total += counts_[use.chain];
        if (!fixed_[use.chain] && (longest == no_index || wanted_[use.chain] > wanted_[longest]))
          longest = use.chain;
      }
      if (total >= 4 || longest == no_index) continue;
      counts_[longest] += 4 - total;
      least_[longest] = counts_[longest];
    }
  }

  int most_count(Index c) const { return std::max(least_count(c), int(std::floor(room_[c]))); }

  int natural_count(Index c) const {
    const int n = std::clamp(int(std::lround(wanted_[c])), least_count(c), most_count(c));
    return chains_.chains[c].closed && n % 2 ? changed(c, n) : n;
  }

  /// One more or one less, whichever keeps the elements nearer to the size and above the minimum.
  int changed(Index c, int n) const {
    if (n <= least_count(c)) return n + 1;
    if (n >= most_count(c)) return n - 1;
    const double fewer = std::log(wanted_[c] / (n - 1));
    const double more = std::log(wanted_[c] / (n + 1));
    return std::abs(more) < std::abs(fewer) ? n + 1 : n - 1;
  }

  double cost(Index c) const {
    const bool too_short = counts_[c] <= least_count(c) && counts_[c] >= most_count(c);
    return 1.0 / counts_[c] + (too_short ? 1e3 : 0);
  }

  bool is_odd(Index face) const {
    int total = 0;
    for (const auto& loop : chains_.loops[face])
      for (const ChainUse& use : loop) total += counts_[use.chain];
    return total % 2;
  }

  /// Cheapest path over changeable chains from an odd face to the outside or to another odd face (Dijkstra).
  /// `straight`: a path that enters a strip leaves it on the opposite side, so that its rows stay whole.
  /// False where there is no path.
  bool mend(Index start, bool straight) {
    const Index outside = Index(free_faces_.size());
    std::vector<double> best(free_faces_.size() + 1, 1e300);
    std::vector<Index> by(best.size(), no_index), from(best.size(), no_index);
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    best[start] = 0;
    queue.push({0, start});
    while (!queue.empty()) {
      const auto [so_far, face] = queue.top();
      queue.pop();
      if (so_far > best[face]) continue;
      if (face == outside || (face != start && is_odd(face))) {
        change_path(face, start, by, from);
        return true;
      }
      for (const auto& loop : chains_.loops[face])
        for (const ChainUse& use : loop) {
          const Index next = across(use.chain, face, outside);
          if (next == no_index || best[face] + cost(use.chain) >= best[next]) continue;
          if (straight && face != start && !may_leave(face, by[face], use.chain)) continue;
          best[next] = best[face] + cost(use.chain);
          by[next] = use.chain;
          from[next] = face;
          queue.push({best[next], next});
        }
    }
    return false;
  }

  bool may_leave(Index face, Index entered, Index chain) const {
    const Index opposite = strips_->opposite(face, entered);
    return opposite == no_index || opposite == chain;
  }

  Index across(Index c, Index face, Index outside) const {
    const auto& sides = chains_.chains[c].faces;
    if (fixed_[c] || sides[0] == sides[1]) return no_index;
    const Index other = sides[0] == face ? sides[1] : sides[0];
    if (other == no_index) return outside;
    return free_faces_[other] ? other : no_index;
  }

  void change_path(Index end, Index start, const std::vector<Index>& by, const std::vector<Index>& from) {
    // Chains across a run of strips change together, all in one direction.
    Index last = no_index;
    int step = 0;
    for (Index face = end; face != start; face = from[face]) {
      const Index chain = by[face], group = strips_->group_of(chain);
      const bool goes_on = last != no_index && group != no_index && group == strips_->group_of(last) &&
                           counts_[chain] + step >= 1;
      if (!goes_on) step = changed(chain, counts_[chain]) - counts_[chain];
      counts_[chain] += step;
      last = chain;
    }
  }

  const ChainSet& chains_;
  const std::vector<bool>& free_faces_;
  std::vector<int>& counts_;
  std::vector<double> wanted_;  ///< elements of the target size
  std::vector<double> room_;    ///< elements of the minimum length
  std::vector<bool> fixed_;
  std::vector<int> least_;  ///< elements that a chain may not go below
  std::optional<Strips> strips_;
};

}  // namespace

void assign_chain_counts(const ChainSet& chains, const std::vector<bool>& free_faces,
                         std::vector<int>& counts, const ChainCountOptions& options) {
  ParitySolver(chains, free_faces, counts, options).run();
}

}  // namespace beadmesh
