#include "boost_axis.h"

#include <algorithm>
#include <boost/polygon/point_data.hpp>
#include <boost/polygon/segment_data.hpp>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace beadmesh::oracle {
namespace {

using Point = boost::polygon::point_data<std::int32_t>;
using Segment = boost::polygon::segment_data<std::int32_t>;
using Diagram = boost::polygon::voronoi_diagram<double>;

Point grid_point(Vec2 p) {
  if (p.x != std::round(p.x) || p.y != std::round(p.y) || std::max(std::abs(p.x), std::abs(p.y)) > 0x1p30)
    throw std::invalid_argument("not on the grid");
  return {static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y)};
}

Vec2 plane_point(const Point& p) {
  return {static_cast<double>(p.x()), static_cast<double>(p.y())};
}

Vec2 position(const Diagram::vertex_type* vertex) {
  return {vertex->x(), vertex->y()};
}

class Converter {
 public:
  explicit Converter(const PlanarRegion& region) : region_(region) {
    for (const PlanarLoop& loop : region.loops)
      for (std::size_t i = 0; i < loop.points.size(); ++i)
        segments_.push_back(
            {grid_point(loop.points[i]), grid_point(loop.points[(i + 1) % loop.points.size()])});
    boost::polygon::construct_voronoi(segments_.begin(), segments_.end(), &diagram_);
  }

  std::vector<AxisArc> run() const {
    std::vector<AxisArc> arcs;
    for (const Diagram::edge_type& edge : diagram_.edges()) {
      if (&edge > edge.twin() || !edge.is_primary() || !edge.is_finite()) continue;
      const AxisArc arc = edge.is_curved() ? parabola(edge) : straight(edge);
      if (contains(region_, arc.at(0.5))) arcs.push_back(arc);
    }
    return arcs;
  }

 private:
  static AxisArc straight(const Diagram::edge_type& edge) {
    AxisArc arc;
    arc.from = position(edge.vertex0());
    arc.to = position(edge.vertex1());
    return arc;
  }

  AxisArc parabola(const Diagram::edge_type& edge) const {
    AxisArc arc = straight(edge);
    const bool point_first = edge.cell()->contains_point();
    const auto& point_cell = point_first ? *edge.cell() : *edge.twin()->cell();
    const auto& line_cell = point_first ? *edge.twin()->cell() : *edge.cell();
    const Segment& owner = segments_[point_cell.source_index()];
    const bool is_start = point_cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;
    const Vec2 focus = plane_point(is_start ? owner.low() : owner.high());
    const Segment& line = segments_[line_cell.source_index()];
    const Vec2 a = plane_point(line.low());
    arc.along = normalized(plane_point(line.high()) - a);
    arc.height = cross(arc.along, focus - a);
    if (arc.height < 0) {
      arc.along = -arc.along;
      arc.height = -arc.height;
    }
    arc.origin = a + arc.along * dot(arc.along, focus - a);
    arc.first = dot(arc.along, arc.from - arc.origin);
    arc.last = dot(arc.along, arc.to - arc.origin);
    return arc;
  }

  const PlanarRegion& region_;
  std::vector<Segment> segments_;
  Diagram diagram_;
};

}  // namespace

Vec2 AxisArc::at(double t) const {
  if (!is_curved()) return lerp(from, to, t);
  const double x = std::lerp(first, last, t);
  return origin + along * x + left_normal(along) * ((x * x + height * height) / (2 * height));
}

double AxisArc::distance_to(Vec2 p) const {
  if (!is_curved()) {
    const Vec2 d = to - from;
    const double length2 = dot(d, d), t = length2 > 0 ? std::clamp(dot(p - from, d) / length2, 0.0, 1.0) : 0;
    return distance(p, lerp(from, to, t));
  }
  constexpr int samples = 64;
  int nearest = 0;
  for (int i = 1; i <= samples; ++i)
    if (distance(p, at(static_cast<double>(i) / samples)) <
        distance(p, at(static_cast<double>(nearest) / samples)))
      nearest = i;
  double low = std::max(0, nearest - 1) / static_cast<double>(samples),
         high = std::min(samples, nearest + 1) / static_cast<double>(samples);
  for (int i = 0; i < 80; ++i) {  // ternary search: the distance has one minimum between the neighbours
    const double a = (2 * low + high) / 3, b = (low + 2 * high) / 3;
    if (distance(p, at(a)) < distance(p, at(b)))
      high = b;
    else
      low = a;
  }
  return distance(p, at((low + high) / 2));
}

std::vector<AxisArc> boost_axis(const PlanarRegion& region) {
  return Converter(region).run();
}

}  // namespace beadmesh::oracle
