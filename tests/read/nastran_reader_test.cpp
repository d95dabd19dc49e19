#include "beadmesh/read/nastran_reader.h"
#include "beadmesh/read/shell_deck_file.h"

#include <gtest/gtest.h>

#include <string>

namespace beadmesh {
namespace {

const std::string square =
    "GRID           1              0.      0.      0.\n"
    "GRID           2            1.+1      0.      0.\n"
    "GRID           3            10.0   1.0E1     -.5\n"
    "GRID           4                     10.\n";

std::string code_of(const std::string& text) {
  const auto deck = parse_nastran(text);
  return deck ? "" : deck.error().code + " " + deck.error().entity;
}

TEST(NastranReader, ReadsSmallFields) {
  const auto deck = parse_nastran(square + "CQUAD4         7       3       1       2       3       4\n");
  ASSERT_TRUE(deck) << to_line(deck.error());
  ASSERT_EQ(deck->points.size(), 4);
  EXPECT_EQ(deck->points[1], (Vec3{10, 0, 0}));
  EXPECT_EQ(deck->points[2], (Vec3{10, 10, -0.5}));
  EXPECT_EQ(deck->points[3], (Vec3{0, 10, 0}));
  EXPECT_EQ(deck->elements.at(0), (std::array<Index, 4>{0, 1, 2, 3}));
  EXPECT_EQ(deck->properties.at(0), 3);
}

TEST(NastranReader, ReadsLargeAndFreeFieldsAndForwardReferences) {
  const auto deck = parse_nastran(
      "ctria3,1,1,10,20,30\n"
      "GRID*                 10                      1.23456789              0.*\n"
      "*                  -2.D0\n"
      "grid,20,,1,2.,3\n"
      "GRID,30,,0.,1.,0. $ a comment, with commas\n");
  ASSERT_TRUE(deck) << to_line(deck.error());
  EXPECT_EQ(deck->points[0], (Vec3{1.23456789, 0, -2}));
  EXPECT_EQ(deck->points[1], (Vec3{1, 2, 3}));
  EXPECT_EQ(deck->elements.at(0), (std::array<Index, 4>{0, 1, 2, no_index}));
  EXPECT_EQ(deck->node_ids, (std::vector<Index>{10, 20, 30}));
}

TEST(NastranReader, PassesOverControlSectionsOtherCardsAndWhatFollowsTheEnd) {
  const auto deck =
      parse_nastran("SOL 103\nCEND\nTITLE = GRID,1\nSET 1 = 1,2,\n  3,4\nBEGIN BULK\r\n" + square +
                    "PSHELL,1,1,1.\n+,2.\nCTRIA3,1,1,1,2,3\nENDDATA\nGRID,1,,0.,0.,0.\n");
  ASSERT_TRUE(deck) << to_line(deck.error());
  EXPECT_EQ(deck->points.size(), 4);
  EXPECT_EQ(deck->elements.size(), 1);
}

TEST(NastranReader, NamesWhatIsWrongAndWhere) {
  const std::string shell = "CTRIA3,1,1,1,2,3\n";
  EXPECT_EQ(code_of(""), "read.nastran.empty ");
  EXPECT_EQ(code_of(square), "read.nastran.empty ");
  EXPECT_EQ(code_of(square + "CTRIA3,1,1,1,2,9\n"), "read.nastran.node line 5");
  EXPECT_EQ(code_of(square + "CTRIA3,1,1,1,2\n"), "read.nastran.card line 5");
  EXPECT_EQ(code_of("$\nGRID,1,,x,0.,0.\n" + shell), "read.nastran.card line 2");
  EXPECT_EQ(code_of("BEGIN BULK\nGRID,1,,nan,0.,0.\n" + shell), "read.nastran.card line 2");
  EXPECT_EQ(code_of(square + "GRID,4,,0.,0.,0.\n" + shell), "read.nastran.node line 5");
  EXPECT_EQ(code_of("GRID,1,7,0.,0.,0.\n" + shell), "read.nastran.system line 1");
  EXPECT_EQ(code_of("INCLUDE 'a.bdf'\n" + shell), "read.nastran.include line 1");
}

TEST(NastranReader, EveryCutOfADeckIsAnAnswerNotACrash) {
  const std::string text =
      "BEGIN BULK\n" + square + "GRID*                 10\n*\nCTRIA3,1,1,1,2,3\nENDDATA\n";
  for (size_t length = 0; length <= text.size(); ++length) {
    const auto deck = parse_nastran(text.substr(0, length));
    if (!deck) {
      EXPECT_FALSE(deck.error().code.empty());
    }
  }
}

TEST(NastranReader, FilesAreNamed) {
  EXPECT_EQ(read_shell_deck("no/such/file.bdf").error().code, "read.not_found");
  EXPECT_EQ(read_shell_deck(".").error().code, "read.directory");
}

}  // namespace
}  // namespace beadmesh
