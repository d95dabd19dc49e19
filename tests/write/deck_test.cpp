#include "beadmesh/write/deck.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <sstream>
#include <utility>

#include "write/bead_plate.h"
#include "write/scratch_folder.h"

namespace beadmesh {
namespace {

using test::plate_mesh;
using test::ScratchFolder;

TEST(Deck, WritesByTheEndingInAnyCase) {
  const ScratchFolder folder;
  const std::pair<const char*, const char*> words[] = {
      {"a.bdf", "CQUAD4"},         {"b.NAS", "CQUAD4"},      {"c.dat", "CQUAD4"},
      {"d.k", "*ELEMENT_SHELL\n"}, {"e.KEY", "*KEYWORD\n"},  {"f.inp", "*ELEMENT, TYPE=S4"},
      {"g.vtu", "<VTKFile"},       {"h.msh", "$Elements\n"}, {"i.stl", "beadmesh"}};
  for (const auto& [name, word] : words) {
    ASSERT_TRUE(write_deck(plate_mesh(), folder / name)) << name;
    std::stringstream text;
    text << std::ifstream(folder / name).rdbuf();
    EXPECT_NE(text.str().find(word), std::string::npos) << name;
  }
}

TEST(Deck, TheHeadOfATextFormatHasTheRemarks) {
  const ScratchFolder folder;
  DeckOptions options;
  options.remarks = {"[bead] max_loops = 2", "two\nlines"};
  for (const char* name : {"a.bdf", "d.k", "f.inp", "g.vtu", "h.msh"}) {
    ASSERT_TRUE(write_deck(plate_mesh(), folder / name, options)) << name;
    std::stringstream text;
    text << std::ifstream(folder / name).rdbuf();
    EXPECT_NE(text.str().find("[bead] max_loops = 2\n"), std::string::npos) << name;
    EXPECT_NE(text.str().find("two?lines\n"), std::string::npos) << name;
  }
}

TEST(Deck, RefusesIdsThatDoNotFitEightColumns) {
  const auto code = [](DeckOptions options) {
    const auto checked = check_deck_mesh(plate_mesh(), options);
    return checked ? std::string("good") : checked.error().code + ": " + checked.error().message;
  };
  // 231 nodes, 200 elements, two parts, sets up to 40001
  EXPECT_EQ(code({99'999'769, 99'999'800, 99'999'998, 99'959'998}), "good");
  EXPECT_EQ(code({99'999'770}), "write.ids: the node ids would be 99999770 to 100000000");
  EXPECT_EQ(code({1, 99'999'801}), "write.ids: the element ids would be 99999801 to 100000000");
  EXPECT_EQ(code({1, 1, 99'999'999}), "write.ids: the property ids would be 99999999 to 100000000");
  EXPECT_EQ(code({1, 1, 1, 99'959'999}), "write.ids: the set ids would be 99960000 to 100000000");
  EXPECT_EQ(code({0}), "write.ids: the node ids would be 0 to 230");
}

TEST(Deck, ListsTheKnownEndingsForAnUnknownOne) {
  const ScratchFolder folder;
  const auto done = write_deck(plate_mesh(), folder / "mesh.xyz");
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, "write.ending");
  EXPECT_NE(done.error().message.find(".xyz"), std::string::npos);
  EXPECT_NE(done.error().hint.find(".bdf"), std::string::npos);
  EXPECT_EQ(folder.count(), 0);
  EXPECT_FALSE(check_deck_ending("mesh"));
}

TEST(Deck, RefusesAMeshThatNoSolverWouldRead) {
  const auto code = [](const ShellMesh& mesh) {
    const auto checked = check_deck_mesh(mesh);
    return checked ? std::string("good") : checked.error().code + " " + checked.error().entity;
  };
  EXPECT_EQ(code(plate_mesh()), "good");
  EXPECT_EQ(code({}), "write.mesh ");
  ShellMesh not_finite = plate_mesh(), no_node = plate_mesh(), no_part = plate_mesh();
  not_finite.nodes[4].y = std::numeric_limits<double>::quiet_NaN();
  no_node.elements[2].nodes[1] = static_cast<Index>(no_node.nodes.size());
  no_part.elements[0].part = 2;
  EXPECT_EQ(code(not_finite), "write.mesh node 5");
  EXPECT_EQ(code(no_node), "write.mesh element 3");
  EXPECT_EQ(code(no_part), "write.mesh element 1");
}

}  // namespace
}  // namespace beadmesh
