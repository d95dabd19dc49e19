#include "beadmesh/read/facet_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace beadmesh {
namespace {

class FacetWelder {
 public:
  FacetMesh run(const LooseFacets& facets) {
    weld(facets);
    pair_half_edges(mesh_, true);
    orient();
    for (const Triangle& t : mesh_.triangles) mesh_.area_vectors.push_back(area_vector(mesh_.points, t));
    return std::move(mesh_);
  }

 private:
  void weld(const LooseFacets& facets) {
    std::vector<Vec3> all;
    for (const auto& corners : facets.corners) all.insert(all.end(), corners.begin(), corners.end());
    const std::vector<Index> to = representatives(all, 1e-6 * extent(all));
    std::vector<Index> number(all.size(), no_index);
    for (std::size_t c = 0; c < all.size(); c += 3) {
      const Index a = to[c], b = to[c + 1], d = to[c + 2];
      if (a == b || b == d || d == a) continue;
      for (const Index v : {a, b, d})
        if (number[v] == no_index) {
          number[v] = static_cast<Index>(mesh_.points.size());
          mesh_.points.push_back(all[v]);
        }
      mesh_.triangles.push_back({number[a], number[b], number[d]});
      mesh_.parts.push_back(facets.parts.empty() ? no_index : facets.parts[c / 3]);
    }
    drop_repeated();
  }

  static double extent(const std::vector<Vec3>& points) {
    if (points.empty()) return 0;
    Vec3 low = points[0], high = low;
    for (const Vec3 p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    return distance(low, high);
  }

  /// Per point the first one within the tolerance. Cells of that size; equal points, the common case, are
  /// found first.
  static std::vector<Index> representatives(const std::vector<Vec3>& points, double tolerance) {
    using Cell = std::array<std::int64_t, 3>;
    double reach = 1e-300;
    for (const Vec3 p : points) reach = std::max({reach, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    const double size = std::max(tolerance, 1e-15 * reach);  // cells must stay countable
    std::map<std::array<double, 3>, Index> exact;
    std::map<Cell, Index> cells;
    std::vector<Index> result;
    for (Index i = 0; i < static_cast<Index>(points.size()); ++i) {
      const Vec3 p = points[i];
      const auto [found, is_new] = exact.try_emplace({p.x, p.y, p.z}, i);
      if (is_new) {
        const auto part = [&](double x) { return static_cast<std::int64_t>(std::floor(x / size)); };
        const Cell at{part(p.x), part(p.y), part(p.z)};
        found->second = nearby(points, cells, at, i, tolerance);
        if (found->second == i) cells.emplace(at, i);
      }
      result.push_back(found->second);
    }
    return result;
  }

  template <class Cells, class Cell>
  static Index nearby(const std::vector<Vec3>& points, const Cells& cells, const Cell& at, Index i,
                      double tolerance) {
    for (int n = 0; n < 27; ++n) {
      const auto found = cells.find({at[0] + n % 3 - 1, at[1] + n / 3 % 3 - 1, at[2] + n / 9 - 1});
      if (found != cells.end() && distance(points[found->second], points[i]) <= tolerance)
        return found->second;
    }
    return i;
  }

  void drop_repeated() {
    std::set<std::array<Index, 3>> seen;
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      std::array<Index, 3> key = mesh_.triangles[t];
      std::sort(key.begin(), key.end());
      if (!seen.insert(key).second) continue;
      mesh_.parts[kept] = mesh_.parts[t];
      mesh_.triangles[kept++] = mesh_.triangles[t];
    }
    mesh_.triangles.resize(kept);
    mesh_.parts.resize(kept);
  }

  /// Turns triangles so that partners run in opposite directions; the side with more area stays.
  void orient() {
    std::vector<int> side(mesh_.triangles.size(), -1);
    std::vector<Index> turned;
    for (Index seed = 0; seed < mesh_.triangle_count(); ++seed) {
      if (side[seed] >= 0) continue;
      std::vector<Index> piece{seed};
      side[seed] = 0;
      std::array<double, 2> weight{0, 0};
      for (std::size_t i = 0; i < piece.size(); ++i) {
        const Index t = piece[i];
        weight[side[t]] += norm(area_vector(mesh_.points, mesh_.triangles[t]));
        for (Index h = 3 * t; h < 3 * t + 3; ++h) {
          if (mesh_.partner[h] == no_index || side[mesh_.partner[h] / 3] >= 0) continue;
          side[mesh_.partner[h] / 3] = side[t] ^ (mesh_.tail(h) == mesh_.tail(mesh_.partner[h]) ? 1 : 0);
          piece.push_back(mesh_.partner[h] / 3);
        }
      }
      const int minority = weight[1] > weight[0] ? 0 : 1;
      for (const Index t : piece)
        if (side[t] == minority) turned.push_back(t);
    }
    for (const Index t : turned) std::swap(mesh_.triangles[t][1], mesh_.triangles[t][2]);
    if (!turned.empty())
      mesh_.repairs.push_back(
          {"read.turned_over",
           Severity::note,
           no_index,
           {},
           std::to_string(turned.size()) + " facets were turned over to agree with their neighbours",
           {}});
    pair_half_edges(mesh_);
  }

  FacetMesh mesh_;
};

}  // namespace

Vec3 area_vector(const std::vector<Vec3>& points, const Triangle& triangle) {
  const Vec3 a = points[triangle[0]];
  return cross(points[triangle[1]] - a, points[triangle[2]] - a) / 2;
}

void pair_half_edges(FacetMesh& mesh, bool any_direction) {
  const Index n = 3 * mesh.triangle_count();
  std::vector<Index> order(n);
  for (Index h = 0; h < n; ++h) order[h] = h;
  const auto key = [&](Index h) {
    return std::pair{std::min(mesh.tail(h), mesh.head(h)), std::max(mesh.tail(h), mesh.head(h))};
  };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    const auto ka = key(a), kb = key(b);
    return ka != kb ? ka < kb : a < b;
  });
  mesh.partner.assign(n, no_index);
  for (Index i = 0, j; i < n; i = j) {
    for (j = i + 1; j < n && key(order[j]) == key(order[i]);) ++j;
    const Index a = order[i], b = order[j - 1];
    if (j - i != 2 || a / 3 == b / 3 || (mesh.tail(a) == mesh.tail(b) && !any_direction)) continue;
    mesh.partner[a] = b;
    mesh.partner[b] = a;
  }
}

double FacetMesh::turn(Index h) const {
  const Vec3 a = area_vectors[h / 3], b = area_vectors[partner[h] / 3];
  return squared_norm(a) == 0 || squared_norm(b) == 0 ? 0 : angle_between(a, b);
}

double FacetMesh::lowest_height(Index t) const {
  const double longest = std::max({length(3 * t), length(3 * t + 1), length(3 * t + 2)});
  return longest > 0 ? 2 * area(t) / longest : 0;
}

double FacetMesh::reach(Index h) const {
  return 2 * std::min(area(h / 3), area(partner[h] / 3)) / std::max(length(h), 1e-300);
}

FacetMesh weld_facets(const LooseFacets& facets) {
  return FacetWelder().run(facets);
}

}  // namespace beadmesh
