#include "beadmesh/read/panel_reader.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>

#include "beadmesh/panel/chain.h"
#include "read/cad_shapes.h"

namespace beadmesh {
namespace {

using test::TemporaryFolder;

Panel read_back(const TopoDS_Shape& shape, const std::string& name) {
  const TemporaryFolder folder;
  test::write_shape(shape, folder / name);
  Result<Panel> panel = read_panel(folder / name);
  EXPECT_TRUE(panel.has_value()) << (panel ? "" : to_line(panel.error()));
  if (!panel) return {};
  EXPECT_EQ(verify_panel(*panel), std::vector<std::string>{}) << name;
  return *panel;
}

std::string failure_of(const std::filesystem::path& path, const ReadOptions& options = {}) {
  const Result<Panel> panel = read_panel(path, options);
  return panel ? "none" : panel.error().code;
}

int uses(const Panel& panel, std::size_t count) {
  int n = 0;
  for (const PanelEdge& edge : panel.edges) n += edge.faces.size() == count ? 1 : 0;
  return n;
}

double total_area(const Panel& panel) {
  double sum = 0;
  for (const PanelFace& face : panel.faces) sum += area(face.facets);
  return sum;
}

double largest_gap(const Panel& panel) {
  double gap = 0;
  for (const PanelFace& face : panel.faces)
    for (std::size_t t = 0; t < face.facets.triangles.size(); ++t) {
      const auto& uv = face.facets.triangle_uv[t];
      const Vec3 on_surface = face.facets.surfaces.back()->point((uv[0] + uv[1] + uv[2]) / 3);
      Vec3 middle;
      for (const Index v : face.facets.triangles[t]) middle += face.facets.points[v] / 3;
      gap = std::max(gap, distance(middle, on_surface));
    }
  return gap;
}

class EveryFormat : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(, EveryFormat, testing::Values("part.step", "part.igs", "part.brep"));

TEST_P(EveryFormat, BoxIsClosedAndOutward) {
  const Panel panel = read_back(test::box(30, 20, 10), GetParam());
  EXPECT_EQ(panel.faces.size(), 6u);
  EXPECT_EQ(uses(panel, 2), 12);
  EXPECT_EQ(uses(panel, 1), 0);
  EXPECT_NEAR(total_area(panel), 2 * (600 + 300 + 200), 1e-6);
  Vec3 sum;
  for (const PanelFace& face : panel.faces) sum += vector_area(face.facets);
  EXPECT_NEAR(norm(sum), 0, 1e-6);
  EXPECT_EQ(chains_of(panel).chains.size(), 12u);
}

TEST_P(EveryFormat, CylinderKeepsItsSeam) {
  const Panel panel = read_back(test::cylinder(8, 20), GetParam());
  ASSERT_EQ(panel.faces.size(), 3u);
  EXPECT_EQ(uses(panel, 1), 0);
  EXPECT_NEAR(total_area(panel), 2 * pi * 8 * 20 + 2 * pi * 64, 10);
  EXPECT_LT(largest_gap(panel), 2 * ReadOptions().chord);
  int seams = 0;
  for (const Chain& chain : chains_of(panel).chains) seams += chain.faces[0] == chain.faces[1] ? 1 : 0;
  EXPECT_EQ(seams, 1);
}

TEST_P(EveryFormat, PlateWithHoleHasTwoLoops) {
  const Panel panel = read_back(test::plate_with_hole(), GetParam());
  ASSERT_EQ(panel.faces.size(), 1u);
  EXPECT_EQ(panel.faces[0].number, 1);
  ASSERT_EQ(panel.faces[0].loops.size(), 2u);
  EXPECT_EQ(panel.faces[0].loops[0].size(), 4u);
  EXPECT_NEAR(total_area(panel), 6000 - pi * 100, 3);
}

TEST_P(EveryFormat, AHoleSmallerThanTheFacetsStaysAHole) {
  const Panel panel = read_back(test::plate_with_hole(0.2, 2), GetParam());
  ASSERT_EQ(panel.faces.size(), 1u);
  ASSERT_EQ(panel.faces[0].loops.size(), 2u);
  EXPECT_GE(panel.faces[0].facets.loops[1].size(), 6u);
  EXPECT_NEAR(total_area(panel), 6000 - pi * 0.04, 0.03);
}

TEST_P(EveryFormat, SphereConeAndTorusHaveNoHoles) {
  EXPECT_NEAR(total_area(read_back(test::sphere(10), GetParam())), 4 * pi * 100, 20);
  EXPECT_NEAR(total_area(read_back(test::cone(10, 20), GetParam())), pi * 10 * std::sqrt(500.0) + pi * 100,
              12);
  EXPECT_NEAR(total_area(read_back(test::torus(20, 5), GetParam())), 4 * pi * pi * 100, 40);
}

TEST_P(EveryFormat, LooseSquaresAreSewnAndOriented) {
  const Panel panel = read_back(test::two_loose_squares(), GetParam());
  ASSERT_EQ(panel.faces.size(), 2u);
  EXPECT_EQ(uses(panel, 2), 1);
  EXPECT_NEAR(dot(vector_area(panel.faces[0].facets), vector_area(panel.faces[1].facets)), 10000, 1e-6);
}

TEST_P(EveryFormat, EvaluatorsAgreeWithTheFacets) {
  const Panel panel = read_back(test::dome(), GetParam());
  ASSERT_EQ(panel.faces.size(), 1u);
  const Facets& facets = panel.faces[0].facets;
  ASSERT_EQ(facets.triangle_uv.size(), facets.triangles.size());
  for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
    const Vec3 a = facets.points[facets.triangles[t][0]], b = facets.points[facets.triangles[t][1]],
               c = facets.points[facets.triangles[t][2]];
    EXPECT_LT(distance(facets.surfaces[0]->point(facets.triangle_uv[t][0]), a), 1e-4);
    EXPECT_GT(dot(facets.surfaces[0]->normal(facets.triangle_uv[t][0]), normalized(cross(b - a, c - a))),
              0.9);
  }
  EXPECT_LT(largest_gap(panel), 2 * ReadOptions().chord);
}

TEST_P(EveryFormat, ALoopThatCrossesItselfIsRefused) {
  const TemporaryFolder folder;
  test::write_shape(test::bow_tie(), folder / GetParam());
  const Result<Panel> panel = read_panel(folder / GetParam());
  ASSERT_FALSE(panel.has_value());
  EXPECT_EQ(panel.error().code, "read.face.loop_crosses");
  EXPECT_EQ(panel.error().face, 1);
}

TEST_P(EveryFormat, AFileCutShortIsRefused) {
  const TemporaryFolder folder;
  test::write_shape(test::plate_with_hole(), folder / GetParam());
  const std::string whole = test::read_text(folder / GetParam());
  for (const double part : {0.2, 0.5, 0.8, 0.95}) {
    test::write_text(folder / GetParam(), whole.substr(0, static_cast<std::size_t>(whole.size() * part)));
    const std::string code = failure_of(folder / GetParam());
    EXPECT_TRUE(code == "read.truncated" || code == "read.unreadable") << part << " " << code;
  }
}

TEST_P(EveryFormat, SameFileSameBits) {
  const TemporaryFolder folder;
  test::write_shape(test::dome(), folder / GetParam());
  Context one, two;
  one.jobs = 1;
  two.jobs = 2;
  const Result<Panel> a = read_panel(folder / GetParam(), {}, one),
                      b = read_panel(folder / GetParam(), {}, two);
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->points, b->points);
  EXPECT_EQ(a->faces[0].facets.triangles, b->faces[0].facets.triangles);
}

