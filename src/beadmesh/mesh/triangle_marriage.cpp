#include "beadmesh/mesh/triangle_marriage.h"

#include <algorithm>
#include <array>
#include <optional>

namespace beadmesh {
namespace {

/// Ways from one triangle to the nearest others over shared edges.
class TriangleWays {
 public:
  explicit TriangleWays(const MeshEditor& editor) : editor_(editor), mesh_(editor.mesh()) {}

  /// Elements from `triangle` to each of up to `count` others, nearest first.
  std::vector<std::vector<Index>> from(Index triangle, size_t count) {
    std::vector<std::vector<Index>> ways;
    std::vector<Index> parent(mesh_.element_count(), no_index), queue = {triangle};
    parent[triangle] = triangle;
    for (size_t head = 0; head < queue.size() && ways.size() < count; ++head) {
      const Index e = queue[head];
      if (e != triangle && !is_quad(mesh_.element(e))) {
        ways.push_back(way_to(e, parent));
        continue;
      }
      const MeshElement& element = mesh_.element(e);
      for (int i = 0; i < corner_count(element); ++i) {
        const Index a = element[i], b = element[(i + 1) % corner_count(element)];
        const Index other = mesh_.element_with_edge(b, a);
        if (other == no_index || parent[other] != no_index || editor_.is_kept_edge(a, b)) continue;
        parent[other] = e;
        queue.push_back(other);
      }
    }
    return ways;
  }

 private:
  static std::vector<Index> way_to(Index end, const std::vector<Index>& parent) {
    std::vector<Index> way = {end};
    while (parent[way.back()] != way.back()) way.push_back(parent[way.back()]);
    std::reverse(way.begin(), way.end());
    return way;
  }

  const MeshEditor& editor_;
  const QuadConnectivity& mesh_;
};

/// The triangle on its way: where it is now, and the quads it left behind at the least cost.
struct Walker {
  MeshElement triangle;
  double cost = 0;
  std::vector<MeshElement> quads;
};

double shape_cost(const MeshEditor& editor, const MeshElement& element) {
  const double lack = 1 - signed_quality(editor.nodes(), element);
  return lack * lack;
}

/// Outline of two elements that share an edge, counter-clockwise; empty where they do not.
std::vector<Index> united(const MeshElement& a, const MeshElement& b) {
  const int count_a = corner_count(a), count_b = corner_count(b);
  for (int i = 0; i < count_a; ++i)
    for (int j = 0; j < count_b; ++j) {
      if (a[i] != b[(j + 1) % count_b] || a[(i + 1) % count_a] != b[j]) continue;
      std::vector<Index> outline;
      for (int k = 1; k <= count_a; ++k) outline.push_back(a[(i + k) % count_a]);
      for (int k = 2; k < count_b; ++k) outline.push_back(b[(j + k) % count_b]);
      return outline;
    }
  return {};
}

/// The edge by which `from` touches `to`, as it runs in `from`.
std::optional<std::pair<Index, Index>> shared_edge(const MeshElement& from, const MeshElement& to) {
  for (int i = 0; i < corner_count(from); ++i)
    for (int j = 0; j < corner_count(to); ++j) {
      const Index a = from[i], b = from[(i + 1) % corner_count(from)];
      if (a == to[(j + 1) % corner_count(to)] && b == to[j]) return std::pair{a, b};
    }
  return std::nullopt;
}

/// The two ways to cut the pentagon so that the triangle gets the edge `exit`.
std::vector<std::pair<MeshElement, MeshElement>> cuts(const std::vector<Index>& pentagon,
                                                      std::pair<Index, Index> exit) {
  std::vector<std::pair<MeshElement, MeshElement>> result;
  for (int i = 0; i < 5; ++i) {
    const auto at = [&](int k) { return pentagon[(i + k) % 5]; };
    const bool has_exit =
        (at(0) == exit.first && at(1) == exit.second) || (at(1) == exit.first && at(2) == exit.second);
    if (has_exit) result.push_back({{at(0), at(1), at(2), no_index}, {at(2), at(3), at(4), at(0)}});
  }
  return result;
}

/// The quads that the elements of a way become, with the least shape cost (dynamic programming over the two
/// cuts a step).
std::optional<std::vector<MeshElement>> married(const MeshEditor& editor, const std::vector<Index>& way) {
  const QuadConnectivity& mesh = editor.mesh();
  std::vector<Walker> walkers = {{mesh.element(way[0]), 0, {}}};
  for (size_t step = 1; step + 1 < way.size(); ++step) {
    const MeshElement& quad = mesh.element(way[step]);
    const auto exit = shared_edge(quad, mesh.element(way[step + 1]));
    if (!exit) return std::nullopt;
    std::vector<Walker> next;
    for (const Walker& walker : walkers)
      for (const auto& [triangle, left] : cuts(united(walker.triangle, quad), *exit)) {
        Walker moved = {triangle, walker.cost + shape_cost(editor, left), walker.quads};
        moved.quads.push_back(left);
        const auto same = std::find_if(next.begin(), next.end(),
                                       [&](const Walker& other) { return other.triangle == moved.triangle; });
        if (same == next.end())
          next.push_back(std::move(moved));
        else if (moved.cost < same->cost)
          *same = std::move(moved);
      }
    walkers = std::move(next);
  }
  std::optional<std::vector<MeshElement>> best;
  double least = 0;
  for (Walker& walker : walkers) {
    const std::vector<Index> outline = united(walker.triangle, mesh.element(way.back()));
    if (outline.size() != 4) continue;
    walker.quads.push_back({outline[0], outline[1], outline[2], outline[3]});
    walker.cost += shape_cost(editor, walker.quads.back());
    if (best && walker.cost >= least) continue;
    least = walker.cost;
    best = std::move(walker.quads);
  }
  return best;
}

}  // namespace

int marry_triangles(MeshEditor& editor) {
  constexpr size_t partners = 4;
  int pairs = 0;
  std::vector<Index> touched;
  for (Index e = 0; e < editor.mesh().element_count(); ++e) {
    if (!editor.mesh().is_alive(e) || is_quad(editor.mesh().element(e))) continue;
    for (const std::vector<Index>& way : TriangleWays(editor).from(e, partners)) {
      const auto quads = married(editor, way);
      if (!quads || !editor.try_replace({way, {}, *quads, {}}, EditAim::fewer_triangles, touched)) continue;
      ++pairs;
      break;
    }
  }
  return pairs;
}

}  // namespace beadmesh
