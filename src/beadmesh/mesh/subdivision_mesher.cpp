#include "beadmesh/mesh/subdivision_mesher.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "beadmesh/mesh/lattice_core.h"
#include "beadmesh/mesh/loop_connection.h"
#include "beadmesh/mesh/loop_splitting.h"
#include "beadmesh/mesh/mesh_draft.h"
#include "beadmesh/mesh/mesh_trial.h"
#include "beadmesh/mesh/segment_grid.h"

namespace beadmesh {
namespace {

// Trials of the lattice core's distance from the loops, in steps; 0: without a core.
constexpr std::array<double, 3> core_clearances{1.1, 1.6, 0};
constexpr double small_face = 2500;  // cells: up to here all are tried

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

struct Attempt {
  SplitWeights weights;
  bool against_vote = false;
};

// No single set of weights is best everywhere; areas are small, so that trying several costs little.
const std::vector<Attempt>& attempts() {
  static const std::vector<Attempt> all{
      {{}, false},
      {{4, 0.4, 0.3, 0.1, 0.3}, false},
      {{2, 0.08, 0.3, 0.1, 0.1}, false},
      {{6, 0.2, 0.1, 0.2, 0.3}, false},
      {{}, true},
      // From here on only where something poor is left.
      {{2, 0.08, 0.3, 0.1, 0.1}, true},
      {{1, 0.02, 0, 0.05, 0}, false},
      {{1, 0.02, 0, 0.05, 0}, true},
      {{8, 0.05, 0.1, 0, 0.5}, false},
      {{4, 0, 0, 0.3, 0}, true},
      {{3, 0.3, 1, 0, 0}, false},
  };
  return all;
}
constexpr std::size_t usual_attempts = 5;
constexpr double sound_jacobian = 0.25;

// A trial's best outcome so far; ends with the best one in the draft.
class BestPiece {
 public:
  explicit BestPiece(MeshDraft& draft) : draft_(draft), mark_(draft.mark()) {}

  const MeshDraft::Mark& mark() const { return mark_; }
  bool found() const { return best_.cost < 1e300; }
  void offer(bool valid) {
    const Judgement judgement = valid ? relax_and_judge(draft_, mark_) : Judgement{};
    MeshDraft::Piece piece = draft_.take_back(mark_);
    if (judgement.cost < best_.cost) best_ = judgement, piece_ = std::move(piece);
  }
  void keep() { draft_.put(piece_); }

 private:
  MeshDraft& draft_;
  MeshDraft::Mark mark_;
  MeshDraft::Piece piece_;
  Judgement best_;
};

// One area of the draft. Attempts have drafts of their own, so that any number of them can run at once.
class Area {
 public:
  Area(const MeshDraft& whole, std::vector<NodeLoop> loops) : whole_(&whole), loops_(std::move(loops)) {
    for (const NodeLoop& loop : loops_) nodes_.insert(nodes_.end(), loop.begin(), loop.end());
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    for (NodeLoop& loop : loops_) {
      for (Index& node : loop) {
        node = static_cast<Index>(std::lower_bound(nodes_.begin(), nodes_.end(), node) - nodes_.begin());
      }
    }
  }

  // False where no attempt works.
  bool fill() {
    tbb::parallel_for(std::size_t(0), usual_attempts, [&](std::size_t i) { outcomes_[i] = attempt(i); });
    for (std::size_t i = 0; i < usual_attempts; ++i) keep_better(std::move(outcomes_[i]));
    for (std::size_t i = usual_attempts; i < attempts().size() && best_.judgement.worst <= sound_jacobian;
         ++i)
      keep_better(attempt(i));
    return best_.judgement.cost < 1e300;
  }

  // Another area that was put before has taken an edge between nodes of both.
  bool is_outdated(const MeshDraft& draft) const {
    return std::any_of(best_.bridges.begin(), best_.bridges.end(),
                       [&](const auto& edge) { return draft.has_edge(edge[0], edge[1]); });
  }
  void put(MeshDraft& draft) const { draft.put(best_.piece, nodes_); }

