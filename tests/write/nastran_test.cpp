#include "beadmesh/write/nastran.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "write/bead_plate.h"

namespace beadmesh {
namespace {

using test::plate_mesh;

std::string nastran_deck(const ShellMesh& mesh, const DeckOptions& options = {}) {
  std::ostringstream out;
  write_nastran(mesh, out, options);
  return out.str();
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::vector<std::string> lines_with(const std::string& text, const std::string& start) {
  std::vector<std::string> found;
  for (const std::string& line : lines_of(text))
    if (line.rfind(start, 0) == 0) found.push_back(line);
  return found;
}

/// Coordinates as a solver reads them: columns 41-56 and 57-72, then 9-24 of the continuation.
std::vector<Vec3> nodes_of(const std::string& text) {
  std::vector<Vec3> nodes;
  const auto lines = lines_of(text);
  for (size_t i = 0; i + 1 < lines.size(); ++i)
    if (lines[i].rfind("GRID*", 0) == 0)
      nodes.push_back({std::stod(lines[i].substr(40, 16)), std::stod(lines[i].substr(56, 16)),
                       std::stod(lines[i + 1].substr(8, 16))});
  return nodes;
}

/// Members of SET `id`, with THRU spelled out.
std::set<int> members_of_set(const std::string& text, int id) {
  const auto lines = lines_of(text);
  std::set<int> members;
  for (size_t i = 0; i < lines.size(); ++i) {
    const std::string head = "SET " + std::to_string(id) + " =";
    if (lines[i].rfind(head, 0) != 0) continue;
    std::string list = lines[i].substr(head.size());
    while (list.back() == ',') list += lines[++i];
    std::istringstream in(list);
    for (std::string item; std::getline(in, item, ',');) {
      int first = 0, last = 0;
      std::string thru;
      std::istringstream words(item);
      words >> first;
      if (!(words >> thru >> last)) last = first;
      for (int k = first; k <= last; ++k) members.insert(k);
    }
  }
  return members;
}

TEST(Nastran, HasTheSectionsOfADeckInOrder) {
  const std::string text = nastran_deck(plate_mesh());
  size_t last = 0;
  for (const char* word : {"SOL 103\n", "CEND\n", "TITLE = ", "METHOD = 1\n", "SET 10001 = ", "BEGIN BULK\n",
                           "EIGRL ", "MAT1 ", "PSHELL ", "GRID*", "CQUAD4", "ENDDATA\n"}) {
    const size_t at = text.find(word, last);
    ASSERT_NE(at, std::string::npos) << word;
    last = at;
  }
}

TEST(Nastran, WritesEveryNodeElementAndProperty) {
  const ShellMesh mesh = plate_mesh();
  const std::string text = nastran_deck(mesh);
  EXPECT_EQ(nodes_of(text).size(), mesh.nodes.size());
  const auto quads = lines_with(text, "CQUAD4");
  ASSERT_EQ(quads.size(), mesh.elements.size());
  EXPECT_EQ(quads[0], "CQUAD4         1       1       1       2      23      22");
  const auto properties = lines_with(text, "PSHELL");
  ASSERT_EQ(properties.size(), 2);
  EXPECT_EQ(properties[1], "PSHELL         2       1     0.8       1               1");
}

TEST(Nastran, WritesTrianglesAsSuch) {
  ShellMesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.parts = {{7, "sheet", 1}};
  mesh.elements = {{{0, 1, 2, no_index}, 0, 1, 0}};
  EXPECT_EQ(lines_with(nastran_deck(mesh), "CTRIA3")[0], "CTRIA3         1       7       1       2       3");
}

TEST(Nastran, KeepsEightyColumnsAndSetsSeventyTwo) {
  ShellMesh mesh = plate_mesh();
  mesh.title = std::string(300, 'x') + "\nGRID,1";
  bool in_bulk = false;
  for (const std::string& line : lines_of(nastran_deck(mesh))) {
    if (line[0] == '$') continue;
    in_bulk |= line == "BEGIN BULK";
    EXPECT_LE(line.size(), in_bulk ? 80 : 72) << line;
  }
}

TEST(Nastran, SetsHoldTheElementsAndCrestNodesOfTheBead) {
  const ShellMesh mesh = plate_mesh();
  const std::string text = nastran_deck(mesh);
  const auto ids = [](const std::vector<Index>& indices) {
    std::set<int> result;
    for (const Index index : indices) result.insert(index + 1);
    return result;
  };
  EXPECT_EQ(members_of_set(text, 10001), ids(mesh.beads[0].elements));
  EXPECT_EQ(members_of_set(text, 20001), ids(mesh.beads[0].crest_nodes));
}

TEST(Nastran, SetsHoldTheBoundaryAndTheCaps) {
  const ShellMesh mesh = plate_mesh();
  const std::string text = nastran_deck(mesh);
  EXPECT_EQ(members_of_set(text, 30001).size(), 2 * (12 + 4));
  EXPECT_EQ(members_of_set(text, 40001), (std::set<int>{65, 76, 85, 96, 105, 116, 125, 136}));
}

TEST(Nastran, IdsCountFromTheFirst) {
  const std::string text = nastran_deck(test::two_elements(), {101, 201, 11, 5000});
  EXPECT_EQ(lines_with(text, "CQUAD4")[0], "CQUAD4       201      17     101     102     103     104");
  EXPECT_EQ(lines_with(text, "CTRIA3")[0], "CTRIA3       202      19     102     105     103");
  EXPECT_EQ(lines_with(text, "PSHELL")[0], "PSHELL        17      11    1.25      11              11");
  EXPECT_EQ(lines_with(text, "MAT1")[0].substr(0, 16), "MAT1          11");
  EXPECT_EQ(lines_with(text, "GRID*")[0].substr(0, 24), "GRID*                101");
  EXPECT_EQ(members_of_set(nastran_deck(plate_mesh(), {1, 201, 1, 5000}), 45001).count(265), 1);
}

TEST(Nastran, SetIdsStayApartForManyBeads) {
  ShellMesh mesh = plate_mesh();
  mesh.beads = {{1, "I", "I", {0}, {0}}, {10'000, "I", "I", {1}, {1}}};
  const std::string text = nastran_deck(mesh);
  EXPECT_EQ(members_of_set(text, 100001), std::set<int>{1});
  EXPECT_EQ(members_of_set(text, 110000), std::set<int>{2});
  EXPECT_EQ(members_of_set(text, 210000), std::set<int>{2});
}

RC_GTEST_PROP(Nastran, SetsSayWhatTheyWereGiven, ()) {
  const auto chosen = *rc::gen::container<std::set<int>>(rc::gen::inRange(0, 200));
  ShellMesh mesh = plate_mesh();
  mesh.beads = {{1, "I", "I", {chosen.begin(), chosen.end()}, {}}};
  std::set<int> ids;
  for (const int index : chosen) ids.insert(index + 1);
  RC_ASSERT(members_of_set(nastran_deck(mesh), 10001) == ids);
}

RC_GTEST_PROP(Nastran, ATenthOfAMicrometreSurvivesFarFromTheOrigin, ()) {
  const auto coordinate = [] { return *rc::gen::inRange<long>(-1'000'000'000, 1'000'000'000) * 1e-4; };
  ShellMesh mesh;
  mesh.parts = {{1, "sheet", 1}};
  mesh.nodes = {{coordinate(), coordinate(), coordinate()}};
  const Vec3 read = nodes_of(nastran_deck(mesh)).at(0);
  RC_ASSERT(distance(read, mesh.nodes[0]) < 1e-7);
}

TEST(Nastran, LongCoordinatesFitTheirField) {
  ShellMesh mesh;
  mesh.parts = {{1, "sheet", 1}};
  mesh.nodes = {{-99'999.999999999, -9'999'999.9999999, -1.23456789e200}, {-0.0, -1e-12, 1e-300}};
  const auto read = nodes_of(nastran_deck(mesh));
  EXPECT_DOUBLE_EQ(read.at(0).x, -100'000);
  EXPECT_DOUBLE_EQ(read.at(0).y, -10'000'000);
  EXPECT_NEAR(read.at(0).z / -1.23456789e200, 1, 1e-8);
  EXPECT_EQ(nastran_deck(mesh).find("-0.0"), std::string::npos);
}

TEST(Nastran, ThicknessFitsItsFieldAndHasAPoint) {
  const auto field = [](double thickness) {
    ShellMesh mesh;
    mesh.parts = {{1, "sheet", thickness}};
    return lines_with(nastran_deck(mesh), "PSHELL").at(0).substr(24, 8);
  };
  EXPECT_EQ(field(1), "      1.");
  EXPECT_EQ(field(0.75), "    0.75");
  EXPECT_EQ(field(1.0 / 3), "0.333333");
  EXPECT_EQ(field(1e-5), "  1.e-05");
  EXPECT_EQ(field(1.23456789e-5), "1.23e-05");
}

}  // namespace
}  // namespace beadmesh
