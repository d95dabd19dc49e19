#include "beadmesh/geometry/predicates.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

namespace beadmesh {
namespace {

using Wide = __int128;

int sign(double v) {
  return (v > 0) - (v < 0);
}
int sign(Wide v) {
  return (v > 0) - (v < 0);
}

struct IntegerPoint {
  std::int64_t x, y;
  Vec2 real() const { return {static_cast<double>(x), static_cast<double>(y)}; }
};

int orient_oracle(IntegerPoint a, IntegerPoint b, IntegerPoint c) {
  return sign(Wide(a.x - c.x) * (b.y - c.y) - Wide(a.y - c.y) * (b.x - c.x));
}

int incircle_oracle(IntegerPoint a, IntegerPoint b, IntegerPoint c, IntegerPoint d) {
  const auto lift = [&](IntegerPoint p) {
    return Wide(p.x - d.x) * (p.x - d.x) + Wide(p.y - d.y) * (p.y - d.y);
  };
  const auto minor = [&](IntegerPoint p, IntegerPoint q) {
    return Wide(p.x - d.x) * (q.y - d.y) - Wide(q.x - d.x) * (p.y - d.y);
  };
  return sign(lift(a) * minor(b, c) + lift(b) * minor(c, a) + lift(c) * minor(a, b));
}

std::int64_t coordinate(std::int64_t bound) {
  return *rc::gen::inRange<std::int64_t>(-bound, bound + 1);
}
IntegerPoint integer_point(std::int64_t bound) {
  return {coordinate(bound), coordinate(bound)};
}

// Coordinates with full significands, so that differences are rounded.
Vec2 real_point() {
  const auto value = [] {
    return static_cast<double>(coordinate(std::int64_t{1} << 53)) *
           std::ldexp(1.0, *rc::gen::inRange(-60, -50));
  };
  const double x = value(), y = value();
  return {x, y};
}

RC_GTEST_PROP(Predicates, orient_agrees_with_integers_near_a_line, ()) {
  const auto a = integer_point(1 << 20), step = integer_point(1 << 20);
  const auto at = [&](std::int64_t k) { return IntegerPoint{a.x + k * step.x, a.y + k * step.y}; };
  const auto b = at(coordinate(1 << 20));
  auto c = at(coordinate(1 << 20));
  c.x += coordinate(1);
  c.y += coordinate(1);
  RC_ASSERT(sign(orient2d(a.real(), b.real(), c.real())) == orient_oracle(a, b, c));
}

// Pythagorean directions give integer points that are exactly on a circle; some are moved off it by one.
RC_GTEST_PROP(Predicates, incircle_agrees_with_integers_near_a_circle, ()) {
  static constexpr int directions[][2] = {{65, 0},    {63, 16},  {60, 25},  {56, 33},  {52, 39},
                                          {39, 52},   {33, 56},  {25, 60},  {16, 63},  {0, 65},
                                          {-16, 63},  {-25, 60}, {-52, 39}, {-65, 0},  {-39, -52},
                                          {-16, -63}, {0, -65},  {25, -60}, {52, -39}, {63, -16}};
  const auto centre = integer_point(1 << 26);
  const std::int64_t radius = *rc::gen::inRange<std::int64_t>(1, 1 << 18);
  const auto on_circle = [&] {
    const auto& d = directions[*rc::gen::inRange<std::size_t>(0, std::size(directions))];
    return IntegerPoint{centre.x + radius * d[0], centre.y + radius * d[1]};
  };
  const auto a = on_circle(), b = on_circle(), c = on_circle();
  auto d = on_circle();
  d.x += coordinate(1);
  d.y += coordinate(1);
  RC_ASSERT(sign(incircle(a.real(), b.real(), c.real(), d.real())) == incircle_oracle(a, b, c, d));
}

RC_GTEST_PROP(Predicates, orient_is_antisymmetric_and_cyclic, ()) {
  const Vec2 a = real_point(), b = real_point(), c = lerp(a, b, 0.37);
  const int s = sign(orient2d(a, b, c));
  RC_ASSERT(s == sign(orient2d(b, c, a)));
  RC_ASSERT(s == sign(orient2d(c, a, b)));
  RC_ASSERT(s == -sign(orient2d(b, a, c)));
  RC_ASSERT(s == sign(exact::orient2d(a, b, c)));
}

RC_GTEST_PROP(Predicates, incircle_is_antisymmetric_and_cyclic, ()) {
  const Vec2 centre = real_point();
  const auto near_circle = [&] {
    const double angle = *rc::gen::inRange(0, 1000) * 0.00628;
    return centre + Vec2{std::cos(angle), std::sin(angle)};
  };
  const Vec2 a = near_circle(), b = near_circle(), c = near_circle(), d = near_circle();
  const int s = sign(incircle(a, b, c, d));
  RC_ASSERT(s == sign(incircle(b, c, a, d)));
  RC_ASSERT(s == -sign(incircle(b, a, c, d)));
  RC_ASSERT(s == -sign(incircle(a, b, d, c)));
  RC_ASSERT(s == -sign(incircle(d, b, c, a)));
  RC_ASSERT(s == sign(exact::incircle(a, b, c, d)));
}

RC_GTEST_PROP(Predicates, translation_and_scale_by_powers_of_two_change_nothing, ()) {
  const auto a = integer_point(1 << 24), b = integer_point(1 << 24), c = integer_point(1 << 24);
  const auto shift = integer_point(1 << 30), d = IntegerPoint{a.x + b.x - c.x, a.y + b.y - c.y};
  const double factor = std::ldexp(1.0, *rc::gen::inRange(-100, 100));
  const auto moved = [&](IntegerPoint p) { return (p.real() + shift.real()) * factor; };
  RC_ASSERT(sign(orient2d(moved(a), moved(b), moved(c))) == orient_oracle(a, b, c));
  RC_ASSERT(sign(incircle(moved(a), moved(b), moved(c), moved(d))) ==
            sign(incircle(a.real(), b.real(), c.real(), d.real())));
}

// Plain arithmetic says 0 or the wrong sign for many of these.
TEST(Predicates, a_point_one_unit_in_the_last_place_off_a_line) {
  const Vec2 b{12, 12}, c{24, 24};
  const double ulp = std::ldexp(1.0, -53);
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j)
      EXPECT_EQ(sign(orient2d({0.5 + i * ulp, 0.5 + j * ulp}, b, c)), (j > i) - (j < i)) << i << ' ' << j;
}

TEST(Predicates, signs_of_simple_cases) {
  EXPECT_GT(orient2d({0, 0}, {1, 0}, {0, 1}), 0);
  EXPECT_LT(orient2d({0, 0}, {0, 1}, {1, 0}), 0);
  EXPECT_EQ(orient2d({1, 1}, {1, 1}, {5, 2}), 0);
  EXPECT_GT(incircle({0, 0}, {1, 0}, {0, 1}, {0.5, 0.5}), 0);
  EXPECT_EQ(incircle({0, 0}, {1, 0}, {0, 1}, {1, 1}), 0);
  EXPECT_LT(incircle({0, 0}, {1, 0}, {0, 1}, {1, 1.0000000000000002}), 0);
}

TEST(Predicates, range_of_exactness) {
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(is_in_exact_range({0, -1e60}));
  EXPECT_FALSE(is_in_exact_range({0, 1e61}));
  EXPECT_FALSE(is_in_exact_range({1e-61, 0}));
  EXPECT_FALSE(is_in_exact_range({infinite, 0}));
  EXPECT_FALSE(is_in_exact_range({0, std::numeric_limits<double>::quiet_NaN()}));
}

TEST(SegmentContact, every_class) {
  using enum SegmentContact;
  const Vec2 o{0, 0}, x{4, 0};
  EXPECT_EQ(segment_contact(o, x, {1, 1}, {1, 3}), none);
  EXPECT_EQ(segment_contact(o, x, {5, 0}, {6, 0}), none);
  EXPECT_EQ(segment_contact(o, x, {1, -1}, {2, 5}), crossing);
  EXPECT_EQ(segment_contact(o, x, {1, 0}, {2, 5}), touching);
  EXPECT_EQ(segment_contact(o, x, x, {2, 5}), endpoint);
  EXPECT_EQ(segment_contact(o, x, x, {9, 0}), endpoint);
  EXPECT_EQ(segment_contact(o, x, {3, 0}, {9, 0}), overlapping);
  EXPECT_EQ(segment_contact(o, x, o, {2, 0}), overlapping);
  EXPECT_EQ(segment_contact(o, x, x, o), overlapping);
  EXPECT_EQ(segment_contact(o, x, {1, 0}, {1, 0}), overlapping);
  EXPECT_EQ(segment_contact(o, x, {1, 1}, {1, 1}), none);
  EXPECT_TRUE(segments_intersect(o, x, x, {9, 0}));
}

RC_GTEST_PROP(SegmentContact, does_not_depend_on_order_or_direction, ()) {
  const auto point = [] { return integer_point(3).real(); };
  const Vec2 a = point(), b = point(), c = point(), d = point();
  const auto contact = segment_contact(a, b, c, d);
  RC_ASSERT(contact == segment_contact(b, a, c, d));
  RC_ASSERT(contact == segment_contact(c, d, a, b));
  RC_ASSERT(contact == segment_contact(d, c, a, b));
}

}  // namespace
}  // namespace beadmesh
