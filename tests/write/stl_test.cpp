#include "beadmesh/write/stl.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include "write/bead_plate.h"

namespace beadmesh {
namespace {

std::string stl_file(const ShellMesh& mesh) {
  std::ostringstream out;
  write_stl(mesh, out);
  return out.str();
}

std::vector<float> floats_of(const std::string& file, size_t facet) {
  std::vector<float> values(12);
  std::memcpy(values.data(), file.data() + 84 + 50 * facet, 48);
  return values;
}

TEST(Stl, SplitsQuadsFromTheirFirstCorner) {
  const std::string file = stl_file(test::two_elements());
  ASSERT_EQ(file.size(), 84 + 3 * 50);
  std::uint32_t count = 0;
  std::memcpy(&count, file.data() + 80, 4);
  EXPECT_EQ(count, 3);
  EXPECT_EQ(floats_of(file, 0), (std::vector<float>{0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1, 0}));
  EXPECT_EQ(floats_of(file, 1), (std::vector<float>{0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 1, 0}));
  const auto triangle = floats_of(file, 2);
  EXPECT_EQ((std::vector<float>{triangle.begin() + 3, triangle.end()}),
            (std::vector<float>{1, 0, 0, 2, 0.5, 0.25, 1, 1, 0}));
}

TEST(Stl, TheHeadIsEightyBytesAndDoesNotSaySolid) {
  ShellMesh mesh = test::two_elements();
  mesh.title = std::string(300, 'x');
  const std::string file = stl_file(mesh);
  EXPECT_EQ(file.size(), 84 + 3 * 50);
  EXPECT_EQ(file.rfind("beadmesh ", 0), 0);
}

}  // namespace
}  // namespace beadmesh
