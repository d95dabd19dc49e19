#include "beadmesh/read/polygon_reader.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <filesystem>
#include <fstream>

namespace beadmesh {
namespace {

constexpr const char* square_poly = R"(# a square with a square hole
8 2 1 1   # eight vertices, an attribute, a marker
1 0 0 5.5 1
2 9 0 5.5 1

3 9 9 5.5 1
4 0 9 5.5 1
5 3 3 5.5 2
6 6 3 5.5 2
7 6 6 5.5 2
8 3 6 5.5 2
8 1
1 1 2 1
2 3 2 1
3 3 4 1
4 4 1 1
5 5 6 2
6 6 7 2
7 7 8 2
8 8 5 2
1
1 4.5 4.5
)";

void expect_failure(const Result<PlanarRegion>& result, const std::string& code, const std::string& entity) {
  ASSERT_FALSE(result) << code;
  EXPECT_EQ(result.error().code, code) << result.error().message;
  EXPECT_EQ(result.error().entity, entity) << result.error().message;
}

TEST(PolygonReader, wkt_with_a_hole) {
  const auto region = parse_wkt("Polygon ((0 0, 9 0, 9 9,\n 0 9, 0 0),(3 3,6 3,6 6,3 6,3 3))\n");
  ASSERT_TRUE(region) << to_line(region.error());
  ASSERT_EQ(region->loops.size(), 2u);
  EXPECT_EQ(region->loops[0].points.size(), 4u) << "the closing point is dropped";
  EXPECT_DOUBLE_EQ(signed_area(region->loops[0]), 81);
  EXPECT_DOUBLE_EQ(signed_area(region->loops[1]), -9);
}

TEST(PolygonReader, wkt_numbers_and_dimensions) {
  const auto region = parse_wkt("POLYGON Z((-1e-3 +.5 7, 2.5E1 0 7, 1 9 7));");
  ASSERT_TRUE(region) << to_line(region.error());
  EXPECT_EQ(region->loops[0].points[0], (Vec2{-1e-3, 0.5}));
}

TEST(PolygonReader, wkt_syntax) {
  expect_failure(parse_wkt(""), "read.wkt.syntax", "line 1");
  expect_failure(parse_wkt("LINESTRING(0 0, 1 1)"), "read.wkt.syntax", "line 1");
  expect_failure(parse_wkt("POLYGON EMPTY"), "read.wkt.syntax", "line 1");
  expect_failure(parse_wkt("POLYGON((0 0,\n1 0,\n1 x,0 0))"), "read.wkt.syntax", "line 3");
  expect_failure(parse_wkt("POLYGON((0 0,1 0,1))"), "read.wkt.syntax", "line 1");
  expect_failure(parse_wkt("POLYGON((0 0,1 0,1 1)"), "read.wkt.syntax", "line 1");
  expect_failure(parse_wkt("POLYGON((0 0,1 0,1 1"), "read.wkt.syntax", "line 1");
  expect_failure(parse_wkt("POLYGON((0 0,1 0,1 1)) POLYGON"), "read.wkt.syntax", "line 1");
  expect_failure(parse_wkt("POLYGON((0 0,1 0 0 0 0,1 1))"), "read.wkt.syntax", "line 1");
}

TEST(PolygonReader, wkt_dialects) {
  const std::string ring = "((0 0, 9 0, 9 9, 0 0))", ring_z = "((0 0 5, 9 0 5, 9 9 5, 0 0 5))";
  for (const std::string& text : std::initializer_list<std::string>{
           "POLYGON" + ring, "\xEF\xBB\xBFPOLYGON" + ring, "SRID=4326;POLYGON" + ring,
           "MULTIPOLYGON(" + ring + ")", "POLYGON Z" + ring_z, "PolygonM" + ring_z, "POLYGON" + ring_z,
           "POLYGON ZM((0 0 1 1,9 0 1 1,9 9 1 1))"}) {
    const auto region = parse_wkt(text);
    ASSERT_TRUE(region) << text << ": " << to_line(region.error());
    EXPECT_EQ(region->loops[0].points.size(), 3u) << text;
  }
}

void expect_message(const std::string& text, const std::string& part) {
  const auto region = parse_wkt(text);
  ASSERT_FALSE(region) << text;
  EXPECT_EQ(region.error().code, "read.wkt.syntax") << to_line(region.error());
  EXPECT_NE(region.error().message.find(part), std::string::npos) << to_line(region.error());
}

TEST(PolygonReader, wkt_errors_name_loop_and_point) {
  expect_message("POLYGON((0 0,1 0,1 1),(0 0,\n1 1,x 1))", "point 3 of loop 2: 'x' is no number");
  expect_message("POLYGON((0 0,1 0,1e999 1))", "point 3 of loop 1: '1e999' is too large or too small");
  expect_message(std::string("POLYGON((0 0,1\0\n 0,1 1))", 24), "point 2 of loop 1: '1?' is no number");
  expect_message("POLYGON((0 0,1 0,1))", "point 3 of loop 1: two coordinates expected");
  expect_message("POLYGON((0 0 1,1 0,1 1 2))", "point 2 of loop 1: 2 coordinates, but 3");
  expect_message("POLYGON Z((0 0,1 0,1 1))", "point 1 of loop 1: 2 coordinates, but 3");
  expect_message("POLYGON((0,0 0,0))", "point 1 of loop 1");
  expect_message("POLYGON((0 0,1 0,1 1),())", "point 1 of loop 2");
  expect_message("POLYGON((0 0,1 0,1 1),EMPTY)", "loop 2 is empty");
  expect_message("POLYGON((0 0,1 0,1 1),(0 0", "after point 1 of loop 2");
  expect_message("LINESTRING(0 0,1 1)", "POLYGON expected, not 'LINESTRING'");
  expect_message("MULTIPOLYGON(((0 0,1 0,1 1)),((5 0,6 0,6 1)))", "several polygons");
  expect_message("MULTIPOLYGON(((0 0,1 0,1 1))", "')' expected");
  expect_message("POLYGON((0 0,1 0,1 1)) POLYGON((5 0,6 0,6 1))", "a file holds one polygon");
}

TEST(PolygonReader, poly_errors_name_the_vertices_of_the_file) {
  // Vertices in another order than along the loop: 1 4 2 3, which crosses itself.
  const std::string vertices = "4 2\n1 0 0\n2 9 0\n3 0 9\n4 9 9\n";
  const auto crossing = parse_poly(vertices + "4\n1 1 4\n2 4 2\n3 2 3\n4 3 1\n0\n");
  ASSERT_FALSE(crossing);
  EXPECT_EQ(crossing.error().code, "delaunay.region.crossing");
  for (const char* name : {"vertex 1 (0, 0)", "vertex 4 (9, 9)", "vertex 2 (9, 0)", "vertex 3 (0, 9)"})
    EXPECT_NE(crossing.error().message.find(name), std::string::npos) << crossing.error().message;
  const auto missing = parse_poly("3 2\n1 0 0\n2 4 1e999\n3 0 3\n");
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().message.find("'1e999' is too large"), std::string::npos)
      << missing.error().message;
  const auto bare = parse_poly("3 2\n1 0 0\n2 4 1\n3 0 3\n0\n0\n");
  ASSERT_FALSE(bare);
  EXPECT_EQ(bare.error().message, "there are no segments");
}

