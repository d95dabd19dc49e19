#include "beadmesh/mesh/patch_fill.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <numeric>

#include "mesh/sample_quads.h"

namespace beadmesh {
namespace {

/// A regular polygon whose sides have the given numbers of edges.
struct Polygon {
  explicit Polygon(const std::vector<int>& sides) {
    const size_t count = sides.size();
    for (size_t i = 0; i < count; ++i) {
      const auto corner = [&](size_t k) {
        const double angle = 2 * pi * double(k % count) / double(count);
        return Vec2{50 * std::cos(angle), 50 * std::sin(angle)};
      };
      corners.push_back(static_cast<int>(positions.size()));
      for (int k = 0; k < sides[i]; ++k)
        positions.push_back(lerp(corner(i), corner(i + 1), double(k) / sides[i]));
    }
    loop.resize(positions.size());
    std::iota(loop.begin(), loop.end(), 0);
  }
  std::vector<Index> loop;
  std::vector<Vec2> positions;
  std::vector<int> corners;
};

PlanarMesh filled(const Polygon& polygon) {
  PatchFill fill =
      fill_patch(polygon.loop, polygon.positions, polygon.corners, static_cast<Index>(polygon.loop.size()));
  PlanarMesh mesh{polygon.positions, {}, fill.quads};
  mesh.nodes.insert(mesh.nodes.end(), fill.new_nodes.begin(), fill.new_nodes.end());
  mesh.freedom.assign(mesh.nodes.size(), NodeFreedom::free);
  return mesh;
}

int count_irregular(const PlanarMesh& mesh, size_t boundary_nodes) {
  std::vector<int> valence(mesh.nodes.size(), 0);
  for (const MeshElement& element : mesh.elements)
    for (const Index node : element) ++valence[node];
  return static_cast<int>(std::count_if(valence.begin() + static_cast<std::ptrdiff_t>(boundary_nodes),
                                        valence.end(), [](int count) { return count != 4; }));
}

TEST(PatchDivisions, OfThreeSidesSumUp) {
  const auto ends = patch_divisions(std::vector<int>{3, 5, 4});
  ASSERT_TRUE(ends);
  EXPECT_EQ((*ends)[0] + (*ends)[1], 3);
  EXPECT_EQ((*ends)[1] + (*ends)[2], 5);
  EXPECT_EQ((*ends)[2] + (*ends)[0], 4);
}

TEST(PatchDivisions, NeedEvenSumAndTriangleInequality) {
  EXPECT_FALSE(patch_divisions(std::vector<int>{3, 4, 4}));
  EXPECT_FALSE(patch_divisions(std::vector<int>{2, 2, 4}));
  EXPECT_FALSE(patch_divisions(std::vector<int>{2, 3, 2, 4}));
  EXPECT_FALSE(patch_divisions(std::vector<int>{2, 2}));
  EXPECT_TRUE(patch_divisions(std::vector<int>{2, 3, 2, 3}));
}

void expect_good_fill(const std::vector<int>& sides, int irregular) {
  const Polygon polygon(sides);
  const PlanarMesh mesh = filled(polygon);
  const NodeLoops loops{polygon.positions, {polygon.loop}};
  EXPECT_TRUE(verify_planar_mesh(mesh, loops).empty());
  EXPECT_EQ(count_irregular(mesh, polygon.loop.size()), irregular);
}

TEST(PatchFilling, OfFourSidesIsRegular) {
  expect_good_fill({1, 1, 1, 1}, 0);
  expect_good_fill({4, 3, 4, 3}, 0);
}

TEST(PatchFilling, OfThreeAndFiveSidesHasOneIrregularNode) {
  expect_good_fill({2, 2, 2}, 1);
  expect_good_fill({3, 5, 4}, 1);
  expect_good_fill({2, 2, 2, 2, 2}, 1);
  expect_good_fill({5, 4, 4, 5, 4}, 1);
}

RC_GTEST_PROP(PatchFilling, IsValidWhereverDivisionsExist, ()) {
  const size_t count = *rc::gen::inRange<size_t>(3, 6);
  std::vector<int> sides;
  for (size_t i = 0; i < count; ++i) sides.push_back(*rc::gen::inRange(1, 9));
  if (count == 4) sides[2] = sides[0], sides[3] = sides[1];
  if (!patch_divisions(sides)) return;
  const Polygon polygon(sides);
  RC_ASSERT(verify_planar_mesh(filled(polygon), {polygon.positions, {polygon.loop}}).empty());
}

}  // namespace
}  // namespace beadmesh
