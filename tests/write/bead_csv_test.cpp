#include "beadmesh/write/bead_csv.h"

#include <gtest/gtest.h>

#include "write/bead_plate.h"

namespace beadmesh {
namespace {

TEST(BeadCsv, HasAHeadAndALineABead) {
  EXPECT_EQ(bead_csv(test::plate_panel(), test::plate_table()),
            "id,kind,shape,faces,x,y,z,loops,length,width,height,aspect_ratio,junctions,ends,medial_edges\n"
            "1,I,I,2,50.0000,25.0000,4.0000,1,40.0000,20.0000,4.0000,2.0000,0,2,1\n");
}

TEST(BeadCsv, JoinsFacesAndQuotesText) {
  BeadTable table = test::plate_table();
  table.beads[0].faces = {0, 1};
  table.beads[0].shape = "a,\"b\"";
  EXPECT_NE(bead_csv(test::plate_panel(), table).find("1,I,\"a,\"\"b\"\"\",1 2,"), std::string::npos);
}

TEST(BeadCsv, DesignColumnsAreEmptyWhereThereIsNothing) {
  BeadDesign measured;
  measured.sections = {9, 4, 0.2, radians(45), 3.0, 0.0};
  measured.distances = {12.5, 3, 20.0, {}};
  measured.exceeded = {"wall_angle", "root_radius"};
  const std::string text = bead_csv(test::plate_panel(), test::plate_table(), {measured});
  EXPECT_NE(text.find(",medial_edges,depth,depth_to_width,wall_angle,"), std::string::npos);
  EXPECT_NE(text.find(",1,4.0000,0.2000,45.0000,3.0000,0.0000,12.5000,3,20.0000,,wall_angle root_radius\n"),
            std::string::npos);
  EXPECT_NE(bead_csv(test::plate_panel(), test::plate_table(), {BeadDesign{}}).find(",1,,,,,,,,,,\n"),
            std::string::npos);
}

}  // namespace
}  // namespace beadmesh
