#include "beadmesh/flatten/triangle_topology.h"

#include <gtest/gtest.h>

#include <limits>

#include "flatten/facet_shapes.h"

namespace beadmesh {
namespace {

std::string code_of(const Facets& facets) {
  const auto result = check_disc(facets);
  return result ? "" : result.error().code;
}

Facets square() {
  return shapes::sheet(4, 4, [](double s, double t) { return Vec3{s, t, 0}; });
}

Facets tetrahedron() {
  Facets facets;
  facets.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  facets.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return facets;
}

/// A band of n cells, closed with or without a half turn.
Facets band(Index n, bool half_turn) {
  Facets facets;
  for (Index i = 0; i < n; ++i) {
    const double angle = 2 * pi * i / n, tilt = half_turn ? angle / 2 : 0;
    for (const double side : {-1.0, 1.0}) {
      const double r = 5 + side * std::cos(tilt);
      facets.points.push_back({r * std::cos(angle), r * std::sin(angle), side * std::sin(tilt)});
    }
  }
  for (Index i = 0; i < n; ++i) {
    const Index a = 2 * i, b = a + 1;
    Index c = 2 * ((i + 1) % n), d = c + 1;
    if (half_turn && i + 1 == n) std::swap(c, d);
    facets.triangles.push_back({a, b, c});
    facets.triangles.push_back({b, d, c});
  }
  return facets;
}

TEST(TriangleNeighbours, OfASquare) {
  const auto n = triangle_neighbours({{0, 1, 2}, {0, 2, 3}});
  EXPECT_EQ(n[0], (std::array<Index, 3>{no_index, no_index, 1}));
  EXPECT_EQ(n[1], (std::array<Index, 3>{0, no_index, no_index}));
}

TEST(CheckDisc, AcceptsDiscsWithHoles) {
  EXPECT_EQ(code_of(square()), "");
  const Facets holes = shapes::sheet(
      12, 12,
      [](double s, double t) {
        return Vec3{s, t, 0};
      },
      [](double s, double t) { return int(s * 12) % 3 != 1 || int(t * 12) % 3 != 1; });
  EXPECT_EQ(holes.loops.size(), 17u);
  EXPECT_EQ(code_of(holes), "");
  Facets ring = band(12, false);
  shapes::find_loops(ring);
  EXPECT_EQ(ring.loops.size(), 2u);
  EXPECT_EQ(code_of(ring), "");
}

TEST(CheckDisc, AcceptsBoundaryThatTouchesItselfInAVertex) {
  // Two holes that share a corner.
  Facets facets = shapes::sheet(
      6, 6,
      [](double s, double t) {
        return Vec3{s, t, 0};
      },
      [](double s, double t) {
        const int i = int(s * 6), j = int(t * 6);
        return !(i == 2 && j == 2) && !(i == 3 && j == 3);
      });
  facets.loops.clear();
  const auto at = [&](int i, int j) {
    for (std::size_t v = 0; v < facets.points.size(); ++v)
      if (norm(facets.points[v] - Vec3{i / 6.0, j / 6.0, 0}) < 1e-9) return static_cast<Index>(v);
    return no_index;
  };
  std::vector<Index> outer;
  for (int i = 0; i < 6; ++i) outer.push_back(at(i, 0));
  for (int i = 0; i < 6; ++i) outer.push_back(at(6, i));
  for (int i = 0; i < 6; ++i) outer.push_back(at(6 - i, 6));
  for (int i = 0; i < 6; ++i) outer.push_back(at(0, 6 - i));
  facets.loops = {outer, {at(2, 2), at(2, 3), at(3, 3), at(3, 2)}, {at(3, 3), at(3, 4), at(4, 4), at(4, 3)}};
  EXPECT_EQ(code_of(facets), "");
}

TEST(CheckDisc, RefusesWhatIsNoDisc) {
  EXPECT_EQ(code_of(tetrahedron()), "flatten.closed");
  EXPECT_EQ(code_of(band(12, true)), "flatten.not_manifold");
  Facets two = square();
  const auto shift = static_cast<Index>(two.points.size());
  const Facets other = square();
  for (const Vec3 p : other.points) two.points.push_back(p + Vec3{5, 0, 0});
  for (const Triangle& t : other.triangles)
    two.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  shapes::find_loops(two);
  EXPECT_EQ(code_of(two), "flatten.disconnected");
}

TEST(CheckDisc, RefusesAHandle) {
  // A torus with one cell left out.
  Facets facets;
  const Index n = 8;
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      const double u = 2 * pi * i / n, v = 2 * pi * j / n, r = 5 + std::cos(v);
      facets.points.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
    }
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i) {
      if (i == 0 && j == 0) continue;
      const Index a = j * n + i, b = j * n + (i + 1) % n, c = (j + 1) % n * n + i,
                  d = (j + 1) % n * n + (i + 1) % n;
      facets.triangles.push_back({a, b, d});
      facets.triangles.push_back({a, d, c});
    }
  shapes::find_loops(facets);
  EXPECT_EQ(code_of(facets), "flatten.not_a_disc");
}

TEST(CheckDisc, RefusesBadInput) {
  EXPECT_EQ(code_of({}), "flatten.input");
  Facets facets = square();
  facets.triangles[3][1] = 99;
  EXPECT_EQ(code_of(facets), "flatten.input");
  facets = square();
  facets.triangles[3][1] = facets.triangles[3][0];
  EXPECT_EQ(code_of(facets), "flatten.input");
  facets = square();
  facets.points[2].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code_of(facets), "flatten.input");
  facets = square();
  facets.points.push_back({9, 9, 9});
  EXPECT_EQ(code_of(facets), "flatten.input");
  facets = square();
  facets.triangles.push_back(facets.triangles[0]);
  EXPECT_EQ(code_of(facets), "flatten.not_manifold");
  facets = square();
  std::swap(facets.triangles[5][0], facets.triangles[5][1]);
  EXPECT_EQ(code_of(facets), "flatten.not_manifold");
  facets = square();
  facets.loops[0].pop_back();
  EXPECT_EQ(code_of(facets), "flatten.loops");
  facets = square();
  std::reverse(facets.loops[0].begin(), facets.loops[0].end());
  EXPECT_EQ(code_of(facets), "flatten.loops");
}

}  // namespace
}  // namespace beadmesh
