// Walking a medial object from vertex to vertex (medial_query.h).
#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "beadmesh/medial/medial_query.h"

namespace beadmesh {
namespace {

/// Direction in which a way leaves its vertex: towards the first point that is somewhere else.
Vec2 leaving_direction(const MedialObject& object, Departure way) {
  const std::vector<MedialPoint>& points = object.edges[way.edge].points;
  const Vec2 here = way.forward ? points.front().point : points.back().point;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 next = points[way.forward ? i : points.size() - 1 - i].point;
    if (next != here) return next - here;
  }
  return {1, 0};
}

}  // namespace

std::vector<Departure> departures(const MedialObject& object, Index vertex) {
  std::vector<Departure> ways;
  std::vector<Index> edges = object.vertices[vertex].edges;
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (const Index e : edges) {
    if (object.edges[e].start == vertex) ways.push_back({e, true});
    if (object.edges[e].end == vertex) ways.push_back({e, false});
  }
  const auto angle = [&](Departure way) {
    const Vec2 d = leaving_direction(object, way);
    return std::atan2(d.y, d.x);
  };
  std::stable_sort(ways.begin(), ways.end(), [&](Departure a, Departure b) { return angle(a) < angle(b); });
  const auto first = std::find_if(ways.begin(), ways.end(), [&](Departure way) {
    return way.edge == object.vertices[vertex].edges.front();
  });
  std::rotate(ways.begin(), first, ways.end());
  return ways;
}

Index arrival(const MedialObject& object, Departure way) {
  const MedialEdge& edge = object.edges[way.edge];
  return way.forward ? edge.end : edge.start;
}

Index other_end(const MedialObject& object, Index edge, Index vertex) {
  const MedialEdge& e = object.edges[edge];
  return e.start == vertex ? e.end : e.end == vertex ? e.start : no_index;
}

MedialPoint point_along(const MedialObject& object, Departure way, double distance) {
  const MedialEdge& edge = object.edges[way.edge];
  if (way.forward) return point_at(edge, distance);
  MedialPoint point = point_at(edge, edge.length - distance);
  std::swap(point.feet[0], point.feet[1]);  // left and right change places
  return point;
}

std::vector<MedialPoint> even_points(const MedialEdge& edge, int count) {
  std::vector<MedialPoint> points;
  const bool closed = edge.type == MedialEdgeType::N;
  if (count == 1) return {point_at(edge, closed ? 0 : edge.length / 2)};
  for (int i = 0; i < count; ++i)
    points.push_back(point_at(edge, edge.length * i / (closed ? count : count - 1)));
  return points;
}

std::vector<Departure> path_between(const MedialObject& object, Index from, Index to) {
  std::vector<double> far(object.vertices.size(), std::numeric_limits<double>::infinity());
  std::vector<Departure> by(object.vertices.size());
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  far[from] = 0;
  queue.push({0, from});
  while (!queue.empty() && queue.top().second != to) {
    const auto [d, vertex] = queue.top();
    queue.pop();
    if (d > far[vertex]) continue;
    for (const Departure way : departures(object, vertex)) {
      const Index next = arrival(object, way);
      const double length = d + object.edges[way.edge].length;
      if (length < far[next]) far[next] = length, by[next] = way, queue.push({length, next});
    }
  }
  std::vector<Departure> path;
  if (!std::isfinite(far[to])) return path;
  for (Index at = to; at != from; at = arrival(object, {path.back().edge, !path.back().forward}))
    path.push_back(by[at]);
  std::reverse(path.begin(), path.end());
  return path;
}

double total_length(const MedialObject& object) {
  double sum = 0;
  for (const MedialEdge& edge : object.edges) sum += edge.length;
  return sum;
}

double total_length(const MedialObject& object, const std::vector<Departure>& path) {
  double sum = 0;
  for (const Departure way : path) sum += object.edges[way.edge].length;
  return sum;
}

}  // namespace beadmesh
