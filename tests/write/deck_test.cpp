#include "beadmesh/write/deck.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <sstream>

#include "write/bead_plate.h"
#include "write/scratch_folder.h"

namespace beadmesh {
namespace {

using test::plate_mesh;
using test::ScratchFolder;

TEST(Deck, WritesByTheEndingInAnyCase) {
  const ScratchFolder folder;
  for (const char* name : {"a.bdf", "b.NAS", "c.dat"}) {
    ASSERT_TRUE(write_deck(plate_mesh(), folder / name)) << name;
    std::stringstream text;
    text << std::ifstream(folder / name).rdbuf();
    EXPECT_NE(text.str().find("CQUAD4"), std::string::npos) << name;
  }
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
