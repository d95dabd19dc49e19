#include "beadmesh/mesh/strips.h"

#include <algorithm>
#include <numeric>

namespace beadmesh {
namespace {

constexpr double largest_ratio = 1.5;

bool are_alike(double a, double b) {
  return std::max(a, b) <= largest_ratio * std::min(a, b);
}

/// The first chain of the group, with paths halved on the way.
Index root_of(std::vector<Index>& parent, Index chain) {
  while (parent[chain] != chain) chain = parent[chain] = parent[parent[chain]];
  return chain;
}

}  // namespace

Strips::Strips(const ChainSet& chains, const std::vector<bool>& faces, const std::vector<double>& wanted)
    : sides_(faces.size(), {no_index, no_index, no_index, no_index}), group_(chains.chains.size(), no_index) {
  std::vector<Index> parent(chains.chains.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (size_t f = 0; f < faces.size(); ++f) {
    if (!faces[f] || chains.loops[f].size() != 1 || chains.loops[f][0].size() != 4) continue;
    std::array<Index, 4> side;
    for (int k = 0; k < 4; ++k) side[k] = chains.loops[f][0][k].chain;
    if (side[0] == side[2] || side[1] == side[3] || !are_alike(wanted[side[0]], wanted[side[2]]) ||
        !are_alike(wanted[side[1]], wanted[side[3]]))
      continue;
    sides_[f] = side;
    for (int k = 0; k < 2; ++k) {
      const Index a = root_of(parent, side[k]), b = root_of(parent, side[k + 2]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<std::vector<Index>> members(parent.size());
  for (Index c = 0; c < Index(parent.size()); ++c) members[root_of(parent, c)].push_back(c);
  for (auto& group : members) {
    if (group.size() < 2) continue;
    for (const Index c : group) group_[c] = Index(groups_.size());
    groups_.push_back(std::move(group));
  }
}

Index Strips::opposite(Index face, Index chain) const {
  const auto& side = sides_[face];
  for (int k = 0; k < 4; ++k)
    if (side[k] == chain && chain != no_index) return side[(k + 2) % 4];
  return no_index;
}

}  // namespace beadmesh
