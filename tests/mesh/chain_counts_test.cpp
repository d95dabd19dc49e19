#include "beadmesh/mesh/chain_counts.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace beadmesh {
namespace {

Chain chain_of(double length, Index left, Index right, bool closed = false) {
  Chain chain;
  chain.arc_length = {0, length};
  chain.faces = {left, right};
  chain.closed = closed;
  return chain;
}

int total(const ChainSet& chains, Index face, const std::vector<int>& counts) {
  int sum = 0;
  for (const auto& loop : chains.loops[face])
    for (const ChainUse& use : loop) sum += counts[use.chain];
  return sum;
}

/// A sheet of columns x rows faces; `length` gives each chain its length.
template <class Length>
ChainSet checkerboard(Index columns, Index rows, Length length) {
  ChainSet set;
  set.loops.assign(columns * rows, {{}});
  const auto face = [&](Index i, Index j) {
    return i >= 0 && j >= 0 && i < columns && j < rows ? j * columns + i : no_index;
  };
  const auto add = [&](Index left, Index right) {
    if (left == no_index) std::swap(left, right);
    const Index chain = Index(set.chains.size());
    set.chains.push_back(chain_of(length(), left, right));
    set.loops[left][0].push_back({chain, false});
    if (right != no_index) set.loops[right][0].push_back({chain, true});
  };
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i <= columns; ++i) add(face(i, j), face(i - 1, j));
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i < columns; ++i) add(face(i, j), face(i, j - 1));
  return set;
}

TEST(ChainCounts, AreLengthsByTheSize) {
  const ChainSet set = checkerboard(2, 1, [] { return 40.0; });
  std::vector<int> counts(set.chains.size(), 0);
  assign_chain_counts(set, {true, true}, counts);
  for (const int n : counts) EXPECT_EQ(n, 8);
}

/// A sliver between two other faces, on two chains of one element each: it must not be lost.
TEST(ChainCounts, ALoopOfShortChainsHasFourNodes) {
  ChainSet set;
  set.chains = {chain_of(3, 0, 1), chain_of(2.8, 0, 2), chain_of(60, 1, no_index), chain_of(60, 2, no_index)};
  set.loops = {{{{0, false}, {1, false}}}, {{{0, true}, {2, false}}}, {{{1, true}, {3, false}}}};
  std::vector<int> counts(4, 0);
  assign_chain_counts(set, {true, true, true}, counts);
  EXPECT_GE(counts[0] + counts[1], 4);
  for (Index face = 0; face < 3; ++face) EXPECT_EQ(total(set, face, counts) % 2, 0);
}

TEST(ChainCounts, FollowTheSizingAndKeepTheMinimumWhereItIsFinest) {
  const ChainSet set = checkerboard(2, 1, [] { return 40.0; });
  ChainCountOptions options{5, 2.5};
  // 20 mm of size 10 and 20 mm of the second size, on every chain.
  const auto sized = [&](double size) {
    options.sizing.assign(set.chains.size(), {{0, 20, 40}, {0, 2, 2 + 20 / size}, size});
    std::vector<int> counts(set.chains.size(), 0);
    assign_chain_counts(set, {true, true}, counts, options);
    return counts;
  };
  for (const int n : sized(5)) EXPECT_EQ(n, 6);
  for (const int n : sized(2.6))
    EXPECT_EQ(n, 9) << "ten would have 2.52 mm at the finest, under 1.04 times 2.5";
  for (const int n : sized(1.25)) EXPECT_EQ(n, 8) << "18 elements, the shortest at least 1.04 times 2.5 mm";
}

TEST(ChainCounts, OneChainOfAnOddFaceChangesByOne) {
  double lengths[] = {40, 40, 40, 45};
  int next = 0;
  const ChainSet set = checkerboard(1, 1, [&] { return lengths[next++]; });
  std::vector<int> counts(4, 0);
  assign_chain_counts(set, {true}, counts);
  EXPECT_EQ(total(set, 0, counts) % 2, 0);
  EXPECT_LE(std::abs(total(set, 0, counts) - 33), 1);
}

TEST(ChainCounts, ClosedChainsAreEvenAndHoldFour) {
  ChainSet set;
  for (const double length : {45.0, 55.0, 8.0}) set.chains.push_back(chain_of(length, 0, no_index, true));
  set.loops = {{{{0, false}}, {{1, false}}, {{2, false}}}};
  std::vector<int> counts(3, 0);
  assign_chain_counts(set, {true}, counts);
  for (const int n : counts) EXPECT_EQ(n % 2, 0);
  EXPECT_EQ(counts[2], 4) << "too short for the minimum length, but a loop needs four nodes";
}

