#include "beadmesh/write/gmsh.h"

#include <gtest/gtest.h>

#include <set>
#include <sstream>
#include <string>

#include "write/bead_plate.h"

namespace beadmesh {
namespace {

std::string gmsh_file(const ShellMesh& mesh, const DeckOptions& options = {}) {
  std::ostringstream out;
  write_gmsh(mesh, out, options);
  return out.str();
}

TEST(Gmsh, WritesEntitiesBlocksAndIds) {
  const std::string text = gmsh_file(test::two_elements(), {101, 201, 11, 0});
  EXPECT_NE(text.find("$PhysicalNames\n2\n2 17 \"sheet\"\n2 19 \"flange\"\n$EndPhysicalNames\n"),
            std::string::npos);
  EXPECT_NE(text.find("$Entities\n0 0 2 0\n1 0 0 0 1 1 0 1 17 0\n2 1 0 0 2 1 0.25 1 19 0\n$EndEntities\n"),
            std::string::npos);
  EXPECT_NE(text.find("$Nodes\n2 5 101 105\n2 1 0 4\n101\n102\n103\n104\n0 0 0\n"), std::string::npos);
  EXPECT_NE(text.find("\n2 2 0 1\n105\n2 0.5 0.25\n$EndNodes\n"), std::string::npos);
  EXPECT_NE(text.find("$Elements\n2 2 201 202\n2 1 3 1\n201 101 102 103 104\n2 2 2 1\n202 102 105 103\n"),
            std::string::npos);
}

TEST(Gmsh, CrestAndBoundaryAreCurvesOfLines) {
  const std::string text = gmsh_file(test::plate_mesh());
  EXPECT_NE(text.find("1 20001 \"bead_1_crest\"\n1 30001 \"bead_1_boundary\"\n"), std::string::npos);
  EXPECT_NE(text.find("2 40001 \"bead_1_caps\"\n"), std::string::npos);
  EXPECT_NE(text.find("$Entities\n0 2 3 0\n"), std::string::npos);
  EXPECT_NE(text.find("$Elements\n5 242 1 242\n1 1 1 10\n201 111 112\n202 112 113\n"), std::string::npos);
  EXPECT_NE(text.find("\n1 2 1 32\n"), std::string::npos);
}

TEST(Gmsh, EveryNodeIsWrittenOnce) {
  std::istringstream in(gmsh_file(test::plate_mesh()));
  std::string line;
  while (std::getline(in, line) && line != "$Nodes") {
  }
  int blocks = 0, count = 0, low = 0, high = 0;
  in >> blocks >> count >> low >> high;
  std::set<int> seen;
  for (int b = 0; b < blocks; ++b) {
    int dimension = 0, entity = 0, parametric = 0, nodes = 0, id = 0;
    in >> dimension >> entity >> parametric >> nodes;
    for (int i = 0; i < nodes; ++i) {
      in >> id;
      EXPECT_TRUE(seen.insert(id).second) << id;
    }
    double coordinate = 0;
    for (int i = 0; i < 3 * nodes; ++i) in >> coordinate;
  }
  EXPECT_EQ(count, 21 * 11);
  EXPECT_EQ(seen.size(), 21 * 11);
  EXPECT_EQ(*seen.rbegin(), high);
}

}  // namespace
}  // namespace beadmesh
