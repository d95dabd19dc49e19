#include "beadmesh/blocking/element_counts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace beadmesh {
namespace {

class Groups {
 public:
  explicit Groups(size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  Index find(Index a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  void join(Index a, Index b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<Index> parent_;
};

/// Distance of the element lengths from the target, as ratios; squared, since one long side of a block, as a
/// crest that runs on into a mitre, must not be outvoted by two short ones.
double misfit(const std::vector<double>& lengths, int n, double size) {
  double sum = 0;
  for (double length : lengths) {
    const double ratio = std::log(length / (n * size));
    sum += ratio * ratio;
  }
  return sum;
}

int best_count(const std::vector<double>& lengths, const ElementCountOptions& options) {
  const double shortest = *std::min_element(lengths.begin(), lengths.end());
  const double longest = *std::max_element(lengths.begin(), lengths.end());
  // A margin for what the smoothing shifts.
  const int most = std::max(1, int(std::floor(shortest / (1.08 * options.min_edge))));
  const int upper = std::max(1, std::min(most, int(std::ceil(longest / options.size)) + 1));
  int best = 1;
  for (int n = 2; n <= upper; ++n)
    if (misfit(lengths, n, options.size) < misfit(lengths, best, options.size)) best = n;
  return best;
}

int set_count(const BlockLayout& layout, const BlockSide& side) {
  int sum = 0;
  for (Index e : side.edges) {
    if (layout.edges[e].count == 0) return 0;
    sum += layout.edges[e].count;
  }
  return sum;
}

}  // namespace

Result<void> assign_counts(BlockLayout& layout, const std::vector<double>& lengths,
                           const ElementCountOptions& options) {
  Groups groups(layout.edges.size());
  for (const Block& block : layout.blocks)
    for (int k = block.graded ? 1 : 0; k < 2; ++k)
      if (block.sides[k].edges.size() == 1 && block.sides[k + 2].edges.size() == 1)
        groups.join(block.sides[k].edges[0], block.sides[k + 2].edges[0]);
  std::vector<std::vector<Index>> members(layout.edges.size());
  for (Index e = 0; e < Index(layout.edges.size()); ++e) members[groups.find(e)].push_back(e);
  for (const auto& group : members) {
    int count = 0;
    std::vector<double> of_group;
    for (Index e : group) {
      const int set = layout.edges[e].count;
      if (set && count && set != count)
        return fail("blocking.counts.contradiction",
                    "opposite sides of a block are given different numbers of elements");
      if (set) count = set;
      of_group.push_back(std::max(lengths[e], 1e-9));
    }
    if (group.empty()) continue;
    if (!count) count = best_count(of_group, options);
    for (Index e : group) layout.edges[e].count = count;
  }
  for (const Block& block : layout.blocks)
    for (int k = 0; k < 2; ++k) {
      const int difference = set_count(layout, block.sides[k]) - set_count(layout, block.sides[k + 2]);
      if (difference && !(block.graded && k == 0 && difference % 2 == 0))
        return fail("blocking.counts.unequal",
                    "opposite sides of a block carry different numbers of elements");
    }
  return {};
}

int elements_across(double width, double narrowest, const ElementCountOptions& options) {
  int best = 2;
  for (int m = 4; m * 1.08 * options.min_edge <= narrowest; m += 2)
    if (std::abs(std::log(width / (m * options.size))) <= std::abs(std::log(width / (best * options.size))))
      best = m;
  return best;
}

}  // namespace beadmesh
