#include "examples/chance.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace beadmesh::examples {
namespace {

TEST(Chance, GivesTheNumbersOfTheReference) {
  Chance chance(1234567);  // the test vector that goes with the reference implementation of SplitMix64
  EXPECT_EQ(chance.next(), 6457827717110365317u);
  EXPECT_EQ(chance.next(), 3203168211198807973u);
}

TEST(Chance, StaysInRangeAndReachesAllOfIt) {
  Chance chance(7);
  double least = 10, most = 0;
  int counts[3] = {};
  for (int i = 0; i < 1000; ++i) {
    const double x = chance.between(2, 5);
    least = std::min(least, x);
    most = std::max(most, x);
    ++counts[chance.below(3)];
  }
  EXPECT_GE(least, 2);
  EXPECT_LT(least, 2.05);
  EXPECT_LT(most, 5);
  EXPECT_GT(most, 4.95);
  for (const int count : counts) EXPECT_GT(count, 250);
}

}  // namespace
}  // namespace beadmesh::examples
