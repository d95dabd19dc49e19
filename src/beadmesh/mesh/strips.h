// Faces with four sides: rows of elements run through them.
#pragma once

#include <array>
#include <vector>

#include "beadmesh/panel/chain.h"

namespace beadmesh {

/// Faces whose opposite sides should carry the same number of elements, and the chains that so hang together.
class Strips {
 public:
  /// A face is a strip where it is one of `faces`, has one loop of four chains, and opposite chains differ by
  /// less than half of the shorter one (`wanted`: elements wished for on each chain).
  Strips(const ChainSet& chains, const std::vector<bool>& faces, const std::vector<double>& wanted);

  /// The chain opposite to `chain` in a face; no_index where the face is no strip.
  Index opposite(Index face, Index chain) const;
  /// Chains that hang together over strips, ascending, in the order of their first one; alone: not listed.
  const std::vector<std::vector<Index>>& groups() const { return groups_; }
  /// Position of the chain's group in groups(), no_index where it is alone.
  Index group_of(Index chain) const { return group_[chain]; }

 private:
  std::vector<std::array<Index, 4>> sides_;  ///< per face; no_index first where it is no strip
  std::vector<std::vector<Index>> groups_;
  std::vector<Index> group_;
};

}  // namespace beadmesh
