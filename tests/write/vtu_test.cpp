#include "beadmesh/write/vtu.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include "write/bead_plate.h"

namespace beadmesh {
namespace {

std::string vtu_file(const ShellMesh& mesh, const DeckOptions& options = {}) {
  std::ostringstream out;
  write_vtu(mesh, out, options);
  return out.str();
}

std::vector<unsigned char> decoded(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes;
  unsigned bits = 0;
  int count = 0;
  for (const char c : text) {
    if (c == '=') break;
    bits = bits << 6 | unsigned(digits.find(c));
    count += 6;
    if (count >= 8) bytes.push_back(static_cast<unsigned char>(bits >> (count -= 8)));
  }
  return bytes;
}

/// The values of an array; its length must be what its head says.
template <class Value>
std::vector<Value> array_of(const std::string& text, const std::string& name) {
  const size_t at = text.find("Name=\"" + name + "\""), start = text.find(">\n", at) + 2;
  const auto bytes = decoded(text.substr(start, text.find('\n', start) - start));
  std::uint64_t size = 0;
  std::memcpy(&size, bytes.data(), sizeof(size));
  EXPECT_EQ(size + sizeof(size), bytes.size()) << name;
  std::vector<Value> values(size / sizeof(Value));
  std::memcpy(values.data(), bytes.data() + sizeof(size), size);
  return values;
}

TEST(Vtu, HoldsPointsAndCells) {
  const std::string text = vtu_file(test::two_elements());
  EXPECT_NE(text.find("NumberOfPoints=\"5\" NumberOfCells=\"2\""), std::string::npos);
  EXPECT_EQ(array_of<double>(text, "Points"),
            (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0.5, 0.25}));
  EXPECT_EQ(array_of<std::int64_t>(text, "connectivity"), (std::vector<std::int64_t>{0, 1, 2, 3, 1, 4, 2}));
  EXPECT_EQ(array_of<std::int64_t>(text, "offsets"), (std::vector<std::int64_t>{4, 7}));
  EXPECT_EQ(array_of<unsigned char>(text, "types"), (std::vector<unsigned char>{9, 5}));
}

TEST(Vtu, CellsCarryPartsAndQuality) {
  const std::string text = vtu_file(test::two_elements(), {101, 201, 11, 0});
  EXPECT_EQ(array_of<std::int32_t>(text, "part"), (std::vector<std::int32_t>{17, 19}));
  EXPECT_EQ(array_of<double>(text, "thickness"), (std::vector<double>{1.25, 0.8}));
  EXPECT_EQ(array_of<std::int32_t>(text, "face"), (std::vector<std::int32_t>{1, 2}));
  EXPECT_EQ(array_of<double>(text, "scaled_jacobian")[0], 1);
  EXPECT_EQ(array_of<double>(text, "shortest_edge"), (std::vector<double>{1, 1}));
  EXPECT_EQ(array_of<double>(text, "warpage"), (std::vector<double>{0, 0}));
}

TEST(Vtu, MarksBeadsCrestAndCaps) {
  const ShellMesh mesh = test::plate_mesh();
  const std::string text = vtu_file(mesh);
  const auto crest = array_of<std::int32_t>(text, "crest"),
             boundary = array_of<std::int32_t>(text, "boundary");
  const auto kind = array_of<std::int32_t>(text, "kind"), bead = array_of<std::int32_t>(text, "bead");
  const auto cap = array_of<unsigned char>(text, "cap");
  for (Index node = 0; node < Index(mesh.nodes.size()); ++node) {
    EXPECT_EQ(crest[node],
              std::count(mesh.beads[0].crest_nodes.begin(), mesh.beads[0].crest_nodes.end(), node));
    EXPECT_EQ(boundary[node],
              std::count(mesh.beads[0].boundary_nodes.begin(), mesh.beads[0].boundary_nodes.end(), node));
  }
  EXPECT_EQ(kind, bead);  // an I-bead with the number 1
  EXPECT_EQ(std::count(kind.begin(), kind.end(), 1), 48);
  EXPECT_EQ(std::count(cap.begin(), cap.end(), 1), 8);
}

TEST(Vtu, ATitleDoesNotEndItsComment) {
  ShellMesh mesh = test::two_elements();
  mesh.title = "a --> b ----- c";
  const std::string text = vtu_file(mesh);
  EXPECT_EQ(text.find("--", text.find("<!--") + 4), text.find("-->"));
  EXPECT_EQ(text.substr(text.find("-->"), 12), "-->\n<VTKFile");
}

}  // namespace
}  // namespace beadmesh
