#include "beadmesh/core/vector.h"

#include <gtest/gtest.h>

namespace beadmesh {
namespace {

TEST(Vector, AnglesAreAccurateNearZeroAndPi) {
  EXPECT_NEAR(angle_between(Vec2{1, 0}, Vec2{1, 1e-9}), 1e-9, 1e-18);
  EXPECT_NEAR(angle_between(Vec3{1, 0, 0}, Vec3{-1, 1e-9, 0}), pi - 1e-9, 1e-15);
}

TEST(Vector, CrossIsPositiveToTheLeft) {
  EXPECT_GT(cross(Vec2{1, 0}, Vec2{0, 1}), 0);
  EXPECT_EQ(left_normal(Vec2{1, 0}), (Vec2{0, 1}));
  EXPECT_EQ(cross(Vec3{1, 0, 0}, Vec3{0, 1, 0}), (Vec3{0, 0, 1}));
}

TEST(Vector, TheZeroVectorHasNoDirection) {
  EXPECT_EQ(normalized(Vec3{}), Vec3{});
  EXPECT_DOUBLE_EQ(norm(normalized(Vec2{3, 4})), 1);
}

}  // namespace
}  // namespace beadmesh
