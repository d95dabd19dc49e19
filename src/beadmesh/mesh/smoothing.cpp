#include "beadmesh/mesh/smoothing.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <limits>

#include "beadmesh/mesh/joint_motion.h"
#include "beadmesh/mesh/node_motion.h"

namespace beadmesh {
namespace {

/// The sheet is written with nodes on the exact surface, up to a sagitta off the facets that lengths are
/// measured on.
constexpr double min_edge_margin = 1.005;

/// Scaled Jacobian that elements at a node of three quads can reach: the sine of 120 degrees, and a little
/// more to strive for.
constexpr double regular_jacobian = 0.885;

/// Elements whose least determinant at the Gauss points is under this share of the largest are worked on, up
/// to the second.
constexpr double least_evenness = 0.63, good_evenness = 0.68;

/// Distances from the surface, as shares of the size, that are given up for elements that would fail.
constexpr double surface_share = 0.08, crest_share = 0.016;
/// Scaled Jacobian under the floor that is given up for them where nothing else helps, and where that ends.
constexpr double shape_given_up = 0.055, least_shape = 0.65;

/// So many nodes and more are moved colour by colour, several at once; so many make a task.
constexpr size_t many_nodes = 1500, nodes_of_task = 48;

/// Colours such that nodes with a common element differ: those of one colour do not see each other move.
std::vector<Index> coloured(const QuadConnectivity& mesh) {
  std::vector<Index> colours(mesh.node_count(), no_index);
  std::vector<bool> taken;
  for (Index node = 0; node < mesh.node_count(); ++node) {
    taken.assign(taken.size(), false);
    for (const Index e : mesh.star(node))
      for (int i = 0; i < corner_count(mesh.element(e)); ++i) {
        const Index colour = colours[mesh.element(e)[i]];
        if (colour == no_index) continue;
        if (colour >= Index(taken.size())) taken.resize(colour + 1, false);
        taken[colour] = true;
      }
    colours[node] = Index(std::find(taken.begin(), taken.end(), false) - taken.begin());
  }
  return colours;
}

/// Shape and edge length of the whole mesh, one stage of node movements after the other.
class Smoother {
 public:
  Smoother(PlanarMesh& mesh, const SurfaceMap* map, const std::vector<SlidingLine>& lines,
           const SmoothingOptions& options)
      : mesh_(mesh),
        options_(options),
        nodes_(mesh.nodes, map),
        connectivity_(mesh),
        lines_(lines, mesh.freedom),
        motion_(nodes_, connectivity_, mesh.freedom, lines_,
                {options.size, options.min_edge * min_edge_margin, 0.7, options.flat_floor,
                 options.surface_passes > 0 ? regular_jacobian : 0}) {
    if (options.surface_passes > 0) motion_.prepare_for_surface();
  }

  SmoothingReport run() {
    untangle();
    sweep(all_nodes(), options_.variational_passes, 1.0,
          [](NodeMotion& motion, Index node) { return motion.relax(node); });
    sweep(all_nodes(), options_.optimisation_passes, 0.97,
          [](NodeMotion& motion, Index node) { return motion.optimise(node, MotionAim::mean); });
    improve_worst(0.75);
    if (options_.aim == SmoothingOptions::Aim::angles_and_evenness) even_out();
    lengthen_short_edges();
    bool given_up = false;
    if (options_.surface_passes > 0) given_up = worst() < options_.hopeless || !near_surface();
    for (size_t node = 0; node < mesh_.nodes.size(); ++node)
      mesh_.nodes[node] = nodes_.flat(static_cast<Index>(node));
    SmoothingReport result = report();
    result.given_up = given_up;
    return result;
  }

  const std::vector<SlidingLine>& lines() const { return lines_.lines(); }

 private:
  std::vector<Index> all_nodes() const {
    std::vector<Index> nodes;
    for (Index node = 0; node < connectivity_.node_count(); ++node)
      if (motion_.is_movable(node) && !connectivity_.star(node).empty()) nodes.push_back(node);
    return nodes;
  }

  /// Movable corners of the elements of the given nodes, the nodes among them, ascending.
  std::vector<Index> widened(const std::vector<Index>& nodes) const {
    std::vector<bool> marked(connectivity_.node_count(), false);
    for (const Index node : nodes)
      for (const Index e : connectivity_.star(node))
        for (int i = 0; i < corner_count(connectivity_.element(e)); ++i)
          marked[connectivity_.element(e)[i]] = true;
    return movable(marked);
  }