TEST(ReadPanel, FacetsAreWellShaped) {
  const Panel panel = read_back(test::dome(), "dome.step");
  double least = pi;
  const Facets& f = panel.faces[0].facets;
  for (const Triangle& t : f.triangles)
    for (int k = 0; k < 3; ++k)
      least = std::min(least, angle_between(f.points[t[(k + 1) % 3]] - f.points[t[k]],
                                            f.points[t[(k + 2) % 3]] - f.points[t[k]]));
  EXPECT_GT(degrees(least), 15);
}

TEST(ReadPanel, LocationsAreApplied) {
  const Panel panel = read_back(test::two_places(), "two.brep");
  ASSERT_EQ(panel.faces.size(), 2u);
  EXPECT_NEAR(diagonal(panel), std::hypot(200, 60), 1e-9);
  EXPECT_NEAR(panel.faces[1].facets.surfaces[0]->point({0, 0}).x, 100, 1e-9);
}

TEST(ReadPanel, UnitsOfTheFileBecomeMillimetres) {
  const TemporaryFolder folder;
  test::write_shape(test::box(3, 4, 12), folder / "metres.step");
  std::string text = test::read_text(folder / "metres.step");
  const std::size_t at = text.find(".MILLI.,.METRE.");
  ASSERT_NE(at, std::string::npos);
  test::write_text(folder / "metres.step", text.replace(at, 7, "$"));
  EXPECT_NEAR(diagonal(*read_panel(folder / "metres.step")), 13000, 1e-6);
  test::write_shape(test::box(3, 4, 12), folder / "inch.brep");
  ReadOptions options;
  options.unit = "in";
  EXPECT_NEAR(diagonal(*read_panel(folder / "inch.brep", options)), 13 * 25.4, 1e-9);
  options.unit = "furlong";
  EXPECT_EQ(failure_of(folder / "inch.brep", options), "read.unit");
}

