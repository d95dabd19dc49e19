// Our constrained Delaunay triangulation against CGAL's.
#include "beadmesh/delaunay/triangulation.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "beadmesh/geometry/predicates.h"
#include "random_domains.h"

namespace beadmesh::oracle {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Cdt =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel,
                                               CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;
using Edge = std::pair<Index, Index>;

Edge edge_of(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

struct Input {
  std::vector<Vec2> points;
  std::vector<std::vector<Index>> loops;
};

Input input_of(const PlanarRegion& region) {
  Input input;
  for (const PlanarLoop& loop : region.loops) {
    auto& indices = input.loops.emplace_back();
    for (const Vec2 p : loop.points) {
      indices.push_back(static_cast<Index>(input.points.size()));
      input.points.push_back(p);
    }
  }
  return input;
}

/// Points inside triangles of the region.
void add_inner_points(Input& input, int count, std::uint64_t seed) {
  const auto coarse = triangulate(input.points, input.loops).value();
  Random random(seed);
  for (int i = 0; i < count; ++i) {
    const Triangle& t = coarse.triangles[random.below(static_cast<int>(coarse.triangles.size()))];
    const double a = random.between(0.1, 0.45), b = random.between(0.1, 0.45);
    input.points.push_back(input.points[t[0]] * a + input.points[t[1]] * b +
                           input.points[t[2]] * (1 - a - b));
  }
}

/// Faces inside the region: an odd number of constraints away from the outside.
struct Reference {
  std::set<Edge> edges;
  std::size_t triangles = 0;
};

void mark_levels(Cdt& cdt) {
  for (const auto face : cdt.all_face_handles()) face->info() = -1;
  std::vector<Cdt::Face_handle> level{cdt.infinite_face()}, next;
  for (int number = 0; !level.empty(); ++number, level.swap(next), next.clear())
    while (!level.empty()) {
      const Cdt::Face_handle face = level.back();
      level.pop_back();
      if (face->info() != -1) continue;
      face->info() = number;
      for (int i = 0; i < 3; ++i)
        if (face->neighbor(i)->info() == -1)
          (cdt.is_constrained({face, i}) ? next : level).push_back(face->neighbor(i));
    }
}

Reference reference(const Input& input) {
  Cdt cdt;
  std::vector<Cdt::Vertex_handle> vertices;
  for (std::size_t i = 0; i < input.points.size(); ++i) {
    vertices.push_back(cdt.insert({input.points[i].x, input.points[i].y}));
    vertices.back()->info() = static_cast<Index>(i);
  }
  for (const auto& loop : input.loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      cdt.insert_constraint(vertices[loop[i]], vertices[loop[(i + 1) % loop.size()]]);
  mark_levels(cdt);
  Reference result;
  for (const auto face : cdt.finite_face_handles()) {
    if (face->info() % 2 == 0) continue;
    ++result.triangles;
    for (int i = 0; i < 3; ++i)
      result.edges.insert(edge_of(face->vertex(Cdt::cw(i))->info(), face->vertex(Cdt::ccw(i))->info()));
  }
  return result;
}

/// An edge that only one of the two has must be the diagonal of points on one circle. Returns their number.
int expect_only_ties(const Triangulation& ours, const Reference& theirs) {
  int ties = 0;
  EXPECT_EQ(ours.triangles.size(), theirs.triangles);
  for (std::size_t t = 0; t < ours.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Triangle& corners = ours.triangles[t];
      const Index a = corners[(k + 1) % 3], b = corners[(k + 2) % 3], across = ours.neighbours[t][k];
      if (theirs.edges.contains(edge_of(a, b))) continue;
      ++ties;
      EXPECT_NE(across, no_index) << "a constraint that CGAL does not have: " << a << ", " << b;
      if (across == no_index) continue;
      for (const Index d : ours.triangles[across]) {
        const auto& p = ours.points;
        EXPECT_EQ(incircle(p[corners[0]], p[corners[1]], p[corners[2]], p[d]), 0) << a << ", " << b;
      }
    }
  return ties;
}

int compare(const Input& input) {
  const auto ours = triangulate(input.points, input.loops);
  EXPECT_TRUE(ours) << to_line(ours.error());
  return ours ? expect_only_ties(*ours, reference(input)) : -1;
}

TEST(TriangulationOracle, random_stars_with_holes) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const auto region = checked_region(random_region(seed, 8 + 3 * static_cast<int>(seed)));
    ASSERT_TRUE(region) << to_line(region.error());
    EXPECT_EQ(compare(input_of(*region)), 0) << "no four points on a circle are to be expected";
  }
}

TEST(TriangulationOracle, inner_points) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    const auto region = checked_region(random_region(seed, 60));
    ASSERT_TRUE(region) << to_line(region.error());
    Input input = input_of(*region);
    add_inner_points(input, 400, seed);
    EXPECT_EQ(compare(input), 0);
  }
}

TEST(TriangulationOracle, ties) {
  int ties = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const auto region = checked_region(random_skyline(seed, 4 + 2 * static_cast<int>(seed)));
    ASSERT_TRUE(region) << to_line(region.error());
    ties += compare(input_of(*region));
  }
  EXPECT_GT(ties, 0) << "the case is there for its ties";
}

TEST(TriangulationOracle, letters) {
  for (const NamedRegion& letter : letters())
    for (const double angle : {0.0, 0.3}) {
      SCOPED_TRACE(letter.name);
      const auto region = checked_region(on_grid(letter.region, angle, 20));
      ASSERT_TRUE(region) << to_line(region.error());
      EXPECT_GE(compare(input_of(*region)), 0);
    }
}

}  // namespace
}  // namespace beadmesh::oracle
