#include "beadmesh/mesh/corner_pillow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "beadmesh/mesh/element_quality.h"

namespace beadmesh {
namespace {

/// A grid whose lower left corner is bent open until its boundary runs nearly straight through it.
PlanarMesh grid_with_flat_corner(int n, double step, double corner_degrees) {
  PlanarMesh mesh;
  const double half = radians(corner_degrees) / 2;
  const Vec2 u{std::sin(half), std::cos(half)}, v{-std::sin(half), std::cos(half)};
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const double bulge = 1.2 * step * i * j / n;  // the grid must reach in behind the flat corner
      mesh.nodes.push_back((u * i + v * j) * step + Vec2{0, bulge});
      const bool boundary = i == 0 || j == 0 || i == n || j == n;
      mesh.freedom.push_back(boundary ? NodeFreedom::fixed : NodeFreedom::free);
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Index a = j * (n + 1) + i;
      mesh.elements.push_back({a, a + 1, a + n + 2, a + n + 1});
    }
  return mesh;
}

double worst_jacobian(const PlanarMesh& mesh) {
  std::vector<Vec3> space;
  for (Vec2 p : mesh.nodes) space.push_back({p.x, p.y, 0});
  double worst = 1;
  for (const MeshElement& e : mesh.elements) worst = std::min(worst, scaled_jacobian(space, e));
  return worst;
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
