#include "beadmesh/panel/panel.h"

#include <algorithm>
#include <utility>

namespace beadmesh {
namespace {

template <class T>
void append(const std::vector<T>& from, std::vector<T>& to) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

Facets facets_of(const Panel& panel, const std::vector<Index>& faces) {
  if (faces.size() == 1) return panel.faces[faces.front()].facets;
  std::vector<Triangle> triangles;
  Facets sum;
  bool has_uv = true;
  for (const Index f : faces) {
    const Facets& facets = panel.faces[f].facets;
    for (const Triangle& t : facets.triangles)
      triangles.push_back({facets.panel_points[t[0]], facets.panel_points[t[1]], facets.panel_points[t[2]]});
    has_uv = has_uv && facets.triangle_uv.size() == facets.triangles.size();
    append(facets.triangle_uv, sum.triangle_uv);
    const Index first = static_cast<Index>(sum.surfaces.size());
    for (const Index surface : facets.triangle_surface) sum.triangle_surface.push_back(first + surface);
    append(facets.surfaces, sum.surfaces);
    if (facets.surfaces.empty()) sum.surfaces.push_back(nullptr);
  }
  Facets joined = facets_of_triangles(panel.points, triangles);
  if (has_uv) joined.triangle_uv = std::move(sum.triangle_uv);
  joined.triangle_surface = std::move(sum.triangle_surface);
  joined.surfaces = std::move(sum.surfaces);
  return joined;
}

Panel without_unused_points(Panel panel) {
  std::vector<Index> kept(panel.points.size(), no_index);
  const auto keep = [&](Index p) { kept[p] = 0; };
  for (const PanelEdge& edge : panel.edges) std::for_each(edge.points.begin(), edge.points.end(), keep);
  for (const PanelFace& face : panel.faces)
    std::for_each(face.facets.panel_points.begin(), face.facets.panel_points.end(), keep);
  std::vector<Vec3> points;
  for (std::size_t p = 0; p < kept.size(); ++p)
    if (kept[p] != no_index) {
      kept[p] = static_cast<Index>(points.size());
      points.push_back(panel.points[p]);
    }
  panel.points = std::move(points);
  for (PanelEdge& edge : panel.edges)
    for (Index& p : edge.points) p = kept[p];
  for (PanelFace& face : panel.faces)
    for (Index& p : face.facets.panel_points) p = kept[p];
  return panel;
}

std::vector<Index> input_numbers(const Panel& panel, const std::vector<Index>& faces) {
  std::vector<Index> numbers;
  for (const Index f : faces) {
    const PanelFace& face = panel.faces.at(f);
    if (face.numbers.empty())
      numbers.push_back(face.number);
    else
      append(face.numbers, numbers);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

std::size_t input_face_count(const Panel& panel) {
  std::size_t count = 0;
  for (const PanelFace& face : panel.faces) count += std::max<std::size_t>(face.numbers.size(), 1);
  return count;
}

double diagonal(const Panel& panel) {
  if (panel.points.empty()) return 0;
  Vec3 low = panel.points.front(), high = low;
  for (const Vec3 p : panel.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return distance(low, high);
}

}  // namespace beadmesh