TEST(ReadPanel, SewingCanBeTurnedOff) {
  const TemporaryFolder folder;
  test::write_shape(test::two_loose_squares(), folder / "two.brep");
  ReadOptions options;
  options.sew_tolerance = 0;
  EXPECT_EQ(uses(*read_panel(folder / "two.brep", options), 1), 8);
}

TEST(ReadPanel, SaysWhatIsWrongWithTheFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(failure_of(folder / "none.step"), "read.not_found");
  std::filesystem::create_directory(folder / "folder.step");
  EXPECT_EQ(failure_of(folder / "folder.step"), "read.directory");
  test::write_text(folder / "empty.step", "");
  EXPECT_EQ(failure_of(folder / "empty.step"), "read.empty");
  test::write_text(folder / "panel.docx", "x");
  EXPECT_EQ(failure_of(folder / "panel.docx"), "read.ending");
  test::write_text(folder / "text.brep", "no shape at all");
  EXPECT_EQ(failure_of(folder / "text.brep"), "read.unreadable");
  test::write_text(
      folder / "bare.step",
      "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
      "FILE_SCHEMA(('AUTOMOTIVE_DESIGN'));\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n");
  EXPECT_EQ(failure_of(folder / "bare.step"), "read.no_faces");
}

TEST(ReadPanel, AStepEntityThatRefersToNothingIsNamed) {
  const TemporaryFolder folder;
  test::write_shape(test::box(1, 2, 3), folder / "box.step");
  std::string text = test::read_text(folder / "box.step");
  const std::size_t at = text.find("CARTESIAN_POINT('',(0.,0.,0.)");
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 15, "CARTESIAN_PXINT");
  test::write_text(folder / "box.step", text);
  EXPECT_EQ(failure_of(folder / "box.step"), "read.unreadable");
}

std::string ascii_facet(Vec3 a, Vec3 b, Vec3 c) {
  std::string text = "facet normal 0 0 0\nouter loop\n";
  for (const Vec3 p : {a, b, c})
    text += "vertex " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) + "\n";
  return text + "endloop\nendfacet\n";
}