  std::vector<Index> movable(const std::vector<bool>& marked) const {
    std::vector<Index> result;
    for (Index node = 0; node < connectivity_.node_count(); ++node)
      if (marked[node] && motion_.is_movable(node)) result.push_back(node);
    return result;
  }

  std::vector<Index> nodes_of_worst(double below) const {
    std::vector<bool> marked(connectivity_.node_count(), false);
    for (const MeshElement& element : mesh_.elements)
      if (signed_quality(nodes_, element) < below)
        for (int i = 0; i < corner_count(element); ++i) marked[element[i]] = true;
    return movable(marked);
  }

  /// After a pass only what moved, and its neighbours, are visited again.
  template <class Move>
  void sweep(std::vector<Index> active, int passes, double good_enough, Move move) {
    const double still = 5e-3 * options_.size;
    const auto visit = [&](NodeMotion& motion, Index node) {
      if (good_enough < 1 && motion.worst_around(node) > good_enough && motion.shortfall(node) <= 0)
        return false;
      return move(motion, node) && motion.last_step() > still;
    };
    for (int pass = 0; pass < passes && !active.empty(); ++pass) active = widened(moved_by(active, visit));
  }

  /// Gauss-Seidel in the order of the node numbers; for many nodes colour by colour, so that the result is
  /// the same on any number of threads. Returns those for which `visit` is true, in the order in which they
  /// were visited.
  template <class Visit>
  std::vector<Index> moved_by(std::vector<Index> nodes, Visit visit) {
    std::vector<char> has_moved(nodes.size(), 0);
    if (nodes.size() < many_nodes) {
      for (size_t i = 0; i < nodes.size(); ++i) has_moved[i] = visit(motion_, nodes[i]);
    } else {
      if (colours_.empty()) colours_ = coloured(connectivity_);
      std::stable_sort(nodes.begin(), nodes.end(),
                       [&](Index a, Index b) { return colours_[a] < colours_[b]; });
      for (size_t begin = 0, end = 0; begin < nodes.size(); begin = end) {
        while (end < nodes.size() && colours_[nodes[end]] == colours_[nodes[begin]]) ++end;
        visit_at_once(nodes, begin, end, visit, has_moved);
      }
    }
    std::vector<Index> moved;
    for (size_t i = 0; i < nodes.size(); ++i)
      if (has_moved[i]) moved.push_back(nodes[i]);
    return moved;
  }

  /// Isolated: a thread that waits for the others must not begin another face meanwhile.
  template <class Visit>
  void visit_at_once(const std::vector<Index>& nodes, size_t begin, size_t end, const Visit& visit,
                     std::vector<char>& has_moved) {
    tbb::this_task_arena::isolate([&] {
      tbb::parallel_for(tbb::blocked_range<size_t>(begin, end, nodes_of_task),
                        [&](const tbb::blocked_range<size_t>& range) {
                          NodeMotion& motion = motions_.local();
                          for (size_t i = range.begin(); i < range.end(); ++i)
                            has_moved[i] = visit(motion, nodes[i]);
                        });
    });
  }

  /// Rounds over the nodes of elements that are turned over; the circle of nodes widens while they do not
  /// come right.
  void untangle() {
    std::vector<Index> tangled = nodes_of_worst(0.02);
    for (int round = 0; round < 40 && !tangled.empty(); ++round) {
      std::vector<Index> circle = tangled;
      for (int ring = 0; ring < round / 5; ++ring) circle = widened(circle);
      for (const Index node : circle) motion_.untangle(node);
      tangled = nodes_of_worst(0.02);
    }
  }

  void improve_worst(double below) {
    sweep(nodes_of_worst(below), options_.optimisation_passes, below,
          [](NodeMotion& motion, Index node) { return motion.optimise(node, MotionAim::worst); });
  }

  /// Uneven elements fail where the others do not care; what moves to help them keeps its shape.
  void even_out() {
    std::vector<bool> marked(connectivity_.node_count(), false);
    for (const MeshElement& element : mesh_.elements)
      if (evenness(nodes_, element) < least_evenness)
        for (int i = 0; i < corner_count(element); ++i) marked[element[i]] = true;
    std::vector<Index> active = widened(movable(marked));
    sweep(active, options_.optimisation_passes, 1.0, [](NodeMotion& motion, Index node) {
      return motion.evenness_around(node) < good_evenness && motion.optimise(node, MotionAim::even);
    });
  }

