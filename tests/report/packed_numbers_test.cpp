#include "beadmesh/report/packed_numbers.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

namespace beadmesh {
namespace {

constexpr auto least = std::numeric_limits<std::int32_t>::min(),
               most = std::numeric_limits<std::int32_t>::max();

TEST(PackedNumbers, WritesBase64OfTheStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(PackedNumbers, KeepsOnlyTheBytesThatAreNeeded) {
  EXPECT_EQ(packed({0, 1, -128, 127}).bytes, 1);
  EXPECT_EQ(packed({128}).bytes, 2);
  EXPECT_EQ(packed({1000000, 1000001, 1000003}, 1, Packing::plain).bytes, 3);
  EXPECT_EQ(packed({least, most}).bytes, 4);
}

TEST(PackedNumbers, DifferencesOfRowsAreSmall) {
  std::vector<std::int32_t> values;
  for (int i = 0; i < 10000; ++i) values.insert(values.end(), {i, 100000 + 3 * i, -i});
  const PackedNumbers differences = packed(values, 3, Packing::differences);
  EXPECT_LT(differences.text.size(), packed(values, 3).text.size() / 10);
  EXPECT_EQ(unpacked(differences), values);
}

TEST(PackedNumbers, ExtremesComeBack) {
  const std::vector<std::int32_t> values{least, most, 0, most, least, -1};
  for (const Packing packing : {Packing::plain, Packing::differences})
    EXPECT_EQ(unpacked(packed(values, 2, packing)), values);
}

TEST(PackedNumbers, ForeignTextGivesNothing) {
  PackedNumbers numbers = packed({1, 2, 3});
  numbers.text = "no zlib";
  EXPECT_TRUE(unpacked(numbers).empty());
}

RC_GTEST_PROP(PackedNumbers, ComeBack, (std::vector<std::int32_t> values)) {
  for (const int stride : {1, 2, 3, 4}) {
    std::vector<std::int32_t> rows = values;
    rows.resize(values.size() / stride * stride);
    for (const Packing packing : {Packing::plain, Packing::differences})
      RC_ASSERT(unpacked(packed(rows, stride, packing)) == rows);
  }
}

}  // namespace
}  // namespace beadmesh
