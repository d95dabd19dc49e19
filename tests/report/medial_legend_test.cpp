#include "beadmesh/report/medial_legend.h"

#include <gtest/gtest.h>

#include <cmath>

#include "report/well_formed.h"
#include "write/medial_stadium.h"

namespace beadmesh::drawing {
namespace {

TEST(MedialLegend, TicksAreRoundAndWithinTheRange) {
  EXPECT_EQ(round_ticks(0, 50, 6), (std::vector<double>{0, 10, 20, 30, 40, 50}));
  EXPECT_DOUBLE_EQ(round_ticks(13.5, 15.2, 6).front(), 13.6);
  EXPECT_FALSE(std::signbit(round_ticks(0, 1, 5).front())) << "no minus before a zero";
  EXPECT_FALSE(std::signbit(round_ticks(-1e-12, 1, 5).front()));
  EXPECT_TRUE(round_ticks(3, 3, 6).empty());
}

TEST(MedialLegend, RangeOfAnEvenThicknessIsWidened) {
  const MedialObject object = test::stadium().object;
  const ThicknessRange range = thickness_range({&object});
  EXPECT_LT(range.low, 20);
  EXPECT_GT(range.high, 20);
  EXPECT_DOUBLE_EQ(range.fraction(20), 0.5);
  EXPECT_EQ(thickness_range({}).high, 0);
}

TEST(MedialLegend, ShowsOnlyWhatThereIs) {
  Legend legend;
  legend.range = {0, 8};
  legend.counts = {12, 0, 3, 0};
  const std::string svg = legend_svg(legend, {0, 0}, 1400);
  EXPECT_EQ(beadmesh::test::first_fault(svg), "");
  EXPECT_NE(svg.find(">12<"), std::string::npos);
  EXPECT_NE(svg.find("S smooth end"), std::string::npos);
  EXPECT_EQ(svg.find("C corner end"), std::string::npos);
  EXPECT_EQ(svg.find("side of a cut"), std::string::npos);
}

}  // namespace
}  // namespace beadmesh::drawing
