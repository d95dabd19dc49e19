#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Segment_Delaunay_graph_filtered_traits_2.h>
#include <CGAL/Segment_Delaunay_graph_hierarchy_2.h>

#include "candidates.h"

namespace beadmesh::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;
using SegmentGraph = CGAL::Segment_Delaunay_graph_hierarchy_2<
    CGAL::Segment_Delaunay_graph_filtered_traits_without_intersections_2<Kernel>>;

struct PointsAndPairs {
  std::vector<Kernel::Point_2> points;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
};

PointsAndPairs points_and_pairs(const PlanarRegion& region) {
  PointsAndPairs input;
  for (const PlanarLoop& loop : region.loops) {
    const std::size_t first = input.points.size(), n = loop.points.size();
    for (std::size_t i = 0; i < n; ++i) {
      input.points.emplace_back(loop.points[i].x, loop.points[i].y);
      input.pairs.emplace_back(first + i, first + (i + 1) % n);
    }
  }
  return input;
}

/// The range insertion sorts the points along a space-filling curve.
Run prepared_triangulation(const PlanarRegion& region) {
  return [input = points_and_pairs(region)] {
    Cdt triangulation;
    triangulation.insert_constraints(input.points.begin(), input.points.end(), input.pairs.begin(),
                                     input.pairs.end());
    return std::to_string(triangulation.number_of_faces()) + " triangles with the outside";
  };
}

Run prepared_segment_graph(const PlanarRegion& region) {
  return [input = points_and_pairs(region)] {
    SegmentGraph graph;
    graph.insert_segments(input.points.begin(), input.points.end(), input.pairs.begin(), input.pairs.end());
    return std::to_string(graph.number_of_faces()) + " faces";
  };
}

}  // namespace

std::vector<Candidate> cgal_candidates() {
  return {{"CGAL CDT", prepared_triangulation},
          {"CGAL segment Delaunay graph", prepared_segment_graph, 10'000, true}};
}

}  // namespace beadmesh::bench
