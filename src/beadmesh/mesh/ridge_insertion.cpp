#include "beadmesh/mesh/ridge_insertion.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "beadmesh/blocking/axis_station.h"
#include "beadmesh/blocking/block_layout.h"
#include "beadmesh/mesh/subdivision_mesher.h"
#include "beadmesh/mesh/surface_polyline.h"

namespace beadmesh {
namespace {

using NodeRow = std::vector<Index>;

/// A stretch of the boundary between two tips, or a whole loop without one.
struct BoundaryArc {
  Index start = no_index, end = no_index;  ///< tip nodes; both no_index for a whole loop
  Index loop = 0;
  double from = 0, to = 0;
  int count = 0;
  NodeRow nodes;  ///< from start to end; a whole loop: first == last
};

double area_of(const NodeRow& cycle, const std::vector<Vec2>& nodes) {
  double area = 0;
  for (size_t i = 0; i < cycle.size(); ++i)
    area += cross(nodes[cycle[i]], nodes[cycle[(i + 1) % cycle.size()]]) / 2;
  return area;
}

bool contains(const NodeRow& cycle, const std::vector<Vec2>& nodes, Vec2 p) {
  bool inside = false;
  for (size_t i = 0; i < cycle.size(); ++i) {
    const Vec2 a = nodes[cycle[i]], b = nodes[cycle[(i + 1) % cycle.size()]];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) inside = !inside;
  }
  return inside;
}

/// A side of the ridge: its outer node loop and the holes in it.
using Side = std::vector<NodeRow>;

class RidgeInserter {
 public:
  RidgeInserter(const RidgeGraph& ridge, const PlanarRegion& region, const SurfaceMap& map,
                const RidgeInsertionOptions& options)
      : ridge_(ridge),
        map_(map),
        options_(options),
        boundary_(region),
        loop_lengths_(loop_lengths_of(region)) {}

  Result<BeadMesh> run() {
    place_graph_nodes();
    for (const RidgeArm& arm : ridge_.arms) place_arm(arm);
    cut_boundary();
    for (BoundaryArc& arc : arcs_) {
      const double length = arc_line(arc).length();
      arc.count = arc.start == no_index ? even_count_for(length) : count_for(length, 2);
    }
    make_sides_even();
    for (BoundaryArc& arc : arcs_) place_arc(arc);
    const std::vector<Side> sides = trace_sides();
    for (const Side& side : sides)
      if (const auto filled = fill(side); !filled) return tl::unexpected(filled.error());
    out_.method = "ridge";
    return std::move(out_);
  }

 private:
  Index add_node(Vec2 point, NodeFreedom freedom) {
    out_.mesh.nodes.push_back(point);
    out_.mesh.freedom.push_back(freedom);
    return Index(out_.mesh.nodes.size()) - 1;
  }

  int count_for(double length, int least) const {
    const int most = std::max(1, int(std::floor(length / (1.1 * options_.min_edge))));
    return std::max(least, std::min(most, int(std::lround(length / options_.size))));
  }

  /// Of a closed line: even, so that what lies on its other side can be even as well.
  int even_count_for(double length) const {
    const int n = count_for(length, 6);
    const bool room = n < 7 || length / (n + 1) >= 1.1 * options_.min_edge;
    return n % 2 == 0 ? n : room ? n + 1 : n - 1;
  }

  void place_graph_nodes() {
    for (const RidgeNode& node : ridge_.nodes) {
      graph_node_.push_back(add_node(node.point, NodeFreedom::fixed));
      if (node.tip) out_.boundary.push_back({graph_node_.back(), node.boundary});
    }
  }

  void place_arm(const RidgeArm& arm) {
    std::vector<Vec2> points = arm.points;
    const bool closed = arm.start == no_index;
    if (closed) points.push_back(points.front());
    const SurfacePolyline line(points, map_);
    const int count = closed ? even_count_for(line.length()) : count_for(line.length(), 1);
    NodeRow row{closed ? add_node(points.front(), NodeFreedom::sliding) : graph_node_[arm.start]};
    for (int i = 1; i < count; ++i)
      row.push_back(add_node(line.point_at(line.length() * i / count), NodeFreedom::sliding));
    row.push_back(closed ? row.front() : graph_node_[arm.end]);
    out_.crest_lines.push_back(row);
  }

