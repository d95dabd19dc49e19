#include "beadmesh/write/nastran_nodes.h"

#include <gtest/gtest.h>

namespace beadmesh {
namespace {

TEST(WithMovedNodes, OnlyTheirCardsChange) {
  const std::string deck =
      "SOL 103\nCEND\nSET 7 = 1 THRU 3\nBEGIN BULK\n"
      "GRID           1              1.      2.      3.\n"
      "grid,2,,1.0,2.0,3.0,,123\n"
      "GRID*                  3                              4.              5.*\n*                     6.\n"
      "$ GRID 1 in a comment\n"
      "CQUAD4         1       1       1       2       3       1\nENDDATA\n";
  EXPECT_EQ(with_moved_nodes(deck, {}), deck);
  const std::string moved = with_moved_nodes(deck, {{2, {7, -8, 0.5}}, {3, {1, 1, 1}}});
  EXPECT_EQ(moved,
            "SOL 103\nCEND\nSET 7 = 1 THRU 3\nBEGIN BULK\n"
            "GRID           1              1.      2.      3.\n"
            "GRID*                  2                      7.00000000     -8.00000000*\n"
            "*             0.50000000                             123                \n"
            "GRID*                  3                      1.00000000      1.00000000*\n"
            "*             1.00000000                                                \n"
            "$ GRID 1 in a comment\n"
            "CQUAD4         1       1       1       2       3       1\nENDDATA\n");
}

TEST(WithMovedNodes, ACommentInsideACardStays) {
  const std::string deck =
      "GRID*   1                               1.              1.\n$ hello\n*       1.\n";
  const std::string moved = with_moved_nodes(deck, {{1, {2, 2, 2}}});
  EXPECT_NE(moved.find("$ hello\n"), std::string::npos);
  EXPECT_EQ(moved.find(" 1.\n"), std::string::npos);
}

TEST(WithMovedNodes, ATextWithoutLineBreakAtItsEnd) {
  EXPECT_EQ(with_moved_nodes("GRID,1,,1.,2.,3.", {}), "GRID,1,,1.,2.,3.");
  EXPECT_NE(with_moved_nodes("GRID,1,,1.,2.,3.", {{1, {4, 5, 6}}}).find("4.00000000"), std::string::npos);
}

}  // namespace
}  // namespace beadmesh
