#include "beadmesh/mesh/ring_counts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace beadmesh {
namespace {

/// In sizes: edges between these are kept for the sake of lines with equal counts.
constexpr double shortest_share = 0.65, longest_share = 1.7;
/// In minimum lengths: half a ring at least as wide has room for a row of templates two elements high.
constexpr double graded_row = 2.2;
/// In minimum lengths: edges round an island that is to be meshed in rows.
constexpr double island_edge = 1.45;
/// From one set of lines to the next: as a rule, and what two graded rows make up for with room to spare.
constexpr double usual_growth = 1.5, most_growth = 4;

class RingCounts {
 public:
  RingCounts(const std::vector<RingBetween>& rings, const std::vector<double>& lengths)
      : rings_(rings), lengths_(lengths), set_(lengths.size()), counts_(lengths.size(), 0) {
    std::iota(set_.begin(), set_.end(), 0);
  }

  std::vector<int> run() {
    for (const RingBetween& ring : rings_)
      if (is_asked(ring) || ring.width < 2 * graded_row * ring.min_edge) join(ring);
    const std::vector<Index> outwards = outwards_order();
    for (const Index r : outwards)
      if (has_room_for_one_count(rings_[r])) join(rings_[r]);
    for (const RingBetween& ring : rings_)
      for (const Index line : ring.lines) counts_[set_[line]] = count_of(set_[line]);
    for (const Index r : outwards) limit_growth(rings_[r]);
    std::vector<int> counts;
    for (const Index set : set_) counts.push_back(counts_[set]);
    return counts;
  }

 private:
  double longest(const RingBetween& ring) const {
    return std::max(lengths_[ring.lines[0]], lengths_[ring.lines[1]]);
  }

  std::vector<Index> outwards_order() const {
    std::vector<Index> order(rings_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return longest(rings_[a]) < longest(rings_[b]); });
    return order;
  }

  bool is_asked(const RingBetween& ring) const {
    const double shortest = std::min(lengths_[ring.lines[0]], lengths_[ring.lines[1]]);
    return ring.asked >= 8 && ring.asked % 2 == 0 && ring.asked * ring.min_edge <= shortest;
  }

  void join(const RingBetween& ring) {
    const Index kept = set_[ring.lines[0]], gone = set_[ring.lines[1]];
    std::replace(set_.begin(), set_.end(), gone, kept);
  }

  bool has_room_for_one_count(const RingBetween& ring) const {
    double low = 1e300, high = 0;
    for (size_t line = 0; line < set_.size(); ++line)
      if (set_[line] == set_[ring.lines[0]] || set_[line] == set_[ring.lines[1]]) {
        low = std::min(low, lengths_[line]);
        high = std::max(high, lengths_[line]);
      }
    const double shortest = std::max(shortest_share * ring.size, island_edge * ring.min_edge);
    return high / low <= longest_share * ring.size / shortest;
  }

  /// What is asked of a ring of the set; 0: nothing.
  int asked_of(Index set) const {
    for (const RingBetween& ring : rings_)
      if (set_[ring.lines[0]] == set && is_asked(ring)) return ring.asked;
    return 0;
  }

  /// Near the size on the mean, within the shares where that is possible.
  int count_of(Index set) const {
    if (const int asked = asked_of(set)) return asked;
    double low = 1e300, high = 0, sum = 0, size = 1e300, min_edge = 0;
    int lines = 0;
    for (size_t line = 0; line < set_.size(); ++line)
      if (set_[line] == set) {
        low = std::min(low, lengths_[line]);
        high = std::max(high, lengths_[line]);
        sum += lengths_[line];
        ++lines;
      }
    for (const RingBetween& ring : rings_)
      if (set_[ring.lines[0]] == set || set_[ring.lines[1]] == set) {
        size = std::min(size, ring.size);
        min_edge = std::max(min_edge, ring.min_edge);
      }
    const int needed = int(std::ceil(high / (longest_share * size)));
    const int wanted = std::max(needed + needed % 2, int(std::lround(sum / lines / size)));
    return std::max(8, std::min(wanted, int(low / (island_edge * min_edge))) / 2 * 2);
  }

  /// Long edges cost less than many irregular nodes: outwards the count grows no more than needed.
  void limit_growth(const RingBetween& ring) {
    const bool swapped = lengths_[ring.lines[0]] > lengths_[ring.lines[1]];
    const Index inner = set_[ring.lines[swapped]], outer = set_[ring.lines[!swapped]];
    if (inner == outer || asked_of(outer)) return;
    double length = 0;
    for (size_t line = 0; line < set_.size(); ++line)
      if (set_[line] == outer) length = std::max(length, lengths_[line]);
    const int needed = 2 * int(std::ceil(length / (longest_share * ring.size) / 2));
    const int gentle = 2 * int(std::lround(usual_growth * counts_[inner] / 2));
    const int limit = std::min(std::max(needed, gentle), int(most_growth * counts_[inner]));
    counts_[outer] = std::min(counts_[outer], limit);
  }

  const std::vector<RingBetween>& rings_;
  const std::vector<double>& lengths_;
  std::vector<Index> set_;   ///< per line; lines of one set carry one count
  std::vector<int> counts_;  ///< per set
};

}  // namespace

std::vector<int> counts_of_rings(const std::vector<RingBetween>& rings, const std::vector<double>& lengths) {
  return RingCounts(rings, lengths).run();
}

}  // namespace beadmesh
