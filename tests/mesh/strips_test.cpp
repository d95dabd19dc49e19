#include "beadmesh/mesh/strips.h"

#include <gtest/gtest.h>

#include "beadmesh/mesh/chain_counts.h"

namespace beadmesh {
namespace {

Chain chain_of(double length, Index left, Index right) {
  Chain chain;
  chain.arc_length = {0, length};
  chain.faces = {left, right};
  return chain;
}

/// Faces 0 .. n-1 in a row, chain i between faces i-1 and i; the long sides are free.
ChainSet row(const std::vector<double>& across, double along) {
  ChainSet set;
  const Index n = Index(across.size()) - 1;
  for (Index i = 0; i <= n; ++i)
    set.chains.push_back(chain_of(across[i], i < n ? i : i - 1, i > 0 && i < n ? i - 1 : no_index));
  for (Index f = 0; f < n; ++f) {
    const Index low = Index(set.chains.size());
    set.chains.push_back(chain_of(along, f, no_index));
    set.chains.push_back(chain_of(1.1 * along, f, no_index));
    set.loops.push_back({{{f, true}, {low, false}, {f + 1, false}, {low + 1, false}}});
  }
  return set;
}

TEST(Strips, OppositeChainsHangTogetherOverFaces) {
  const ChainSet set = row({20, 22, 26, 24}, 50);
  std::vector<double> wanted;
  for (const Chain& chain : set.chains) wanted.push_back(chain.length() / 5);
  const Strips strips(set, {true, true, true}, wanted);
  ASSERT_EQ(strips.groups().size(), 4);
  EXPECT_EQ(strips.groups()[0], (std::vector<Index>{0, 1, 2, 3}));
  EXPECT_EQ(strips.opposite(1, 1), 2);
  EXPECT_EQ(strips.opposite(1, 0), no_index);
  EXPECT_EQ(strips.group_of(0), strips.group_of(3));
  const Strips broken(set, {true, false, true}, wanted);
  EXPECT_EQ(broken.groups()[0], (std::vector<Index>{0, 1}));
}

TEST(Strips, AWedgeIsNone) {
  const ChainSet set = row({10, 40}, 50);
  const Strips strips(set, {true}, {2, 8, 10, 11});
  EXPECT_TRUE(strips.groups().empty());
}

TEST(ChainCounts, OppositeSidesOfStripsAreEqual) {
  const ChainSet set = row({20, 22, 26, 24}, 52);
  std::vector<int> counts(set.chains.size(), 0);
  assign_chain_counts(set, {true, true, true}, counts);
  for (const Index c : {1, 2, 3}) EXPECT_EQ(counts[c], counts[0]);
  for (Index f = 0; f < 3; ++f) EXPECT_EQ(counts[4 + 2 * f], counts[5 + 2 * f]);
}

TEST(ChainCounts, AStripTakesOverWhatABeadHasSet) {
  const ChainSet set = row({20, 22, 26}, 52);
  std::vector<int> counts(set.chains.size(), 0);
  counts[1] = 6;
  assign_chain_counts(set, {true, true}, counts);
  EXPECT_EQ(counts[0], 6);
  EXPECT_EQ(counts[2], 6);
}

/// Two odd faces at the ends of a strip: all chains across the strip change together.
TEST(ChainCounts, MendingRunsThroughStrips) {
  ChainSet set = row({20, 20, 20}, 50);
  // Triangles 2 and 3 at the ends, with an odd number of elements on their own two sides.
  for (const Index end : {0, 2}) {
    const Index face = Index(set.loops.size()), own = Index(set.chains.size());
    set.chains[end].faces = {end == 0 ? 0 : 1, face};
    set.chains.push_back(chain_of(25, face, no_index));
    set.chains.push_back(chain_of(30, face, no_index));
    set.loops.push_back({{{end, false}, {own, false}, {own + 1, false}}});
  }
  std::vector<int> counts(set.chains.size(), 0);
  counts[7] = counts[9] = 5, counts[8] = counts[10] = 6;  // set: only the strip can change
  assign_chain_counts(set, {true, true, true, true}, counts);
  EXPECT_EQ(counts[0] % 2, 1);
  EXPECT_EQ(counts[0], counts[1]);
  EXPECT_EQ(counts[0], counts[2]);
}

}  // namespace
}  // namespace beadmesh
