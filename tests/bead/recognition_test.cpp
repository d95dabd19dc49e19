#include "beadmesh/bead/recognition.h"

#include <gtest/gtest.h>

#include "bead/studied_bead.h"
#include "examples/skeletons.h"

namespace beadmesh {
namespace {

using namespace shapes;

Result<Bead> recognised(const StudiedBead& bead, const BeadOptions& options = {}) {
  return recognise(*bead.study, bead.medial, options);
}

std::string code_of(const Result<Bead>& bead) {
  return bead ? "a bead" : bead.error().code;
}

TEST(Recognition, StraightBeadHasTheMeasuresItWasDrawnWith) {
  for (const double height : {5.0, -5.0}) {
    const StudiedBead studied = studied_bead(examples::straight_bead(84, 16), height);
    ASSERT_TRUE(check_boundary(*studied.study));
    const auto bead = recognised(studied);
    ASSERT_TRUE(bead) << bead.error().message;
    EXPECT_EQ(bead->kind, BeadKind::I);
    EXPECT_EQ(bead->shape, "I");
    EXPECT_NEAR(bead->length, 84, 0.6);
    EXPECT_NEAR(bead->width, 16, 0.05);
    EXPECT_NEAR(bead->height, 5, 0.02);
    EXPECT_NEAR(bead->aspect_ratio, 84.0 / 16, 0.05);
    EXPECT_EQ(bead->loops, 1);
    EXPECT_EQ(bead->ends, 2);
    EXPECT_EQ(bead->junctions, 0);
    EXPECT_EQ(bead->medial_edges, 1);
    EXPECT_EQ(bead->faces, std::vector<Index>{0});
    EXPECT_NEAR(bead->point.z, height, 0.02) << "its point lies on the crest";
    ASSERT_EQ(bead->ridge.size(), 1);
    EXPECT_FALSE(bead->ridge[0].closed);
    EXPECT_EQ(bead->ridge[0].flat.size(), bead->ridge[0].points.size());
    EXPECT_NEAR(distance(bead->ridge[0].points.front(), bead->ridge[0].points.back()), 100, 0.3)
        << "tip to tip";
  }
}

TEST(Recognition, TaperHasItsMeanWidth) {
  const auto bead = recognised(studied_bead(examples::taper(90, 22, 14), 5));
  ASSERT_TRUE(bead);
  EXPECT_EQ(bead->kind, BeadKind::I);
  EXPECT_NEAR(bead->width, 18, 0.3);
}

TEST(Recognition, RingIsAnnular) {
  const auto bead = recognised(studied_bead(examples::circular_ring(44, 14), 5));
  ASSERT_TRUE(bead);
  EXPECT_EQ(bead->kind, BeadKind::annular);
  EXPECT_EQ(bead->shape, "ring");
  EXPECT_EQ(bead->loops, 2);
  EXPECT_EQ(bead->ends, 0);
  EXPECT_NEAR(bead->length, 2 * pi * 37, 0.5);
  EXPECT_NEAR(bead->width, 14, 0.05);
  EXPECT_NEAR(bead->height, 5, 0.02);
  ASSERT_EQ(bead->ridge.size(), 1);
  EXPECT_TRUE(bead->ridge[0].closed);
}

TEST(Recognition, TIsGeneric) {
  const auto bead = recognised(studied_bead(t_footprint(), 5));
  ASSERT_TRUE(bead);
  EXPECT_EQ(bead->kind, BeadKind::generic);
  EXPECT_EQ(bead->shape, "T");
  EXPECT_EQ(bead->junctions, 1);
  EXPECT_EQ(bead->ends, 3);
  EXPECT_EQ(bead->medial_edges, 3);
  EXPECT_NEAR(bead->length, 104 + 62, 5);
  EXPECT_NEAR(bead->width, 16, 0.1) << "that of its arms: the junction is wider";
}

TEST(Recognition, WidthIsThatOfTheArmsWhereverTheyMeet) {
  for (const double fillet : {4.0, 9.0, 16.0}) {
    const auto x = recognised(studied_bead(star_footprint({0, 80, 180, 260}, 60, 14, fillet), 4));
    ASSERT_TRUE(x) << x.error().message;
    EXPECT_NEAR(x->width, 14, 0.2) << "X, fillet " << fillet;
    const auto comb = recognised(studied_bead(examples::comb_bead(4, 34, 46, 12, fillet / 2), 4));
    ASSERT_TRUE(comb) << comb.error().message;
    EXPECT_NEAR(comb->width, 12, 0.2) << "comb, fillet " << fillet / 2;
  }
}

/// Rises over 25 mm at both ends, as run-outs do.
TEST(Recognition, HeightIsTheFullOneWhereTheEndsRunOut) {
  const examples::Footprint footprint = examples::straight_bead(100, 16);
  PlanPanel plan(flat_base, 2);
  const auto inside = std::make_shared<examples::BoundaryDistance>(footprint.loops);
  const int loop = plan.add_loop(points_of(footprint.loops[0], 1));
  plan.add_face(loop, {}, [=](Vec2 p) {
    const double across = std::clamp((*inside)(p) / 8, 0.0, 1.0);
    const double along = std::clamp((58 - std::abs(p.x)) / 25, 0.0, 1.0);
    return Vec3{p.x, p.y, 6 * across * across * (3 - 2 * across) * along};
  });
  const auto bead = recognised(studied_face(plan.take(), 0));
  ASSERT_TRUE(bead) << bead.error().message;
  EXPECT_NEAR(bead->height, 6, 0.1);
}

TEST(Recognition, LadderWithOneWindowIsGenericWithTwoLoops) {
  const StudiedBead studied = studied_bead(examples::ladder_bead(2, 42, 46, 13, 8), 4.5);
  EXPECT_TRUE(check_boundary(*studied.study));
  const auto bead = recognised(studied);
  ASSERT_TRUE(bead) << bead.error().message;
  EXPECT_EQ(bead->kind, BeadKind::generic);
  EXPECT_EQ(bead->shape, "ladder");
  EXPECT_EQ(bead->loops, 2);
}

TEST(Recognition, BeadOnACurvedSheetIsRaisedOverTheSheet) {
  for (const double height : {4.0, -4.0})
    for (const double turn : {0.0, pi / 2}) {
      const auto bead = recognised(
          studied_bead(placed(examples::straight_bead(84, 16), {}, turn), height, cylinder_base(500)));
      ASSERT_TRUE(bead) << bead.error().message;
      EXPECT_NEAR(bead->height, 4, 0.15);
    }
}

TEST(Recognition, FlatFaceIsNoBead) {
  EXPECT_EQ(code_of(recognised(studied_bead(examples::straight_bead(84, 16), 0))), "bead.flat");
  EXPECT_EQ(code_of(recognised(studied_bead(examples::circular_ring(44, 14), 0))), "bead.flat");
}

TEST(Recognition, FaceThatOnlyFollowsACurvedSheetIsNoBead) {
  // On a cylinder of radius 100 the middle of the 16 mm chord stands 0.32 mm over it, of a wide one more.
  for (const double width : {16.0, 30.0})
    for (const double turn : {0.0, 0.8, pi / 2}) {
      const Footprint strip = placed(examples::straight_bead(100, width), {}, turn);
      EXPECT_EQ(code_of(recognised(studied_bead(strip, 0, cylinder_base(100)))), "bead.flat")
          << width << " " << turn;
    }
}

TEST(Recognition, LimitOfTheRiseIsAnOption) {
  const StudiedBead low = studied_bead(examples::straight_bead(84, 16), 0.8);
  EXPECT_TRUE(recognised(low)) << "0.05 of the width";
  BeadOptions options;
  options.min_rise = 0.1;
  EXPECT_EQ(code_of(recognised(low, options)), "bead.flat");
}

TEST(Recognition, ShortFaceIsNoBead) {
  const StudiedBead dimple = studied_bead(examples::straight_bead(20, 16), 5);
  const auto bead = recognised(dimple);
  ASSERT_EQ(code_of(bead), "bead.aspect_ratio");
  EXPECT_NE(bead.error().message.find("< 2.00"), std::string::npos) << bead.error().message;
  BeadOptions options;
  options.min_aspect_ratio = 1;
  EXPECT_TRUE(recognised(dimple, options));
}

TEST(Recognition, RoundEmbossIsNoBead) {
  const StudiedBead emboss = studied_bead(examples::blob(examples::circle(20), 20), 4);
  EXPECT_FALSE(recognised(emboss));
}

TEST(Recognition, FaceWithoutAMedialEdgeIsNoBead) {
  const StudiedBead bead = studied_bead(examples::straight_bead(84, 16), 5);
  EXPECT_EQ(code_of(recognise(*bead.study, MedialObject{})), "bead.no_axis");
}

TEST(Recognition, CornerOfTheBoundaryIsNoBead) {
  PlanPanel plan;
  const int loop = plan.add_loop({{0, 0}, {30, 0}, {60, 0}, {60, 16}, {30, 16}, {0, 16}}, {0, 2, 3, 5});
  plan.add_face(loop, {}, on(flat_base));
  const auto study = study_faces(plan.take(), {0});
  ASSERT_TRUE(study);
  const auto boundary = check_boundary(**study);
  ASSERT_FALSE(boundary);
  EXPECT_EQ(boundary.error().code, "bead.corner");
  EXPECT_NE(boundary.error().message.find("90.0 degrees"), std::string::npos) << boundary.error().message;
}

TEST(Recognition, JointUnderTheLimitIsSmooth) {
  // A 12-gon of twelve edges turns by 30 degrees at every joint.
  std::vector<Vec2> points;
  std::vector<Index> breaks;
  for (Index i = 0; i < 12; ++i) {
    points.push_back({20 * std::cos(i * pi / 6), 20 * std::sin(i * pi / 6)});
    breaks.push_back(i);
  }
  PlanPanel plan;
  plan.add_face(plan.add_loop(points, breaks), {}, on(flat_base));
  const auto study = study_faces(plan.take(), {0});
  ASSERT_TRUE(study);
  BeadOptions options;
  options.max_joint_angle = radians(29);
  EXPECT_FALSE(check_boundary(**study, options));
  options.max_joint_angle = radians(31);
  EXPECT_TRUE(check_boundary(**study, options));
}

TEST(Recognition, ThreeLoopsAreNoBead) {
  const StudiedBead ladder = studied_bead(examples::ladder_bead(3, 42, 46, 13, 8), 4.5);
  const auto boundary = check_boundary(*ladder.study);
  ASSERT_FALSE(boundary);
  EXPECT_EQ(boundary.error().code, "bead.loops");
  EXPECT_NE(boundary.error().message.find("3 loops"), std::string::npos);
}

TEST(Recognition, MoreLoopsWhereTheyAreAllowed) {
  const StudiedBead ladder = studied_bead(examples::ladder_bead(3, 42, 46, 13, 8), 4.5);
  BeadOptions options;
  options.max_loops = 3;
  ASSERT_TRUE(check_boundary(*ladder.study, options));
  const auto bead = recognise(*ladder.study, ladder.medial, options);
  ASSERT_TRUE(bead) << bead.error().message;
  EXPECT_EQ(bead->kind, BeadKind::generic);
  EXPECT_EQ(bead->shape, "ladder");
}

}  // namespace
}  // namespace beadmesh
