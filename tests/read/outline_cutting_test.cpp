#include "beadmesh/read/outline_cutting.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "beadmesh/read/outline_lines.h"

namespace beadmesh {
namespace {

/// A flat grid of triangles whose facets belong to a disc where their centres do.
struct GriddedDisc {
  FacetMesh mesh;
  FacetGroups groups;
};

constexpr double disc_radius = 15;

GriddedDisc gridded_disc(double step) {
  const int cells = int(40 / step);
  const auto point = [&](int i, int j) { return Vec3{i * step - 20, j * step - 20, 0}; };
  LooseFacets facets;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      facets.corners.push_back({point(i, j), point(i + 1, j), point(i + 1, j + 1)});
      facets.corners.push_back({point(i, j), point(i + 1, j + 1), point(i, j + 1)});
    }
  GriddedDisc disc;
  disc.mesh = weld_facets(facets);
  disc.groups.is_feature = {false, true};
  for (Index t = 0; t < disc.mesh.triangle_count(); ++t)
    disc.groups.face.push_back(norm(disc.mesh.centre(t)) < disc_radius ? 1 : 0);
  return disc;
}

/// Points on edges between the two faces.
std::vector<Vec3> outline(const GriddedDisc& disc) {
  std::vector<Vec3> points;
  for (Index h = 0; h < 3 * disc.mesh.triangle_count(); ++h)
    if (disc.mesh.beyond(h) != no_index && disc.groups.face[h / 3] == 1 &&
        disc.groups.face[disc.mesh.beyond(h)] == 0)
      points.push_back(disc.mesh.points[disc.mesh.tail(h)]);
  return points;
}

double unevenness(const std::vector<Vec3>& points) {
  double least = 1e9, most = 0;
  for (const Vec3 p : points) least = std::min(least, norm(p)), most = std::max(most, norm(p));
  return most - least;
}

TEST(OutlineCutting, StaircaseBecomesACircle) {
  GriddedDisc disc = gridded_disc(1.25);
  EXPECT_GT(unevenness(outline(disc)), 1.2);
  cut_along_outlines(disc.mesh, disc.groups);
  EXPECT_LT(unevenness(outline(disc)), 0.6);
}

TEST(OutlineCutting, LosesNoFacetAndTurnsNoneOver) {
  GriddedDisc disc = gridded_disc(1);
  cut_along_outlines(disc.mesh, disc.groups);
  ASSERT_EQ(disc.groups.face.size(), disc.mesh.triangles.size());
  ASSERT_EQ(disc.mesh.parts.size(), disc.mesh.triangles.size());
  double area = 0, inside = 0;
  for (Index t = 0; t < disc.mesh.triangle_count(); ++t) {
    EXPECT_GT(disc.mesh.area_vectors[t].z, 0);
    area += disc.mesh.area(t);
    inside += disc.groups.face[t] == 1 ? disc.mesh.area(t) : 0;
  }
  EXPECT_NEAR(area, 1600, 1e-6);
  EXPECT_NEAR(inside / (pi * disc_radius * disc_radius), 1, 0.02);
}

TEST(OutlineCutting, EdgesStayWatertight) {
  GriddedDisc disc = gridded_disc(1);
  cut_along_outlines(disc.mesh, disc.groups);
  std::map<std::pair<Index, Index>, int> uses;
  for (Index h = 0; h < 3 * disc.mesh.triangle_count(); ++h)
    ++uses[std::minmax(disc.mesh.tail(h), disc.mesh.head(h))];
  int free_edges = 0;
  for (const auto& [edge, count] : uses) {
    EXPECT_LE(count, 2);
    free_edges += count == 1;
  }
  EXPECT_EQ(free_edges, 160);
}

TEST(OutlineCutting, SmoothOutlineStaysAsItIs) {
  GriddedDisc disc = gridded_disc(1);
  for (Index t = 0; t < disc.mesh.triangle_count(); ++t) {
    const Vec3 c = disc.mesh.centre(t);
    disc.groups.face[t] = std::max(std::abs(c.x), std::abs(c.y)) < 10 ? 1 : 0;
  }
  const FacetMesh before = disc.mesh;
  cut_along_outlines(disc.mesh, disc.groups);
  EXPECT_EQ(before.points, disc.mesh.points);
  EXPECT_EQ(before.triangles, disc.mesh.triangles);
}

TEST(OutlineCutting, IsletGoesToTheFaceAroundIt) {
  GriddedDisc disc = gridded_disc(1);
  Index far = 0;
  for (Index t = 0; t < disc.mesh.triangle_count(); ++t)
    if (distance(disc.mesh.centre(t), Vec3{17, 17, 0}) < distance(disc.mesh.centre(far), Vec3{17, 17, 0}))
      far = t;
  disc.groups.face[far] = 1;
  cut_along_outlines(disc.mesh, disc.groups);
  EXPECT_EQ(disc.groups.face[far], 0);
}

}  // namespace
}  // namespace beadmesh
