#include "beadmesh/bead/shape_letter.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "bead/studied_bead.h"
#include "examples/skeletons.h"
#include "medial/shapes.h"

namespace beadmesh {
namespace {

using namespace shapes;
using examples::network;
using examples::strip;

std::string letter_of(const Footprint& footprint) {
  return shape_letter(skeleton_of(medial_of(region_of(footprint))));
}

struct Named {
  std::string letter;
  std::string what;
  Footprint footprint;
};

Footprint z_footprint() {
  const double turn = radians(100);
  return strip({{.length = 50},
                {.radius = 12, .turn = turn},
                {.length = 50},
                {.radius = 12, .turn = -turn},
                {.length = 50}},
               12);
}

Footprint f_footprint() {
  return network({{0, 0}, {0, 40}, {0, 80}, {0, 95}, {45, 80}, {40, 40}},
                 {{0, 1}, {1, 2}, {2, 3}, {2, 4}, {1, 5}}, 12, 7);
}

/// Three teeth, the outer ones bent into the spine.
Footprint e_footprint() {
  return network({{0, 0}, {0, 40}, {0, 80}, {40, 80}, {40, 40}, {40, 0}},
                 {{0, 1}, {1, 2}, {2, 3}, {1, 4}, {0, 5}}, 12, 7);
}

Footprint tree_footprint() {
  return network({{0, 0}, {50, 0}, {-50, 0}, {0, 50}, {0, -50}, {90, 40}, {90, -40}},
                 {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 5}, {1, 6}}, 12, 7);
}

std::vector<Named> one_arm() {
  return {{"I", "straight", examples::straight_bead(80, 16)},
          {"I", "tapered", examples::taper(80, 20, 12)},
          {"arc", "75 degrees", examples::arc_bead(80, 75, 14)},
          {"arc", "wide, 42 degrees", examples::arc_bead(165, 42, 15)},
          {"arc", "wide, 54 degrees", examples::arc_bead(140, 54, 14)},
          {"arc", "140 degrees", examples::arc_bead(45, 140, 14)},
          {"C", "200 degrees", examples::arc_bead(40, 200, 14)},
          {"S", "gentle", examples::s_bead(60, 60, 15)},
          {"Z", "sharp", z_footprint()},
          {"L", "right angle", examples::l_bead(60, 50, 20, 90, 14)},
          {"L", "70 degrees", examples::l_bead(55, 55, 18, 70, 12)},
          {"J", "hook", examples::l_bead(60, 12, 20, 160, 13)},
          {"U", "two bends in one", examples::l_bead(50, 50, 20, 180, 13)},
          {"G", "three quarters and a leg", examples::g_bead(30, 14, 12)}};
}

std::vector<Named> several_arms() {
  return {{"T", "right angle", t_footprint()},
          {"T", "bar bent by 15 degrees", star_footprint({0, 165, 262}, 60, 14, 8)},
          {"Y", "120 degrees", star_footprint({90, 210, 330}, 60, 14, 8)},
          {"Y", "no arms in a line", star_footprint({0, 140, 250}, 60, 14, 8)},
          {"X", "right angle", star_footprint({0, 90, 180, 270}, 60, 14, 8)},
          {"X", "75 degrees", star_footprint({0, 75, 180, 255}, 60, 14, 8)},
          {"H", "", examples::h_bead(90, 60, 13, 8)},
          {"F", "", f_footprint()},
          {"F", "upper tooth bent into the spine", examples::f_bead(84, 40, 12, 7)},
          {"trident", "", examples::trident_bead(60, 40, 40, 12, 7)},
          {"comb", "three teeth", examples::comb_bead(3, 34, 46, 12, 8)},
          {"comb", "five teeth", examples::comb_bead(5, 34, 46, 12, 8)},
          {"comb", "three teeth, two of them bent into the spine", e_footprint()},
          {"comb", "curved", examples::curved_comb_bead(3, 84, 24, 40, 12, 7)},
          {"comb", "five teeth, curved", examples::curved_comb_bead(5, 100, 20, 45, 12, 7)},
          {"ladder", "one window", examples::ladder_bead(2, 42, 46, 13, 8)},
          {"ladder", "two windows", examples::ladder_bead(3, 42, 46, 13, 8)},
          {"tree", "", tree_footprint()},
          {"tree", "two levels of forks", examples::tree_bead(44, 46, 36, 12, 7)},
          {"ring", "round", examples::circular_ring(40, 14)},
          {"ring", "oval", examples::rounded_ring(110, 86, 27, 15)}};
}

void expect_letters(const std::vector<Named>& shapes, double angle, bool mirrored) {
  for (const Named& shape : shapes)
    EXPECT_EQ(letter_of(placed(shape.footprint, {3, 4}, angle, mirrored)), shape.letter)
        << shape.what << ", turned by " << angle << (mirrored ? ", mirrored" : "");
}

TEST(ShapeLetter, OfOneArm) {
  expect_letters(one_arm(), 0, false);
}
TEST(ShapeLetter, OfOneArmTurned) {
  expect_letters(one_arm(), 2.3, false);
}
TEST(ShapeLetter, OfOneArmMirrored) {
  expect_letters(one_arm(), 0.7, true);
}
TEST(ShapeLetter, OfSeveralArms) {
  expect_letters(several_arms(), 0, false);
}
TEST(ShapeLetter, OfSeveralArmsTurned) {
  expect_letters(several_arms(), 2.3, false);
}
TEST(ShapeLetter, OfSeveralArmsMirrored) {
  expect_letters(several_arms(), 0.7, true);
}

TEST(ShapeLetter, LWithASpurIsStillAnL) {
  EXPECT_EQ(shape_letter(skeleton_of(medial_of(letter_l(14, 6, 7)))), "L");
}

TEST(ShapeLetter, CombWhoseOuterTeethBendIntoTheSpine) {
  EXPECT_EQ(shape_letter(skeleton_of(medial_of(comb(5, 12, 30, 40, 6)))), "comb");
}

TEST(ShapeLetter, OfNothingIsAnI) {
  EXPECT_EQ(shape_letter(Skeleton{}), "I");
}

RC_GTEST_PROP(ShapeLetter, DoesNotDependOnPlaceAndSize, ()) {
  const auto shapes = *rc::gen::arbitrary<bool>() ? one_arm() : several_arms();
  const Named shape = shapes[*rc::gen::inRange<size_t>(0, shapes.size())];
  const double angle = *rc::gen::inRange(0, 3600) * radians(0.1), scale = *rc::gen::inRange(5, 300) / 100.0;
  const bool mirrored = *rc::gen::arbitrary<bool>();
  const PlanarRegion region = scaled(
      region_of(placed(shape.footprint, {*rc::gen::inRange(-500, 500) * 1.0, 7}, angle, mirrored)), scale);
  RC_ASSERT(shape_letter(skeleton_of(medial_of(region))) == shape.letter);
}

}  // namespace
}  // namespace beadmesh
