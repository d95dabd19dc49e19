#include <algorithm>
#include <boost/polygon/point_data.hpp>
#include <boost/polygon/segment_data.hpp>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>
#include <utility>

#include "candidates.h"

namespace beadmesh::bench {
namespace {

using IntegerPoint = boost::polygon::point_data<std::int32_t>;
using IntegerSegment = boost::polygon::segment_data<std::int32_t>;

struct Grid {
  std::vector<IntegerSegment> segments;
  Vec2 origin;
  double scale = 1;
};

/// Boost takes 32-bit integers: the region is stretched to 2^28 on its longer side.
Grid on_grid(const PlanarRegion& region) {
  Vec2 low = region.loops[0].points[0], high = low;
  for (const PlanarLoop& loop : region.loops)
    for (const Vec2 p : loop.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  const double scale = std::ldexp(1.0, 28) / std::max(high.x - low.x, high.y - low.y);
  const auto rounded = [&](Vec2 p) {
    return IntegerPoint{static_cast<std::int32_t>(std::lround((p.x - low.x) * scale)),
                        static_cast<std::int32_t>(std::lround((p.y - low.y) * scale))};
  };
  std::vector<IntegerSegment> segments;
  for (const PlanarLoop& loop : region.loops)
    for (std::size_t i = 0; i < loop.points.size(); ++i)
      segments.push_back({rounded(loop.points[i]), rounded(loop.points[(i + 1) % loop.points.size()])});
  return {std::move(segments), low, scale};
}

Run prepared_voronoi(const PlanarRegion& region) {
  return [segments = on_grid(region).segments] {
    boost::polygon::voronoi_diagram<double> diagram;
    boost::polygon::construct_voronoi(segments.begin(), segments.end(), &diagram);
    return std::to_string(diagram.num_edges()) + " half-edges";
  };
}

/// Distance of a vertex from the boundary as its diagram has it: from the site of one of its cells.
double radius_of(const boost::polygon::voronoi_vertex<double>& vertex,
                 const std::vector<IntegerSegment>& segments) {
  const auto& cell = *vertex.incident_edge()->cell();
  const IntegerSegment& site = segments[cell.source_index()];
  const Vec2 p{vertex.x(), vertex.y()}, low{1.0 * site.low().x(), 1.0 * site.low().y()},
      high{1.0 * site.high().x(), 1.0 * site.high().y()};
  if (cell.contains_segment()) return std::abs(cross(high - low, p - low)) / distance(low, high);
  const bool is_low = cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;
  return distance(p, is_low ? low : high);
}

}  // namespace

std::vector<Disc> boost_discs(const PlanarRegion& region) {
  const Grid grid = on_grid(region);
  boost::polygon::voronoi_diagram<double> diagram;
  boost::polygon::construct_voronoi(grid.segments.begin(), grid.segments.end(), &diagram);
  std::vector<Disc> discs;
  for (const auto& vertex : diagram.vertices())
    discs.push_back({Vec2{vertex.x(), vertex.y()} / grid.scale + grid.origin,
                     radius_of(vertex, grid.segments) / grid.scale});
  return discs;
}

std::vector<Candidate> boost_candidates() {
  return {{"Boost Voronoi", prepared_voronoi}};
}

}  // namespace beadmesh::bench