/// The unit cube, its sides turned at random.
std::string ascii_cube() {
  const std::array<std::array<Vec3, 4>, 6> sides{{{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}},
                                                  {{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}},
                                                  {{{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}},
                                                  {{{0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}}},
                                                  {{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}},
                                                  {{{1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {1, 0, 1}}}}};
  std::string text = "solid cube\n";
  for (const auto& s : sides) text += ascii_facet(s[0], s[1], s[2]) + ascii_facet(s[0], s[2], s[3]);
  return text + "endsolid cube\n";
}

std::string binary_stl(const std::vector<std::array<Vec3, 3>>& facets) {
  std::string bytes("solid but binary");
  bytes.resize(80, ' ');
  const auto put = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  put(static_cast<std::uint32_t>(facets.size()));
  for (const auto& corners : facets) {
    bytes.append(12, '\0');
    for (const Vec3 p : corners)
      for (const double x : {p.x, p.y, p.z}) put(static_cast<float>(x));
    bytes.append(2, '\0');
  }
  return bytes;
}

std::vector<std::array<Vec3, 3>> tube(int n) {
  std::vector<std::array<Vec3, 3>> facets;
  const auto at = [&](int i, double z) {
    return Vec3{10 * std::cos(2 * pi * (i % n) / n), 10 * std::sin(2 * pi * (i % n) / n), z};
  };
  for (int i = 0; i < n; ++i) {
    facets.push_back({at(i, 0), at(i + 1, 0), at(i + 1, 5)});
    facets.push_back({at(i, 0), at(i + 1, 5), at(i, 5)});
  }
  return facets;
}

TEST(ReadStl, CubeHasSixFacesAndTwelveEdges) {
  const TemporaryFolder folder;
  test::write_text(folder / "cube.stl", ascii_cube());
  const Result<Panel> panel = read_panel(folder / "cube.stl");
  ASSERT_TRUE(panel.has_value());
  EXPECT_EQ(verify_panel(*panel), std::vector<std::string>{});
  EXPECT_EQ(panel->points.size(), 8u);
  EXPECT_EQ(panel->faces.size(), 6u);
  EXPECT_EQ(uses(*panel, 2), 12);
  EXPECT_EQ(panel->edges.size(), 12u);
}

TEST(ReadStl, BinaryTubeIsOneFaceWithTwoClosedEdges) {
  const TemporaryFolder folder;
  test::write_text(folder / "tube.stl", binary_stl(tube(24)));
  const Result<Panel> panel = read_panel(folder / "tube.stl");
  ASSERT_TRUE(panel.has_value());
  EXPECT_EQ(verify_panel(*panel), std::vector<std::string>{});
  EXPECT_EQ(panel->faces.size(), 1u);
  EXPECT_EQ(panel->edges.size(), 2u);
  EXPECT_EQ(panel->points.size(), 48u);
}

TEST(ReadStl, FeatureAngleSplitsTheTube) {
  const TemporaryFolder folder;
  test::write_text(folder / "tube.stl", binary_stl(tube(24)));
  ReadOptions options;
  options.feature_angle = radians(10);
  EXPECT_EQ(read_panel(folder / "tube.stl", options)->faces.size(), 24u);
}

TEST(ReadStl, SaysWhatIsWrongWithTheFile) {
  const TemporaryFolder folder;
  const std::string bytes = binary_stl(tube(24)), text = ascii_cube();
  test::write_text(folder / "cut.stl", bytes.substr(0, bytes.size() - 100));
  EXPECT_EQ(failure_of(folder / "cut.stl"), "read.truncated");
  test::write_text(folder / "cut.stl", text.substr(0, text.size() / 2));
  EXPECT_EQ(failure_of(folder / "cut.stl"), "read.truncated");
  test::write_text(folder / "words.stl", "these are only words");
  EXPECT_EQ(failure_of(folder / "words.stl"), "read.unreadable");
  test::write_text(folder / "none.stl", "solid x\nendsolid x\n");
  EXPECT_EQ(failure_of(folder / "none.stl"), "read.no_faces");
  test::write_text(folder / "nan.stl",
                   "solid x\nfacet\nouter loop\nvertex 0 0 nan\nvertex 1 0 0\nvertex 0 1 "
                   "0\nendloop\nendfacet\nendsolid\n");
  EXPECT_EQ(failure_of(folder / "nan.stl"), "read.unreadable");
}

}  // namespace
}  // namespace beadmesh
