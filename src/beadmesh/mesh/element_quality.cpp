#include "beadmesh/mesh/element_quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "beadmesh/mesh/element_corners.h"

namespace beadmesh {
namespace {

double fold(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
  return angle_between(cross(b - a, c - a), cross(c - a, d - a));
}

struct EdgeUse {
  Index low, high;
  friend auto operator<=>(const EdgeUse&, const EdgeUse&) = default;
};

/// Every edge as often as elements use it, sorted.
std::vector<EdgeUse> edge_uses(const std::vector<MeshElement>& elements) {
  std::vector<EdgeUse> uses;
  uses.reserve(4 * elements.size());
  for (const MeshElement& element : elements) {
    const int count = corner_count(element);
    for (int i = 0; i < count; ++i) {
      const Index a = element[i], b = element[(i + 1) % count];
      uses.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(uses.begin(), uses.end());
  return uses;
}

void summarise_edges(const std::vector<Vec3>& nodes, const std::vector<EdgeUse>& uses, double min_edge,
                     QualitySummary& summary) {
  summary.edge_min = uses.empty() ? 0 : std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < uses.size(); ++i) {
    if (i > 0 && uses[i] == uses[i - 1]) continue;
    const double length = distance(nodes[uses[i].low], nodes[uses[i].high]);
    summary.edge_min = std::min(summary.edge_min, length);
    summary.edge_max = std::max(summary.edge_max, length);
    if (length < min_edge * (1 - 1e-6)) ++summary.edges_below_min;
  }
}

/// Inner nodes that do not have four quads and nothing else around them.
int count_irregular(size_t node_count, const std::vector<MeshElement>& elements,
                    const std::vector<EdgeUse>& uses) {
  std::vector<int> valence(node_count, 0);
  std::vector<bool> boundary(node_count, false), at_tria(node_count, false);
  for (const MeshElement& element : elements)
    for (int i = 0; i < corner_count(element); ++i) {
      ++valence[element[i]];
      if (!is_quad(element)) at_tria[element[i]] = true;
    }
  for (size_t i = 0; i < uses.size(); ++i) {
    const bool alone = (i == 0 || uses[i - 1] != uses[i]) && (i + 1 == uses.size() || uses[i + 1] != uses[i]);
    if (alone) boundary[uses[i].low] = boundary[uses[i].high] = true;
  }
  int irregular = 0;
  for (size_t node = 0; node < node_count; ++node)
    if (valence[node] > 0 && !boundary[node] && (valence[node] != 4 || at_tria[node])) ++irregular;
  return irregular;
}

}  // namespace

Vec3 area_normal(const std::vector<Vec3>& nodes, const MeshElement& element) {
  const Vec3 a = nodes[element[0]], b = nodes[element[1]], c = nodes[element[2]];
  return is_quad(element) ? cross(c - a, nodes[element[3]] - b) : cross(b - a, c - a);
}

double scaled_jacobian(const std::vector<Vec3>& nodes, const MeshElement& element) {
  const Vec3 normal = normalized(area_normal(nodes, element));
  const int count = corner_count(element);
  double worst = std::numeric_limits<double>::infinity();
  for (int i = 0; i < count; ++i) {
    const Vec3 corner = nodes[element[i]];
    const Vec3 next = nodes[element[(i + 1) % count]] - corner;
    const Vec3 previous = nodes[element[(i + count - 1) % count]] - corner;
    const double scale = norm(next) * norm(previous);
    worst = std::min(worst, scale > 0 ? dot(cross(next, previous), normal) / scale : 0.0);
  }
  return count == 4 ? worst : worst * 2 / std::sqrt(3.0);
}

double jacobian_ratio(const std::array<double, 4>& corner_areas) {
  return evenness_of(corner_areas);
}

double jacobian_ratio(const std::vector<Vec3>& nodes, const MeshElement& element) {
  if (!is_quad(element)) return 1;
  const Vec3 normal = normalized(area_normal(nodes, element));
  std::array<double, 4> areas;
  for (int i = 0; i < 4; ++i) {
    const Vec3 corner = nodes[element[i]];
    areas[i] = dot(cross(nodes[element[(i + 1) % 4]] - corner, nodes[element[(i + 3) % 4]] - corner), normal);
  }
  return jacobian_ratio(areas);
}

std::array<double, 2> corner_angles(const std::vector<Vec3>& nodes, const MeshElement& element) {
  const int count = corner_count(element);
  std::array<double, 2> range = {std::numeric_limits<double>::infinity(), 0};
  for (int i = 0; i < count; ++i) {
    const Vec3 corner = nodes[element[i]];
    const double angle = angle_between(nodes[element[(i + 1) % count]] - corner,
                                       nodes[element[(i + count - 1) % count]] - corner);
    range = {std::min(range[0], angle), std::max(range[1], angle)};
  }
  return range;
}

double warpage(const std::vector<Vec3>& nodes, const MeshElement& element) {
  if (!is_quad(element)) return 0;
  const Vec3 a = nodes[element[0]], b = nodes[element[1]], c = nodes[element[2]], d = nodes[element[3]];
  return std::max(fold(a, b, c, d), fold(b, c, d, a));
}

std::array<double, 2> side_lengths(const std::vector<Vec3>& nodes, const MeshElement& element) {
  const int count = corner_count(element);
  std::array<double, 2> range = {std::numeric_limits<double>::infinity(), 0};
  for (int i = 0; i < count; ++i) {
    const double length = distance(nodes[element[i]], nodes[element[(i + 1) % count]]);
    range = {std::min(range[0], length), std::max(range[1], length)};
  }
  return range;
}

QualitySummary summarise(const std::vector<Vec3>& nodes, const std::vector<MeshElement>& elements,
                         double min_edge) {
  QualitySummary summary;
  summary.nodes = static_cast<int>(nodes.size());
  double sum = 0;
  for (const MeshElement& element : elements) {
    ++(is_quad(element) ? summary.quads : summary.trias);
    const double jacobian = scaled_jacobian(nodes, element);
    summary.scaled_jacobian_min = std::min(summary.scaled_jacobian_min, jacobian);
    sum += jacobian;
    if (!(jacobian > 0)) ++summary.inverted;
    const double bend = degrees(warpage(nodes, element));
    summary.warpage_max = std::max(summary.warpage_max, bend);
    if (bend > 15) ++summary.warped_over_15;
  }
  if (!elements.empty()) summary.scaled_jacobian_mean = sum / static_cast<double>(elements.size());
  const std::vector<EdgeUse> uses = edge_uses(elements);
  summarise_edges(nodes, uses, min_edge, summary);
  summary.irregular = count_irregular(nodes.size(), elements, uses);
  return summary;
}

}  // namespace beadmesh
