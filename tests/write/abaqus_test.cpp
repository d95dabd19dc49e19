#include "beadmesh/write/abaqus.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "write/bead_plate.h"

namespace beadmesh {
namespace {

std::string abaqus_deck(const ShellMesh& mesh, const DeckOptions& options = {}) {
  std::ostringstream out;
  write_abaqus(mesh, out, options);
  return out.str();
}

TEST(Abaqus, HasABlockForEachPartAndType) {
  const std::string text = abaqus_deck(test::two_elements(), {101, 201, 1, 0});
  EXPECT_NE(
      text.find("*ELEMENT, TYPE=S4, ELSET=sheet\n201, 101, 102, 103, 104\n*ELEMENT, TYPE=S3, ELSET=flange\n"
                "202, 102, 105, 103\n"),
      std::string::npos);
  EXPECT_NE(text.find("\n105, 2.00000000, 0.50000000, 0.25000000\n"), std::string::npos);
}

TEST(Abaqus, EveryPartThatIsUsedHasASection) {
  ShellMesh mesh = test::two_elements();
  mesh.parts.push_back({10, "empty", 3});
  const std::string text = abaqus_deck(mesh);
  EXPECT_NE(text.find("*SHELL SECTION, ELSET=sheet, MATERIAL=steel\n1.25\n"), std::string::npos);
  EXPECT_NE(text.find("*SHELL SECTION, ELSET=flange, MATERIAL=steel\n0.8\n"), std::string::npos);
  EXPECT_EQ(text.find("empty"), std::string::npos);
}

TEST(Abaqus, SetsHaveAtMostSixteenMembersALine) {
  const std::string text = abaqus_deck(test::plate_mesh());
  EXPECT_NE(text.find("*NSET, NSET=bead_1_crest\n111, 112, 113, 114, 115, 116, 117, 118, 119, 120, 121\n"),
            std::string::npos);
  EXPECT_NE(
      text.find("*ELSET, ELSET=bead_1\n65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 85, 86, 87, 88\n89, "),
      std::string::npos);
  EXPECT_NE(text.find("*ELSET, ELSET=bead_1_caps\n65, 76, 85, 96, 105, 116, 125, 136\n"), std::string::npos);
  EXPECT_NE(text.find("*NSET, NSET=bead_1_boundary\n"), std::string::npos);
}

TEST(Abaqus, RunsAsItIsOrIsIncluded) {
  EXPECT_NE(abaqus_deck(test::plate_mesh()).find("*STEP\n*FREQUENCY\n16\n"), std::string::npos);
  const std::string text = abaqus_deck(test::plate_mesh(), {.analysis = DeckAnalysis::none});
  EXPECT_EQ(text.find("*STEP"), std::string::npos);
  EXPECT_EQ(text.find("*HEADING"), std::string::npos);
}

}  // namespace
}  // namespace beadmesh
