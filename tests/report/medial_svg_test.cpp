#include "beadmesh/report/medial_svg.h"

#include <gtest/gtest.h>

#include <string>

#include "report/well_formed.h"
#include "write/medial_stadium.h"

namespace beadmesh {
namespace {

using test::count;
using test::stadium;

TEST(MedialSvg, ShowsBoundaryAxisCirclesAndMarks) {
  const std::string svg = medial_svg({stadium()}, "stadium.wkt");
  EXPECT_EQ(test::first_fault(svg), "");
  EXPECT_NE(svg.find("stadium.wkt"), std::string::npos);
  EXPECT_NE(svg.find("1 face, 2 vertices, 1 edge<"), std::string::npos);
  EXPECT_EQ(count(svg, "<circle"), 2);
  EXPECT_NE(svg.find("S smooth end"), std::string::npos);
  EXPECT_EQ(svg.find("J junction"), std::string::npos);
  EXPECT_NE(svg.find("thickness, mm"), std::string::npos);
}

TEST(MedialSvg, CirclesHaveTheScaleOfTheBoundary) {
  // 60 mm across on 1400 pixels, so the radius of 10 mm is 233.33 pixels
  EXPECT_NE(medial_svg({stadium()}, "").find("r=\"233.33\""), std::string::npos);
}

TEST(MedialSvg, SeveralFacesShareOneScaleAndCarryNumbers) {
  FaceMedial other = stadium();
  other.face = 8;
  const std::string svg = medial_svg({stadium(), other}, "two");
  EXPECT_EQ(test::first_fault(svg), "");
  EXPECT_NE(svg.find("id=\"face-3\""), std::string::npos);
  EXPECT_NE(svg.find("id=\"face-8\""), std::string::npos);
  EXPECT_EQ(count(svg, "r=\"233.33\""), 4);
}

TEST(MedialSvg, FeetAreDrawnWhereAskedFor) {
  EXPECT_EQ(count(medial_svg({stadium()}, ""), "class=\"feet\""), 0);
  const std::string svg = medial_svg({stadium()}, "", {true, {}});
  EXPECT_EQ(test::first_fault(svg), "");
  EXPECT_EQ(count(svg, "class=\"feet\""), 1);
}

TEST(MedialSvg, SidesOfCutsAreMarkedAndExplained) {
  PlaneImage image;
  image.cut_sides = {std::vector<bool>(34, false)};
  image.cut_sides[0][16] = true;
  const std::string svg = medial_svg({stadium()}, "", {false, {image}});
  EXPECT_EQ(test::first_fault(svg), "");
  EXPECT_EQ(count(svg, "class=\"cut\""), 1);
  EXPECT_EQ(count(svg, "side of a cut"), 1);
  EXPECT_EQ(count(medial_svg({stadium()}, "", {false, {PlaneImage{}}}), "side of a cut"), 0);
}

TEST(MedialSvg, MarksCarryTheirCounts) {
  EXPECT_NE(medial_svg({stadium()}, "").find("S smooth end <tspan fill=\"#57606a\">2</tspan>"),
            std::string::npos);
}

TEST(MedialSvg, WhatIsFinerThanAPixelIsLeftOut) {
  FaceMedial face = stadium();
  MedialEdge& edge = face.object.edges[0];
  const MedialPoint first = edge.points[0];
  edge.points.clear();
  for (int i = 0; i <= 100000; ++i) {
    edge.points.push_back(first);
    edge.points.back().point.x = 40.0 * i / 100000;
    edge.points.back().radius = 5 + 5.0 * i / 100000;
  }
  EXPECT_LT(medial_svg({face}, "").size(), 20000);
}

TEST(MedialSvg, NothingIsStillAPicture) {
  EXPECT_EQ(test::first_fault(medial_svg({}, "none")), "");
  EXPECT_EQ(test::first_fault(medial_svg({FaceMedial{}}, "empty")), "");
}

}  // namespace
}  // namespace beadmesh
