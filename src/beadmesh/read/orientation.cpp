#include "beadmesh/read/orientation.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace beadmesh {
namespace {

struct Neighbour {
  Index face;
  bool disagrees;  // both run the same way through the shared edge
};

std::vector<std::vector<Neighbour>> neighbours_of(const Panel& panel) {
  std::vector<std::vector<std::pair<Index, bool>>> uses(panel.edges.size());
  for (Index f = 0; f < static_cast<Index>(panel.faces.size()); ++f)
    for (const std::vector<EdgeUse>& loop : panel.faces[f].loops)
      for (const EdgeUse use : loop) uses[use.edge].push_back({f, use.reversed});
  std::vector<std::vector<Neighbour>> result(panel.faces.size());
  for (const auto& use : uses) {
    if (use.size() != 2 || use[0].first == use[1].first) continue;
    const bool disagrees = use[0].second == use[1].second;
    result[use[0].first].push_back({use[1].first, disagrees});
    result[use[1].first].push_back({use[0].first, disagrees});
  }
  return result;
}

/// Gives every face of the piece of `seed` a side; returns false where two ways around give different sides.
bool spread_sides(const std::vector<std::vector<Neighbour>>& neighbours, Index seed, std::vector<int>& side,
                  std::vector<Index>& piece) {
  bool consistent = true;
  side[seed] = 0;
  piece = {seed};
  for (std::size_t i = 0; i < piece.size(); ++i)
    for (const Neighbour n : neighbours[piece[i]]) {
      const int wanted = side[piece[i]] ^ (n.disagrees ? 1 : 0);
      if (side[n.face] < 0) {
        side[n.face] = wanted;
        piece.push_back(n.face);
      } else if (side[n.face] != wanted) {
        consistent = false;
      }
    }
  return consistent;
}

}  // namespace

void turn_over(PanelFace& face) {
  Facets& facets = face.facets;
  for (Triangle& t : facets.triangles) std::swap(t[1], t[2]);
  for (std::array<Vec2, 3>& uv : facets.triangle_uv) std::swap(uv[1], uv[2]);
  for (std::vector<Index>& loop : facets.loops) std::reverse(loop.begin() + 1, loop.end());
  for (std::vector<EdgeUse>& loop : face.loops) {
    std::reverse(loop.begin(), loop.end());
    for (EdgeUse& use : loop) use.reversed = !use.reversed;
  }
}

std::vector<bool> orient_faces(Panel& panel) {
  const auto neighbours = neighbours_of(panel);
  std::vector<int> side(panel.faces.size(), -1);
  std::vector<bool> turned(panel.faces.size(), false);
  std::vector<Index> piece;
  int count = 0;
  for (Index seed = 0; seed < static_cast<Index>(panel.faces.size()); ++seed) {
    if (side[seed] >= 0) continue;
    if (!spread_sides(neighbours, seed, side, piece))
      panel.diagnostics.push_back({"read.not_orientable",
                                   Severity::warning,
                                   panel.faces[seed].number,
                                   {},
                                   "the faces connected to this one cannot be oriented alike",
                                   {}});
    std::array<double, 2> weight{0, 0};
    for (const Index f : piece) weight[side[f]] += area(panel.faces[f].facets);
    const int minority = weight[1] > weight[0] ? 0 : 1;
    for (const Index f : piece)
      if (side[f] == minority) {
        turn_over(panel.faces[f]);
        turned[f] = true;
        ++count;
      }
  }
  if (count > 0)
    panel.diagnostics.push_back(
        {"read.turned_over",
         Severity::note,
         no_index,
         {},
         std::to_string(count) + " faces were turned over to agree with their neighbours",
         {}});
  return turned;
}

}  // namespace beadmesh