TEST(PolygonReader, faults_of_the_region_are_passed_on) {
  expect_failure(parse_wkt("POLYGON((0 0,2 2,2 0,0 3))"), "delaunay.region.crossing", "loop 1");
  expect_failure(parse_wkt("POLYGON((0 0,2 2,nan 0,0 3))"), "delaunay.region.not_finite", "loop 1");
  expect_failure(parse_wkt("POLYGON((0 0,1 0,1 1),(5 5,6 5,6 6))"), "delaunay.region.outside", "loop 2");
}

TEST(PolygonReader, poly_with_a_hole) {
  const auto region = parse_poly(square_poly);
  ASSERT_TRUE(region) << to_line(region.error());
  ASSERT_EQ(region->loops.size(), 2u);
  EXPECT_DOUBLE_EQ(signed_area(region->loops[0]), 81);
  EXPECT_DOUBLE_EQ(signed_area(region->loops[1]), -9);
}

TEST(PolygonReader, poly_counted_from_zero) {
  const auto region =
      parse_poly("4 2\r\n0 0 0\r\n1 4 0\r\n2 0 3\r\n3 1 1\r\n3\r\n0 0 1\r\n1 2 0\r\n2 1 2\r\n0\r\n");
  ASSERT_TRUE(region) << to_line(region.error());
  EXPECT_DOUBLE_EQ(signed_area(region->loops[0]), 6) << "vertex 3 belongs to no segment";
}

