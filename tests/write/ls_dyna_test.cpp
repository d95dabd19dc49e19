#include "beadmesh/write/ls_dyna.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "write/bead_plate.h"

namespace beadmesh {
namespace {

std::string ls_dyna_deck(const ShellMesh& mesh, const DeckOptions& options = {}) {
  std::ostringstream out;
  write_ls_dyna(mesh, out, options);
  return out.str();
}

TEST(LsDyna, RepeatsTheThirdNodeOfATriangle) {
  const std::string text = ls_dyna_deck(test::two_elements(), {101, 201, 11, 0});
  EXPECT_NE(text.find("\n     201      17     101     102     103     104\n"), std::string::npos);
  EXPECT_NE(text.find("\n     202      19     102     105     103     103\n"), std::string::npos);
}

TEST(LsDyna, EveryPartHasItsSectionAndTheMaterial) {
  const std::string text = ls_dyna_deck(test::two_elements(), {1, 1, 11, 0});
  EXPECT_NE(text.find("*PART\nflange\n$      pid     secid       mid\n        19        19        11\n"),
            std::string::npos);
  EXPECT_NE(text.find("\n      1.25      1.25      1.25      1.25\n"), std::string::npos);
  EXPECT_NE(text.find("\n        11  7.85e-09   210000.       0.3\n"), std::string::npos);
}

TEST(LsDyna, NoCardIsLongerThanItsColumns) {
  ShellMesh mesh = test::plate_mesh();
  mesh.title = std::string(300, 'x') + "\n*END";
  mesh.nodes[3] = {-99'999.123456789, 1e-300, 12'345'678.9};
  std::istringstream in(ls_dyna_deck(mesh, {99'000'000, 99'000'000, 99'000'000, 90'000'000}));
  for (std::string line; std::getline(in, line);) EXPECT_LE(line.size(), line[0] == '$' ? 202 : 80) << line;
}

TEST(LsDyna, WithoutAnAnalysisThereIsNoControl) {
  EXPECT_NE(ls_dyna_deck(test::plate_mesh()).find("*CONTROL_TERMINATION"), std::string::npos);
  const std::string text = ls_dyna_deck(test::plate_mesh(), {.analysis = DeckAnalysis::none});
  EXPECT_EQ(text.find("*CONTROL"), std::string::npos);
  EXPECT_EQ(text.substr(text.size() - 5), "*END\n");
}

}  // namespace
}  // namespace beadmesh
