#include "beadmesh/medial/tolerances.h"

#include <gtest/gtest.h>

#include "medial/shapes.h"

namespace beadmesh {
namespace {

TEST(Tolerances, GrowWithTheFace) {
  const Tolerances one = tolerances_of(shapes::rectangle(3, 4)),
                   tenfold = tolerances_of(shapes::rectangle(30, 40));
  EXPECT_DOUBLE_EQ(one.contact, 5e-9);
  EXPECT_DOUBLE_EQ(tenfold.contact, 10 * one.contact);
  EXPECT_DOUBLE_EQ(tenfold.rounding, 10 * one.rounding);
  EXPECT_DOUBLE_EQ(tenfold.chord, 10 * one.chord);
  EXPECT_LT(one.rounding, one.contact);
  EXPECT_LT(one.contact, one.chord);
}

TEST(Tolerances, KnowTheDigitsThatCoordinatesHaveLost) {
  const PlanarRegion far = shapes::translated(shapes::rectangle(3, 4), {1e9, 0});
  EXPECT_GT(tolerances_of(far).rounding, 1e-7);
  EXPECT_GT(tolerances_of(far).contact, 1e-6);
  EXPECT_DOUBLE_EQ(tolerances_of(far).chord, tolerances_of(shapes::rectangle(3, 4)).chord);
}

TEST(Tolerances, OfNothingAreZero) {
  EXPECT_EQ(tolerances_of({}).contact, 0);
}

}  // namespace
}  // namespace beadmesh