  void cut_boundary() {
    for (Index l = 0; l < Index(loop_lengths_.size()); ++l) {
      std::vector<std::pair<double, Index>> tips;
      for (size_t n = 0; n < ridge_.nodes.size(); ++n)
        if (ridge_.nodes[n].tip && ridge_.nodes[n].boundary.loop == l)
          tips.emplace_back(ridge_.nodes[n].boundary.position, graph_node_[n]);
      std::sort(tips.begin(), tips.end());
      if (tips.empty()) arcs_.push_back({no_index, no_index, l, 0, loop_lengths_[l], 0, {}});
      for (size_t i = 0; i < tips.size(); ++i) {
        const auto& next = tips[(i + 1) % tips.size()];
        const double to = next.first > tips[i].first ? next.first : next.first + loop_lengths_[l];
        arcs_.push_back({tips[i].second, next.second, l, tips[i].first, to, 0, {}});
      }
    }
  }

  SurfacePolyline arc_line(const BoundaryArc& arc) const {
    const int samples = std::max(16, int(std::ceil((arc.to - arc.from) / (0.2 * options_.size))));
    std::vector<Vec2> points;
    for (int i = 0; i <= samples; ++i)
      points.push_back(boundary_.point_at({arc.loop, arc.from + (arc.to - arc.from) * i / samples}));
    return SurfacePolyline(points, map_);
  }

  void place_arc(BoundaryArc& arc) {
    const SurfacePolyline line = arc_line(arc);
    const bool whole = arc.start == no_index;
    for (int i = 0; i < arc.count; ++i) {
      if (i == 0 && !whole) {
        arc.nodes.push_back(arc.start);
        continue;
      }
      const double share = line.flat_share_at(line.length() * i / arc.count);
      const double at = std::fmod(arc.from + (arc.to - arc.from) * share, loop_lengths_[arc.loop]);
      arc.nodes.push_back(add_node(boundary_.point_at({arc.loop, at}), NodeFreedom::fixed));
      out_.boundary.push_back({arc.nodes.back(), {arc.loop, at}});
    }
    arc.nodes.push_back(whole ? arc.nodes.front() : arc.end);
  }

  /// Every side owns at least one arc: one more node on its longest element makes it even. Ridge edges count
  /// on two sides, so the sides are traced on a coarse copy with the counts as they are.
  void make_sides_even() {
    RidgeInserter trial = *this;
    for (BoundaryArc& arc : trial.arcs_) trial.place_arc(arc);
    for (const Side& side : trial.trace_sides()) {
      size_t total = 0;
      std::vector<bool> on_side(trial.out_.mesh.nodes.size(), false);
      for (const NodeRow& cycle : side) {
        total += cycle.size();
        for (Index n : cycle) on_side[n] = true;
      }
      if (total % 2) lengthen_coarsest_arc(trial, on_side);
    }
  }

  void lengthen_coarsest_arc(const RidgeInserter& trial, const std::vector<bool>& on_side) {
    size_t best = arcs_.size();
    double best_step = 0;
    for (size_t a = 0; a < arcs_.size(); ++a) {
      const NodeRow& nodes = trial.arcs_[a].nodes;
      const bool mine =
          nodes.size() > 2 ? on_side[nodes[1]] : on_side[nodes.front()] && on_side[nodes.back()];
      const double step = (arcs_[a].to - arcs_[a].from) / arcs_[a].count;
      if (mine && step > best_step) {
        best_step = step;
        best = a;
      }
    }
    if (best == arcs_.size()) return;
    const double length = arcs_[best].to - arcs_[best].from;
    const bool room = length / (arcs_[best].count + 1) >= 1.1 * options_.min_edge;
    arcs_[best].count += room || arcs_[best].count < 3 ? 1 : -1;
  }

