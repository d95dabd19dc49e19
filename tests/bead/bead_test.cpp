#include "beadmesh/bead/bead.h"

#include <gtest/gtest.h>

namespace beadmesh {
namespace {

TEST(Bead, KindsHaveTheNamesOfThePaper) {
  EXPECT_EQ(name_of(BeadKind::I), "I");
  EXPECT_EQ(name_of(BeadKind::generic), "generic");
  EXPECT_EQ(name_of(BeadKind::annular), "annular");
}

}  // namespace
}  // namespace beadmesh