  /// Shape and distance first, then warpage is taken away from what has both. False where it is given up.
  bool near_surface() {
    const auto approach = [&](MotionAim aim) {
      sweep(all_nodes(), options_.surface_passes, 1.0,
            [aim](NodeMotion& motion, Index node) { return motion.optimise(node, aim); });
    };
    approach(MotionAim::surface);
    if (worst() < options_.hopeless_when_near) return false;
    improve_worst(regular_jacobian);
    approach(MotionAim::surface);
    approach(MotionAim::flat);
    lengthen_short_edges();
    for (const double shape :
         {options_.flat_floor - 0.008, std::max(least_shape, options_.flat_floor - shape_given_up)})
      move_jointly(nodes_, connectivity_, mesh_.freedom, lines_,
                   {options_.size, options_.min_edge * 1.001, shape, surface_share * options_.size,
                    crest_share * options_.size});
    return true;
  }

  /// The circle of nodes around them widens while they stay short.
  void lengthen_short_edges() {
    for (int round = 0; round < 25; ++round) {
      std::vector<Index> nodes = nodes_of_short_edges();
      if (nodes.empty()) return;
      bool moved = false;
      for (int ring = 0; ring <= std::min(round / 4, 3); ++ring) {
        for (const Index node : nodes) moved |= motion_.optimise(node, MotionAim::edges);
        nodes = widened(nodes);
      }
      if (!moved) return;
    }
  }

  std::vector<Index> nodes_of_short_edges() const {
    std::vector<bool> marked(connectivity_.node_count(), false);
    for (Index node = 0; node < connectivity_.node_count(); ++node)
      if (motion_.is_movable(node) && motion_.shortfall(node) > 0) marked[node] = true;
    return movable(marked);
  }

  double worst() const {
    double least = 1;
    for (const MeshElement& element : mesh_.elements)
      least = std::min(least, signed_quality(nodes_, element));
    return least;
  }

  SmoothingReport report() const {
    SmoothingReport report;
    report.scaled_jacobian_min = mesh_.elements.empty() ? 0 : 1;
    double sum = 0;
    for (const MeshElement& element : mesh_.elements) {
      const double quality = signed_quality(nodes_, element);
      report.scaled_jacobian_min = std::min(report.scaled_jacobian_min, quality);
      sum += quality;
      if (quality <= 0) ++report.inverted;
    }
    if (!mesh_.elements.empty())
      report.scaled_jacobian_mean = sum / static_cast<double>(mesh_.elements.size());
    report.edges_below_min = count_short_edges();
    if (options_.surface_passes > 0)
      for (Index node = 0; node < connectivity_.node_count(); ++node)
        if (!connectivity_.star(node).empty())
          report.deviation = std::max(report.deviation, motion_.deviation(node));
    return report;
  }

  int count_short_edges() const {
    int count = 0;
    for (const MeshElement& element : mesh_.elements)
      for (int i = 0; i < corner_count(element); ++i) {
        const Index a = element[i], b = element[(i + 1) % corner_count(element)];
        // An inner edge is met from both sides, a boundary edge once.
        if (a > b && connectivity_.element_with_edge(b, a) != no_index) continue;
        if (distance(nodes_.space(a), nodes_.space(b)) < options_.min_edge * (1 - 1e-6)) ++count;
      }
    return count;
  }

  PlanarMesh& mesh_;
  const SmoothingOptions options_;
  SurfaceNodes nodes_;
  QuadConnectivity connectivity_;
  SlidingLines lines_;
  NodeMotion motion_;
  tbb::enumerable_thread_specific<NodeMotion> motions_{[this] { return motion_; }};
  std::vector<Index> colours_;
};

}  // namespace

SmoothingReport smooth(PlanarMesh& mesh, const SurfaceMap* map, std::vector<SlidingLine>& lines,
                       const SmoothingOptions& options) {
  Smoother smoother(mesh, map, lines, options);
  const SmoothingReport report = smoother.run();
  lines = smoother.lines();
  return report;
}

SmoothingReport smooth(PlanarMesh& mesh, const SurfaceMap* map, const SmoothingOptions& options) {
  return Smoother(mesh, map, {}, options).run();
}

}  // namespace beadmesh