 private:
  struct Outcome {
    Judgement judgement;
    MeshDraft::Piece piece;
    std::vector<std::array<Index, 2>> bridges;  // new edges between given nodes, in the whole's numbers
  };

  Outcome attempt(std::size_t i) const {
    const Attempt& how = attempts()[i];
    Outcome outcome;
    if (how.against_vote && loops_.size() == 1) return outcome;
    MeshDraft draft(*whole_, nodes_);
    const MeshDraft::Mark mark = draft.mark();
    const NodeLoop loop = loops_.size() == 1 ? loops_[0] : connect_loops(draft, loops_, how.against_vote);
    if (loop.empty()) return outcome;
    fill_by_splitting(draft, loop, how.weights);
    outcome.judgement = relax_and_judge(draft, mark);
    outcome.piece = draft.take_back(mark);
    outcome.bridges = bridges_of(outcome.piece);
    return outcome;
  }

  std::vector<std::array<Index, 2>> bridges_of(const MeshDraft::Piece& piece) const {
    std::vector<std::array<Index, 2>> bridges;
    for (const MeshElement& element : piece.elements) {
      const int corners = is_quad(element) ? 4 : 3;
      for (int k = 0; k < corners; ++k) {
        const Index a = element[k], b = element[(k + 1) % corners];
        if (std::max(a, b) >= static_cast<Index>(nodes_.size()) || whole_->has_edge(nodes_[a], nodes_[b]))
          continue;
        bridges.push_back({nodes_[a], nodes_[b]});
      }
    }
    return bridges;
  }

  void keep_better(Outcome outcome) {
    if (outcome.judgement.cost < best_.judgement.cost) best_ = std::move(outcome);
  }

  const MeshDraft* whole_;
  std::vector<NodeLoop> loops_;  // in the area's numbers
  std::vector<Index> nodes_;
  std::array<Outcome, usual_attempts> outcomes_;
  Outcome best_;
};

// Areas at once, entered one after the other: the result does not depend on the number of threads.
bool fill_areas(MeshDraft& draft, const std::vector<std::vector<NodeLoop>>& loops) {
  std::vector<Area> areas;
  areas.reserve(loops.size());
  for (const auto& of_area : loops) areas.emplace_back(draft, of_area);
  std::vector<char> filled(areas.size(), 0);
  tbb::parallel_for(std::size_t(0), areas.size(), [&](std::size_t i) { filled[i] = areas[i].fill(); });
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (filled[i] && areas[i].is_outdated(draft)) {
      areas[i] = Area(draft, loops[i]);
      filled[i] = areas[i].fill();
    }
    if (!filled[i]) return false;
    areas[i].put(draft);
  }
  return true;
}

// `clearance` of the lattice core in steps; 0: no core.
bool fill_face(MeshDraft& draft, const std::vector<NodeLoop>& loops, double clearance) {
  std::vector<NodeLoop> all = loops;
  if (clearance > 0) {
    auto outlines = add_lattice_core(draft, all, fit_lattice(draft, all), clearance);
    if (outlines.empty()) return false;
    all.insert(all.end(), outlines.begin(), outlines.end());
  }
  return fill_areas(draft, areas_of(draft, all, loops.size()));
}

bool fill_small_face(MeshDraft& draft, const std::vector<NodeLoop>& loops) {
  BestPiece best(draft);
  for (const double clearance : core_clearances) best.offer(fill_face(draft, loops, clearance));
  if (best.found()) best.keep();
  return best.found();
}

// Without trials of the core: the first that works.
bool fill_large_face(MeshDraft& draft, const std::vector<NodeLoop>& loops) {
  const MeshDraft::Mark mark = draft.mark();
  for (const double clearance : core_clearances) {
    if (fill_face(draft, loops, clearance)) return true;
    draft.take_back(mark);
  }
  return false;
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
  const double cells = std::abs(signed_area(loops.nodes, loops.loops[0])) / (options.size * options.size);
  const bool meshed =
      cells > small_face ? fill_large_face(draft, loops.loops) : fill_small_face(draft, loops.loops);
  if (!meshed) return fail("mesh.subdivision.connection", "a hole or inner line sees no other loop");
  return std::move(draft).take();
}

}  // namespace beadmesh