TEST(ChainCounts, SetCountsStay) {
  const ChainSet set = checkerboard(2, 2, [] { return 25.0; });
  std::vector<int> counts(set.chains.size(), 0);
  counts[0] = 7;
  counts[5] = 2;
  assign_chain_counts(set, {true, true, true, true}, counts);
  EXPECT_EQ(counts[0], 7);
  EXPECT_EQ(counts[5], 2);
  for (Index f = 0; f < 4; ++f) EXPECT_EQ(total(set, f, counts) % 2, 0);
}

TEST(ChainCounts, FaceThatCannotBeEvenIsLeftOdd) {
  const ChainSet set = checkerboard(1, 1, [] { return 25.0; });
  std::vector<int> counts{5, 5, 5, 4};
  assign_chain_counts(set, {true}, counts);
  EXPECT_EQ(counts, (std::vector<int>{5, 5, 5, 4}));
}

TEST(ChainCounts, MendingGoesAroundFacesThatAreNotFree) {
  // Three faces in a row; the middle one is a meshed bead with all its chains set.
  const ChainSet set = checkerboard(3, 1, [] { return 25.0; });
  std::vector<int> counts(set.chains.size(), 0);
  for (const ChainUse& use : set.loops[1][0]) counts[use.chain] = 4;
  const std::vector<int> before = counts;
  assign_chain_counts(set, {true, false, true}, counts);
  for (const ChainUse& use : set.loops[1][0]) EXPECT_EQ(counts[use.chain], before[use.chain]);
  EXPECT_EQ(total(set, 0, counts) % 2, 0);
  EXPECT_EQ(total(set, 2, counts) % 2, 0);
}

/// Random lengths, some of them short.
auto lengths_of(const std::vector<int>& tenths) {
  return [tenths, next = size_t{0}]() mutable { return tenths[next++ % tenths.size()] / 10.0; };
}

RC_GTEST_PROP(ChainCounts, AllFreeFacesBecomeEven, ()) {
  const Index columns = *rc::gen::inRange(1, 7), rows = *rc::gen::inRange(1, 7);
  const auto tenths = *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(5, 900)));
  const ChainSet set = checkerboard(columns, rows, lengths_of(tenths));
  std::vector<int> counts(set.chains.size(), 0);
  assign_chain_counts(set, std::vector<bool>(columns * rows, true), counts);
  for (Index f = 0; f < columns * rows; ++f) RC_ASSERT(total(set, f, counts) % 2 == 0);
  for (const int n : counts) RC_ASSERT(n >= 1);
}

RC_GTEST_PROP(ChainCounts, FacesInsideASetOutlineBecomeEvenInPairs, ()) {
  // Nothing can be handed to the outside: the odd faces pair up among themselves, at most one is left.
  const Index columns = *rc::gen::inRange(1, 6), rows = *rc::gen::inRange(1, 6);
  const auto tenths = *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(100, 900)));
  const ChainSet set = checkerboard(columns, rows, lengths_of(tenths));
  std::vector<int> counts(set.chains.size(), 0);
  int outline = 0;
  for (size_t c = 0; c < counts.size(); ++c)
    if (set.chains[c].faces[1] == no_index) {
      counts[c] = *rc::gen::inRange(1, 20);
      outline += counts[c];
    }
  assign_chain_counts(set, std::vector<bool>(columns * rows, true), counts);
  int odd = 0;
  for (Index f = 0; f < columns * rows; ++f) odd += total(set, f, counts) % 2;
  RC_ASSERT(odd == outline % 2);
}

RC_GTEST_PROP(ChainCounts, KeepTheMinimumLengthWhereThereIsRoom, ()) {
  const Index columns = *rc::gen::inRange(1, 6), rows = *rc::gen::inRange(1, 6);
  const auto tenths = *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(60, 900)));
  const ChainSet set = checkerboard(columns, rows, lengths_of(tenths));
  std::vector<int> counts(set.chains.size(), 0);
  assign_chain_counts(set, std::vector<bool>(columns * rows, true), counts);
  for (size_t c = 0; c < counts.size(); ++c) RC_ASSERT(set.chains[c].length() / counts[c] >= 2.5);
}

}  // namespace
}  // namespace beadmesh
