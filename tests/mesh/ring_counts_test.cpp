#include "beadmesh/mesh/ring_counts.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace beadmesh {
namespace {

std::vector<double> concentric(double first_radius, double width, int lines) {
  std::vector<double> lengths;
  for (int i = 0; i < lines; ++i) lengths.push_back(2 * pi * (first_radius + i * width));
  return lengths;
}

std::vector<RingBetween> nested(int lines, double width) {
  std::vector<RingBetween> rings;
  for (Index i = 0; i + 1 < lines; ++i) rings.push_back({{i, i + 1}, width});
  return rings;
}

TEST(RingCounts, OneRingCarriesOneNumberNearTheSize) {
  EXPECT_EQ(counts_of_rings(nested(2, 14), {250, 170}), (std::vector<int>{42, 42}));
}

TEST(RingCounts, LinesOfNoRingHaveNone) {
  EXPECT_EQ(counts_of_rings({{{0, 2}, 14}}, {250, 99, 170}), (std::vector<int>{42, 0, 42}));
}

TEST(RingCounts, AWideRingHasANumberForEachLoop) {
  const auto counts = counts_of_rings(nested(2, 40), {80, 330});
  EXPECT_LT(counts[0], counts[1]);
  EXPECT_LE(330.0 / counts[1], 8.5);
}

TEST(RingCounts, ANarrowRingHasOneNumberWhateverItsLengths) {
  const auto counts = counts_of_rings(nested(2, 10), {40, 120});
  EXPECT_EQ(counts[0], counts[1]);
}

/// However many rings there are, edges stay within the shares and the change comes late.
TEST(RingCounts, EdgesOfClustersStayNearTheSize) {
  for (const double first : {18.0, 25.0, 40.0})
    for (int lines = 3; lines < 12; ++lines) {
      const auto lengths = concentric(first, 14, lines);
      const auto counts = counts_of_rings(nested(lines, 14), lengths);
      for (int i = 0; i < lines; ++i) {
        EXPECT_EQ(counts[i] % 2, 0);
        EXPECT_GE(counts[i], 8);
        EXPECT_GE(lengths[i] / counts[i], 2.5) << first << " " << i << " of " << lines;
        EXPECT_LE(lengths[i] / counts[i], 8.6) << first << " " << i << " of " << lines;
        if (i > 0) {
          EXPECT_LE(counts[i], 4 * counts[i - 1]);
          EXPECT_GE(counts[i], counts[i - 1]);
        }
      }
    }
}

/// From 30 on the inner lines, 66 would suit the size outside: 46 keep the edges under 1.7 sizes.
TEST(RingCounts, OutwardsTheCountGrowsNoMoreThanNeeded) {
  const auto counts = counts_of_rings(nested(3, 14), {110, 240, 330});
  EXPECT_EQ(counts[0], 30);
  EXPECT_EQ(counts[1], 30);
  EXPECT_GT(counts[2], counts[1]);
  EXPECT_LE(counts[2], 46);
}

TEST(RingCounts, TheOrderOfRingsHasNoMeaning) {
  const auto lengths = concentric(20, 14, 7);
  auto rings = nested(7, 14);
  const auto counts = counts_of_rings(rings, lengths);
  std::reverse(rings.begin(), rings.end());
  for (auto& ring : rings) std::swap(ring.lines[0], ring.lines[1]);
  EXPECT_EQ(counts_of_rings(rings, lengths), counts);
}

TEST(RingCounts, WhatIsAskedHoldsForAllJoinedLines) {
  auto rings = nested(3, 14);
  rings[1].asked = 30;
  const auto counts = counts_of_rings(rings, {150, 200, 250});
  EXPECT_EQ(counts, (std::vector<int>{30, 30, 30}));
  auto wide = nested(3, 40);
  wide[1].asked = 100;
  EXPECT_EQ(counts_of_rings(wide, {60, 300, 560})[2], 100) << "however steep the change";
  rings[1].asked = 31;
  EXPECT_EQ(counts_of_rings(rings, {150, 200, 250})[0] % 2, 0) << "passed over";
}

}  // namespace
}  // namespace beadmesh
