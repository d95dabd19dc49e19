#include "beadmesh/mesh/corner_pillow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/sample_quads.h"

namespace beadmesh {
namespace {

using sample::worst_jacobian;

/// A grid whose lower left corner is bent open until its boundary runs nearly straight through it.
PlanarMesh grid_with_flat_corner(int n, double step, double corner_degrees) {
  PlanarMesh mesh = sample::grid(n, n, 1);
  const double half = radians(corner_degrees) / 2;
  const Vec2 u{std::sin(half), std::cos(half)}, v{-std::sin(half), std::cos(half)};
  for (Vec2& p : mesh.nodes) {
    const double bulge = 1.2 * step * p.x * p.y / n;  // the grid must reach in behind the flat corner
    p = (u * p.x + v * p.y) * step + Vec2{0, bulge};
  }
  return mesh;
}

TEST(CornerPillow, RelievesAFlatCorner) {
  PlanarMesh mesh = grid_with_flat_corner(10, 5, 166);
  const size_t elements = mesh.elements.size();
  const double before = worst_jacobian(mesh);
  ASSERT_LT(before, 0.3);
  EXPECT_EQ(relieve_flat_corners(mesh, nullptr, {5, 2.5}), 1);
  EXPECT_GT(worst_jacobian(mesh), before + 0.05);
  EXPECT_GT(mesh.elements.size(), elements);
  const int at_corner =
      int(std::count_if(mesh.elements.begin(), mesh.elements.end(),
                        [](const MeshElement& e) { return std::find(e.begin(), e.end(), 0) != e.end(); }));
  EXPECT_EQ(at_corner, 2);
}

TEST(CornerPillow, LeavesRealCornersAlone) {
  PlanarMesh mesh = grid_with_flat_corner(6, 5, 90);
  const PlanarMesh before = mesh;
  EXPECT_EQ(relieve_flat_corners(mesh, nullptr, {5, 2.5}), 0);
  EXPECT_EQ(mesh.nodes, before.nodes);
  EXPECT_EQ(mesh.elements, before.elements);
}

TEST(CornerPillow, KeepsTheMinimumElementLength) {
  PlanarMesh mesh = grid_with_flat_corner(6, 3, 166);  // no room for a ring at a minimum of 2.9
  const PlanarMesh before = mesh;
  relieve_flat_corners(mesh, nullptr, {3, 2.9});
  EXPECT_EQ(mesh.elements.size(), before.elements.size());
}

}  // namespace
}  // namespace beadmesh
