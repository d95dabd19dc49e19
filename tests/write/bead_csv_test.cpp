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

}  // namespace
}  // namespace beadmesh
