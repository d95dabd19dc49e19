#include "beadmesh/mesh/subdivision_mesher.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "beadmesh/mesh/lattice_core.h"
#include "beadmesh/mesh/loop_connection.h"
#include "beadmesh/mesh/loop_splitting.h"
#include "beadmesh/mesh/mesh_draft.h"
#include "beadmesh/mesh/segment_grid.h"

namespace beadmesh {
namespace {

constexpr double core_clearance = 1.2;

// Why the loops cannot be meshed, in words; empty where they can.
std::string complaint(const NodeLoops& loops) {
  if (loops.loops.empty()) return "there is no loop";
  std::vector<std::array<Index, 2>> edges;
  for (const auto& loop : loops.loops) {
    if (loop.size() < 2) return "a loop has fewer than two nodes";
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index a = loop[i], b = loop[(i + 1) % loop.size()];
      if (a < 0 || a >= static_cast<Index>(loops.nodes.size()))
        return "a loop names a node that does not exist";
      if (a == b) return "a loop names node " + std::to_string(a) + " twice in a row";
      if (!std::isfinite(loops.nodes[a].x + loops.nodes[a].y))
        return "node " + std::to_string(a) + " is not finite";
      edges.push_back({a, b});
    }
  }
  if (loops.loops[0].size() < 3) return "the outer loop has fewer than three nodes";
  if (!(signed_area(loops.nodes, loops.loops[0]) > 0)) return "the outer loop does not run counter-clockwise";
  const auto [e, f] = SegmentGrid(loops.nodes, edges, 0).first_crossing();
  if (e == no_index) return {};
  return "the loop edge between nodes " + std::to_string(edges[e][0]) + " and " +
         std::to_string(edges[e][1]) + " meets the one between " + std::to_string(edges[f][0]) + " and " +
         std::to_string(edges[f][1]);
}

// Loops sorted into areas (the first `given` are the caller's, outlines of the core follow): each
// counter-clockwise loop with the holes and scars that it is the smallest to contain.
std::vector<std::vector<NodeLoop>> areas_of(const MeshDraft& draft, const std::vector<NodeLoop>& loops,
                                            std::size_t given) {
  struct Outer {
    std::size_t loop;
    double area;
    Vec2 low, high;
  };
  std::vector<Outer> outers;
  std::vector<std::size_t> holes;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const double area = signed_area(draft.nodes(), loops[k]);
    if (k > 0 && (k < given || area <= 0)) {
      holes.push_back(k);
      continue;
    }
    Outer outer{k, area, {1e300, 1e300}, {-1e300, -1e300}};
    for (const Index node : loops[k]) {
      const Vec2 p = draft.at(node);
      outer.low = {std::min(outer.low.x, p.x), std::min(outer.low.y, p.y)};
      outer.high = {std::max(outer.high.x, p.x), std::max(outer.high.y, p.y)};
    }
    outers.push_back(outer);
  }
  std::stable_sort(outers.begin(), outers.end(),
                   [](const Outer& a, const Outer& b) { return a.area < b.area; });
  std::vector<std::vector<NodeLoop>> areas;
  for (const Outer& outer : outers) areas.push_back({loops[outer.loop]});
  for (const std::size_t hole : holes) {
    // The middle of an edge: a node may lie on the outer loop.
    const Vec2 point = 0.5 * (draft.at(loops[hole][0]) + draft.at(loops[hole][1]));
    std::size_t home = outers.size() - 1;
    for (std::size_t k = 0; k < outers.size(); ++k) {
      const Outer& outer = outers[k];
      if (point.x < outer.low.x || point.x > outer.high.x || point.y < outer.low.y || point.y > outer.high.y)
        continue;
      if (!is_inside(draft.nodes(), loops[outer.loop], point)) continue;
      home = k;
      break;
    }
    areas[home].push_back(loops[hole]);
  }
  return areas;
}

bool fill_area(MeshDraft& draft, const std::vector<NodeLoop>& loops) {
  const NodeLoop loop = loops.size() == 1 ? loops[0] : connect_loops(draft, loops);
  if (loop.empty()) return false;
  fill_by_splitting(draft, loop);
  return true;
}

}  // namespace

Result<PlanarMesh> mesh_by_subdivision(const NodeLoops& loops, const SurfaceMap* map,
                                       const SubdivisionOptions& options) {
  if (!(options.size > 0) || !std::isfinite(options.size)) {
    return fail("mesh.subdivision.size", "the target size is not a positive number");
  }
  if (const std::string words = complaint(loops); !words.empty())
    return fail("mesh.subdivision.loops", words);
  MeshDraft draft(loops, map, options.size);
  std::vector<NodeLoop> all = loops.loops;
  if (core_clearance > 0) {
    auto outlines = add_lattice_core(draft, all, fit_lattice(draft, all), core_clearance);
    all.insert(all.end(), outlines.begin(), outlines.end());
  }
  for (const auto& area : areas_of(draft, all, loops.loops.size())) {
    if (!fill_area(draft, area)) {
      return fail("mesh.subdivision.connection", "a hole or inner line sees no other loop");
    }
  }
  return std::move(draft).take(loops.nodes.size());
}

}  // namespace beadmesh
