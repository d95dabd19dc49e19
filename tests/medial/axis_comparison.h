// Whether two medial objects are the same graph, up to numbering and small
// differences of the geometry.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "beadmesh/medial/medial_object.h"

namespace beadmesh {

using MedialCounts = std::map<std::string, int>;

inline MedialCounts medial_counts(const MedialObject& object) {
  MedialCounts counts;
  for (const MedialVertex& vertex : object.vertices) ++counts[name_of(vertex.type)];
  for (const MedialEdge& edge : object.edges) ++counts[name_of(edge.type)];
  return counts;
}

/// Edges minus vertices plus pieces: the number of independent cycles. A closed
/// edge is a piece and a cycle.
inline Index cycles(const MedialObject& object) {
  std::vector<std::size_t> parent(object.vertices.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](Index of) {
    auto i = static_cast<std::size_t>(of);
    while (parent[i] != i) i = parent[i];
    return i;
  };
  Index result = 0;
  for (const MedialEdge& edge : object.edges) {
    if (edge.start == no_index || root(edge.start) == root(edge.end))
      ++result;
    else
      parent[root(edge.start)] = root(edge.end);
  }
  return result;
}

/// Pairs every vertex of `a` with the nearest one of `b` after `map`, one to
/// one, and compares types, degrees, radii, and the edges between them with
/// their types, lengths and thicknesses. The differences in words.
inline std::vector<std::string> differences(const MedialObject& a, const MedialObject& b,
                                            const std::function<Vec2(Vec2)>& map, double scale,
                                            double tolerance, double thickness_tolerance) {
  std::vector<std::string> result;
  const auto differ = [&](auto... parts) {
    std::ostringstream text;
    ((text << parts << ' '), ...);
    result.push_back(text.str());
  };
  if (a.vertices.size() != b.vertices.size() || a.edges.size() != b.edges.size()) {
    differ(a.vertices.size(), "vertices and", a.edges.size(), "edges, or", b.vertices.size(), "and",
           b.edges.size());
    return result;
  }
  std::vector<Index> partner(a.vertices.size(), no_index), taken(b.vertices.size(), 0);
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    const Vec2 at = map(a.vertices[i].point);
    const auto near = std::min_element(
        b.vertices.begin(), b.vertices.end(),
        [&](const auto& u, const auto& v) { return distance(u.point, at) < distance(v.point, at); });
    partner[i] = static_cast<Index>(near - b.vertices.begin());
    if (taken[partner[i]]++) differ("two vertices near", at.x, at.y);
    if (near->type != a.vertices[i].type || near->edges.size() != a.vertices[i].edges.size())
      differ("type or degree at", at.x, at.y);
    if (!(distance(near->point, at) <= tolerance) ||
        !(std::abs(near->radius - scale * a.vertices[i].radius) <= tolerance))
      differ("vertex", i, "moved by", distance(near->point, at), "radius by",
             near->radius - scale * a.vertices[i].radius);
  }
  // Edges as sorted lists, since two may join the same vertices.
  using Attributes = std::tuple<Index, Index, MedialEdgeType, double, double, double, double>;
  const auto listed = [](const MedialObject& object, const std::function<Index(Index)>& number,
                         double factor) {
    std::vector<Attributes> list;
    for (const MedialEdge& edge : object.edges) {
      const Index u = number(edge.start), v = number(edge.end);
      list.emplace_back(std::min(u, v), std::max(u, v), edge.type, factor * edge.length,
                        factor * edge.thickness.min, factor * edge.thickness.mean,
                        factor * edge.thickness.max);
    }
    std::sort(list.begin(), list.end());
    return list;
  };
  const auto of_a = listed(
                 a, [&](Index i) { return i == no_index ? i : partner[i]; }, scale),
             of_b = listed(
                 b, [](Index i) { return i; }, 1);
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    const auto& [u, v, type, length, least, mean, most] = of_a[i];
    const auto& [u2, v2, type2, length2, least2, mean2, most2] = of_b[i];
    if (u != u2 || v != v2 || type != type2) differ("edge", i, "joins other vertices or has another type");
    if (!(std::abs(length - length2) <= 4 * tolerance))
      differ("edge", i, "length differs by", length - length2);
    const std::pair<const char*, double> measures[] = {
        {"least", least - least2}, {"mean", mean - mean2}, {"greatest", most - most2}};
    for (const auto& [measure, by] : measures)
      if (!(std::abs(by) <= thickness_tolerance)) differ("edge", i, measure, "thickness differs by", by);
  }
  return result;
}

}  // namespace beadmesh
