#include "beadmesh/medial/sample_refinement.h"

#include <gtest/gtest.h>

#include "medial/sampled_shape.h"

namespace beadmesh {
namespace {

TEST(RefinedSamples, LongEdgesAreHalvedUntilTheyFitTheThickness) {
  const shapes::SampledShape shape = shapes::sampled(shapes::rectangle(100, 20));
  BoundarySamples samples = shape.samples;
  int rounds = 0;
  for (; rounds < 20; ++rounds) {
    const auto refined = refined_samples(samples, shapes::triangulated(samples), shape.curve);
    if (!refined) break;
    EXPECT_GT(refined->samples.size(), samples.samples.size());
    samples = *refined;
  }
  EXPECT_LT(rounds, 20);
  EXPECT_GT(samples.samples.size(), 20u);
  EXPECT_LT(samples.samples.size(), 200u);
  for (std::size_t i = 1; i < samples.samples.size(); ++i)
    EXPECT_GT(samples.samples[i].position, samples.samples[i - 1].position);
}

TEST(RefinedSamples, NothingWhereFacetsAreFineAlready) {
  const shapes::SampledShape shape = shapes::sampled(shapes::stadium(100, 8));
  EXPECT_FALSE(refined_samples(shape.samples, shape.triangulation, shape.curve));
}

TEST(WithContacts, AddsThemOnTheCurveButNoneTwice) {
  const shapes::SampledShape shape = shapes::sampled(shapes::stadium(100, 8));
  const Contact contact = shape.curve.nearest({31, 0}, {0, 0, shape.curve.segments(0)});
  const auto more = with_contacts(shape.samples, {contact, contact}, shape.curve);
  ASSERT_TRUE(more);
  EXPECT_EQ(more->samples.size(), shape.samples.samples.size() + 1);
  EXPECT_FALSE(with_contacts(*more, {contact}, shape.curve));
}

}  // namespace
}  // namespace beadmesh