  /// Cycles with the face on their left: boundary forward, ridges both ways; at every node the next edge
  /// clockwise.
  std::vector<Side> trace_sides() const {
    std::map<Index, std::vector<Index>> outgoing;
    const auto connect = [&](Index a, Index b) { outgoing[a].push_back(b); };
    for (const BoundaryArc& arc : arcs_)
      for (size_t i = 1; i < arc.nodes.size(); ++i) connect(arc.nodes[i - 1], arc.nodes[i]);
    for (const NodeRow& line : out_.crest_lines)
      for (size_t i = 1; i < line.size(); ++i) {
        connect(line[i - 1], line[i]);
        connect(line[i], line[i - 1]);
      }
    std::map<std::pair<Index, Index>, bool> used;
    std::vector<NodeRow> outers, holes;
    for (const auto& [start, targets] : outgoing)
      for (Index target : targets) {
        NodeRow cycle;
        for (Index a = start, b = target; !used[{a, b}];) {
          used[{a, b}] = true;
          cycle.push_back(a);
          const Index next = next_clockwise(outgoing.at(b), a, b);
          a = b;
          b = next;
        }
        if (cycle.empty()) continue;
        (area_of(cycle, out_.mesh.nodes) > 0 ? outers : holes).push_back(std::move(cycle));
      }
    return nested(outers, holes);
  }

  Index next_clockwise(const std::vector<Index>& targets, Index from, Index at) const {
    const auto& p = out_.mesh.nodes;
    const Vec2 back = p[from] - p[at];
    Index best = from;
    double best_turn = 4 * pi;
    for (Index t : targets) {
      const Vec2 d = p[t] - p[at];
      double turn = t == from ? 2 * pi : std::atan2(-cross(back, d), dot(back, d));
      if (turn <= 0) turn += 2 * pi;
      if (turn < best_turn) {
        best_turn = turn;
        best = t;
      }
    }
    return best;
  }

  std::vector<Side> nested(const std::vector<NodeRow>& outers, const std::vector<NodeRow>& holes) const {
    std::vector<Side> sides;
    for (const NodeRow& outer : outers) sides.push_back({outer});
    for (const NodeRow& hole : holes) {
      size_t best = sides.size();
      for (size_t s = 0; s < sides.size(); ++s) {
        const bool shares = std::find(outers[s].begin(), outers[s].end(), hole.front()) != outers[s].end();
        if (shares || !contains(outers[s], out_.mesh.nodes, out_.mesh.nodes[hole.front()])) continue;
        if (best == sides.size() ||
            area_of(outers[s], out_.mesh.nodes) < area_of(outers[best], out_.mesh.nodes))
          best = s;
      }
      if (best < sides.size()) sides[best].push_back(hole);
    }
    return sides;
  }

  Result<void> fill(const Side& side) {
    NodeLoops input;
    std::map<Index, Index> local;
    NodeRow global;
    for (const NodeRow& cycle : side) {
      NodeRow loop;
      for (Index n : cycle) {
        const auto [at, is_new] = local.emplace(n, Index(global.size()));
        if (is_new) {
          global.push_back(n);
          input.nodes.push_back(out_.mesh.nodes[n]);
        }
        loop.push_back(at->second);
      }
      input.loops.push_back(std::move(loop));
    }
    auto filled = mesh_by_subdivision(input, &map_, {options_.size, options_.min_edge});
    if (!filled) return tl::unexpected(filled.error());
    for (size_t n = input.nodes.size(); n < filled->nodes.size(); ++n)
      global.push_back(add_node(filled->nodes[n], NodeFreedom::free));
    for (MeshElement element : filled->elements) {
      for (Index& n : element)
        if (n != no_index) n = global[n];
      out_.mesh.elements.push_back(element);
    }
    return {};
  }

  const RidgeGraph& ridge_;
  const SurfaceMap& map_;
  RidgeInsertionOptions options_;
  BlockLayoutBuilder boundary_;
  std::vector<double> loop_lengths_;
  std::vector<BoundaryArc> arcs_;
  NodeRow graph_node_;
  BeadMesh out_;
};

}  // namespace

Result<BeadMesh> mesh_by_ridge_insertion(const RidgeGraph& ridge, const PlanarRegion& region,
                                         const SurfaceMap& map, const RidgeInsertionOptions& options) {
  for (const RidgeArm& arm : ridge.arms)
    if (arm.points.size() < 2) return fail("mesh.ridge.arm", "a ridge curve has no length");
  return RidgeInserter(ridge, region, map, options).run();
}

}  // namespace beadmesh
