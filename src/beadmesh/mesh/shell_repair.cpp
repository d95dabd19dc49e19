#include "beadmesh/mesh/shell_repair.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "beadmesh/flatten/flat_face.h"
#include "beadmesh/mesh/element_quality.h"
#include "beadmesh/mesh/element_zone.h"
#include "beadmesh/mesh/smoothing.h"
#include "beadmesh/panel/facets.h"

namespace beadmesh {
namespace {

constexpr int rings = 2;

/// One side of an element; sorted, so that the uses of an edge are neighbours.
struct SideUse {
  Index low, high, element;
  friend auto operator<=>(const SideUse&, const SideUse&) = default;
};

/// A zone laid flat. Its nodes are those of the facets.
struct FlatZone {
  Facets facets;
  FlatFace flat;
  PlanarMesh mesh;
};

class MovingRepair {
 public:
  MovingRepair(std::vector<Vec3>& nodes, const std::vector<MeshElement>& elements,
               const QualityCriteria& criteria, const ShellRepairOptions& options)
      : nodes_(nodes),
        elements_(elements),
        criteria_(criteria),
        options_(options),
        connectivity_({std::vector<Vec2>(nodes.size()), std::vector<NodeFreedom>(nodes.size()), elements}),
        fixed_(nodes.size(), false) {
    fix_nodes();
  }

  ShellRepairReport run() {
    ShellRepairReport report;
    std::set<Index> moved;
    for (Index e = 0; e < Index(elements_.size()); ++e) {
      if (!fails_any(nodes_, elements_[e], criteria_) || is_all_fixed(elements_[e])) continue;
      ++report.zones;
      mend(elements_within(connectivity_, e, rings), moved);
    }
    report.moved.assign(moved.begin(), moved.end());
    return report;
  }

 private:
  void fix_nodes() {
    std::vector<SideUse> uses;
    for (Index e = 0; e < Index(elements_.size()); ++e)
      for (int i = 0; i < corner_count(elements_[e]); ++i) {
        const Index a = elements_[e][i], b = elements_[e][(i + 1) % corner_count(elements_[e])];
        uses.push_back({std::min(a, b), std::max(a, b), e});
      }
    std::sort(uses.begin(), uses.end());
    for (size_t i = 0, end = 0; i < uses.size(); i = end) {
      while (end < uses.size() && uses[end].low == uses[i].low && uses[end].high == uses[i].high) ++end;
      const bool inner = end - i == 2 && is_smooth(uses[i].element, uses[i + 1].element);
      if (!inner) fixed_[uses[i].low] = fixed_[uses[i].high] = true;
    }
    for (const Index n : options_.kept) fixed_[n] = true;
  }

  bool is_smooth(Index a, Index b) const {
    if (!options_.groups.empty() && options_.groups[a] != options_.groups[b]) return false;
    return angle_between(area_normal(nodes_, elements_[a]), area_normal(nodes_, elements_[b])) <
           options_.sharp;
  }

  bool is_all_fixed(const MeshElement& e) const {
    for (int i = 0; i < corner_count(e); ++i)
      if (!fixed_[e[i]]) return false;
    return true;
  }

  /// All moves stay on the triangles of the zone.
  std::optional<FlatZone> laid_flat(const std::vector<Index>& zone) const {
    std::vector<Triangle> triangles;
    std::set<std::array<Index, 2>> sides;
    for (const Index k : zone) {
      const MeshElement& e = elements_[k];
      for (int i = 0; i < corner_count(e); ++i)
        if (!sides.insert({e[i], e[(i + 1) % corner_count(e)]}).second) return std::nullopt;
      add_triangles(e, triangles);
    }
    FlatZone out;
    out.facets = facets_of_triangles(nodes_, triangles);
    std::map<Index, Index> local;
    for (Index n = 0; n < Index(out.facets.points.size()); ++n)
      if (!local.emplace(out.facets.panel_points[n], n).second) return std::nullopt;
    auto flat = flatten(out.facets);
    if (!flat) return std::nullopt;
    out.flat = std::move(*flat);
    out.mesh.nodes = out.flat.positions;
    for (const Index k : zone) {
      MeshElement e = elements_[k];
      for (Index& n : e)
        if (n != no_index) n = local[n];
      out.mesh.elements.push_back(e);
    }
    return out;
  }

  /// A quad is cut along its shorter diagonal.
  void add_triangles(const MeshElement& e, std::vector<Triangle>& triangles) const {
    if (!is_quad(e))
      triangles.push_back({e[0], e[1], e[2]});
    else if (distance(nodes_[e[0]], nodes_[e[2]]) <= distance(nodes_[e[1]], nodes_[e[3]]))
      triangles.insert(triangles.end(), {{e[0], e[1], e[2]}, {e[0], e[2], e[3]}});
    else
      triangles.insert(triangles.end(), {{e[0], e[1], e[3]}, {e[1], e[2], e[3]}});
  }

  /// Only nodes all of whose elements are in the zone may move.
  void set_freedom(FlatZone& zone) const {
    std::vector<int> uses(zone.mesh.nodes.size(), 0);
    for (const MeshElement& e : zone.mesh.elements)
      for (int i = 0; i < corner_count(e); ++i) ++uses[e[i]];
    for (Index n = 0; n < Index(uses.size()); ++n) {
      const Index whole = zone.facets.panel_points[n];
      const bool free = !fixed_[whole] && uses[n] == connectivity_.valence(whole);
      zone.mesh.freedom.push_back(free ? NodeFreedom::free : NodeFreedom::fixed);
    }
  }

  struct Standing {
    int failing = 0;
    double shortest = 1e300;
  };
  Standing standing(const std::vector<Index>& zone) const {
    Standing out;
    for (const Index e : zone) {
      out.failing += fails_any(nodes_, elements_[e], criteria_);
      out.shortest = std::min(out.shortest, side_lengths(nodes_, elements_[e])[0]);
    }
    return out;
  }

  void mend(const std::vector<Index>& zone, std::set<Index>& moved) {
    auto flat = laid_flat(zone);
    if (!flat) return;
    set_freedom(*flat);
    const Standing before = standing(zone);
    const SurfaceMap map(flat->facets, flat->flat);
    smooth(flat->mesh, &map, {options_.size, options_.min_edge});
    std::vector<std::pair<Index, Vec3>> undo;
    for (Index n = 0; n < Index(flat->mesh.nodes.size()); ++n) {
      if (flat->mesh.freedom[n] == NodeFreedom::fixed) continue;
      const Index whole = flat->facets.panel_points[n];
      undo.emplace_back(whole, nodes_[whole]);
      nodes_[whole] = map.facet_point(map.locate(flat->mesh.nodes[n]));
    }
    const Standing after = standing(zone);
    if (after.failing < before.failing && after.shortest >= std::min(before.shortest, options_.min_edge)) {
      for (const auto& [n, place] : undo)
        if (nodes_[n] != place) moved.insert(n);
    } else {
      for (const auto& [n, place] : undo) nodes_[n] = place;
    }
  }

  std::vector<Vec3>& nodes_;
  const std::vector<MeshElement>& elements_;
  const QualityCriteria& criteria_;
  const ShellRepairOptions& options_;
  QuadConnectivity connectivity_;
  std::vector<bool> fixed_;
};

}  // namespace

ShellRepairReport repair_by_moving(std::vector<Vec3>& nodes, const std::vector<MeshElement>& elements,
                                   const QualityCriteria& criteria, const ShellRepairOptions& options) {
  return MovingRepair(nodes, elements, criteria, options).run();
}

}  // namespace beadmesh