TEST(PolygonReader, poly_syntax) {
  const std::string vertices = "3 2\n1 0 0\n2 4 0\n3 0 3\n";
  expect_failure(parse_poly(""), "read.poly.syntax", "line 1");
  expect_failure(parse_poly("three"), "read.poly.syntax", "line 1");
  expect_failure(parse_poly("0 2 0 0\n"), "read.poly.syntax", "line 1");
  expect_failure(parse_poly("3 3\n1 0 0\n2 4 0\n3 0 3\n"), "read.poly.syntax", "line 1");
  expect_failure(parse_poly("3 2\n1 0 0\n2 4\n3 0 3\n"), "read.poly.syntax", "line 3");
  expect_failure(parse_poly("3 2\n1 0 0\n3 4 0\n4 0 3\n"), "read.poly.syntax", "line 3");
  expect_failure(parse_poly("2000000000 2\n1 0 0\n"), "read.poly.syntax", "line 2");
  expect_failure(parse_poly(vertices), "read.poly.syntax", "line 4");
  expect_failure(parse_poly(vertices + "1\n1 1\n"), "read.poly.syntax", "line 6");
  expect_failure(parse_poly(vertices + "1\n1 1 4\n"), "read.poly.syntax", "line 6");
  expect_failure(parse_poly(vertices + "3\n1 1 2\n2 2 3\n3 3 1\n"), "read.poly.syntax", "line 8");
}

TEST(PolygonReader, poly_segments_that_are_no_loops) {
  const std::string vertices = "3 2\n1 0 0\n2 4 0\n3 0 3\n";
  expect_failure(parse_poly(vertices + "2\n1 1 2\n2 2 3\n0\n"), "read.poly.loop", "line 2");
  expect_failure(parse_poly(vertices + "2\n1 1 2\n2 2 1\n0\n"), "read.poly.loop", "line 7");
  expect_failure(parse_poly(vertices + "1\n1 2 2\n0\n"), "read.poly.loop", "line 6");
  expect_failure(parse_poly("4 2\n1 0 0\n2 4 0\n3 0 3\n4 9 9\n4\n1 1 2\n2 2 3\n3 3 1\n4 1 4\n0\n"),
                 "read.poly.loop", "line 10");
}

TEST(PolygonReader, files_by_their_ending) {
  const auto folder = std::filesystem::temp_directory_path() / "beadmesh_polygon_reader_test";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "a.POLY") << square_poly;
  std::ofstream(folder / "b.wkt") << "POLYGON((0 0,1 0,0 x))";
  std::ofstream(folder / "empty.wkt") << "\n ";
  EXPECT_TRUE(read_polygon(folder / "a.POLY"));
  expect_failure(read_polygon(folder / "b.wkt"), "read.wkt.syntax", "b.wkt, line 1");
  const auto code = [&](const char* name) { return read_polygon(folder / name).error().code; };
  EXPECT_EQ(code("empty.wkt"), "read.empty");
  EXPECT_EQ(code("missing.wkt"), "read.not_found");
  EXPECT_EQ(code("a.txt"), "read.ending");
  std::filesystem::create_directories(folder / "folder.wkt");
  EXPECT_EQ(code("folder.wkt"), "read.directory");
  std::filesystem::remove_all(folder);
}

// A part of a good text with one character changed: an error or a region, never anything else.
RC_GTEST_PROP(PolygonReader, spoilt_texts_never_crash, ()) {
  const bool poly = *rc::gen::arbitrary<bool>();
  std::string text = poly ? square_poly : "POLYGON((0 0, 9 0, 9 9, 0 9, 0 0),(3 3,6 3,6 6,3 6,3 3))";
  text[*rc::gen::inRange<std::size_t>(0, text.size())] = *rc::gen::elementOf(std::string("0159 .-e\n#(),"));
  text.resize(*rc::gen::inRange<std::size_t>(0, text.size() + 1));
  const auto region = poly ? parse_poly(text) : parse_wkt(text);
  RC_ASSERT(region.has_value() || !region.error().message.empty());
}

}  // namespace
}  // namespace beadmesh
