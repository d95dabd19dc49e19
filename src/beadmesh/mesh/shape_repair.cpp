#include "beadmesh/mesh/shape_repair.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "beadmesh/mesh/corner_pillow.h"
#include "beadmesh/mesh/element_zone.h"
#include "beadmesh/mesh/node_motion.h"
#include "beadmesh/mesh/smoothing.h"
#include "beadmesh/mesh/subdivision_mesher.h"
#include "beadmesh/mesh/topological_cleanup.h"

namespace beadmesh {
namespace {

constexpr int fewest_rings = 2, most_rings = 6, most_rounds = 3;
constexpr double flat_corner = radians(138);  ///< a single quad there has a scaled Jacobian under 0.67
constexpr double clear_gain = 0.03;           ///< of the worst scaled Jacobian
/// What an irregular node or a triangle more takes off the worst scaled Jacobian of a zone.
constexpr double irregular_cost = 0.006, triangle_cost = 0.2;
/// A mesh that is poor all over is not repaired zone by zone: zones looked at in a round, and zones tried in
/// vain in all.
constexpr int most_failures = 5;
/// Elements in all that is tried for evenness and length, so that the time stays linear: so many, and one for
/// each of the mesh.
constexpr size_t least_budget = 4000;
/// Where shape is good and only evenness or length is not, movements and small zones help, or nothing does.
constexpr int most_rings_uneven = 3;
constexpr int fewest_zones = 40, share_of_elements = 100;

/// Evenness is put on the scale of scaled Jacobians: what programs let fail under 0.6 is wanted from 0.62 on.
constexpr double evenness_offset = 0.03;
/// Sides longer than this many sizes fail.
constexpr double longest_side = 2;

/// Zones that share no element are looked at at once, at most so many.
constexpr size_t most_at_once = 4;

/// Angles first, by all that can be tried; then, in small zones, what else fails.
enum class Aim { shape, all };

/// How good an element is by the criteria that fail: angles (the scaled Jacobian), evenness and long sides,
/// on the scale of the first. Sides between fixed nodes are given.
double standing(const SurfaceNodes& nodes, const std::vector<NodeFreedom>& freedom,
                const MeshElement& element, const ShapeRepairOptions& options, Aim aim) {
  const double shape = signed_quality(nodes, element);
  if (shape <= 0 || aim == Aim::shape) return shape;
  double longest = 0;
  for (int i = 0; i < corner_count(element); ++i) {
    const Index a = element[i], b = element[(i + 1) % corner_count(element)];
    if (freedom[a] != NodeFreedom::fixed || freedom[b] != NodeFreedom::fixed)
      longest = std::max(longest, distance(nodes.space(a), nodes.space(b)));
  }
  const double limit = longest_side * options.size;
  const double length = longest > limit ? options.wanted * limit / longest - 1e-3 : 1;
  return std::min({shape, evenness(nodes, element) + evenness_offset, length});
}

/// A few elements of a mesh as a mesh of their own, everything on their outline fixed.
struct Zone {
  PlanarMesh mesh;
  std::vector<Index> original;  ///< of the fixed nodes, which come first
};

Zone zone_of(const PlanarMesh& whole, const QuadConnectivity& connectivity,
             const std::vector<Index>& elements) {
  std::vector<MeshElement> own;
  for (const Index e : elements) own.push_back(connectivity.element(e));
  std::set<Index> fixed, free;
  for (const MeshElement& element : own)
    for (int i = 0; i < corner_count(element); ++i)
      (whole.freedom[element[i]] == NodeFreedom::free ? free : fixed).insert(element[i]);
  for (const auto& edge : outline_of(own))
    for (const Index n : edge) free.erase(n), fixed.insert(n);
  Zone zone;
  std::map<Index, Index> local;
  const auto add = [&](Index n, NodeFreedom freedom) {
    local[n] = Index(zone.mesh.nodes.size());
    zone.mesh.nodes.push_back(whole.nodes[n]);
    zone.mesh.freedom.push_back(freedom);
  };
  for (const Index n : fixed) add(n, NodeFreedom::fixed), zone.original.push_back(n);
  for (const Index n : free) add(n, NodeFreedom::free);
  for (MeshElement& element : own)
    for (int i = 0; i < corner_count(element); ++i) element[i] = local[element[i]];
  zone.mesh.elements = std::move(own);
  return zone;
}

class ShapeRepair {
 public:
  /// `budget`: elements that may still be tried where the aim is not shape.
  ShapeRepair(PlanarMesh& mesh, const SurfaceMap* map, const ShapeRepairOptions& options, Aim aim,
              long& budget)
      : mesh_(mesh), connectivity_(mesh), map_(map), options_(options), aim_(aim), budget_(budget) {}

  /// One round; counts what it tries in vain in `failed`.
  int run(int& failed) {
    int exchanged = 0;
    std::vector<Index> waiting = poor_elements();
    while (!waiting.empty() && !is_enough(failed)) {
      const std::vector<Index> seeds = next_seeds(waiting, most_failures - failed);
      std::vector<Repair> repairs(seeds.size());
      tbb::parallel_for(size_t(0), seeds.size(), [&](size_t i) { repairs[i] = repair(seeds[i]); });
      for (const Repair& one : repairs) {
        if (is_enough(failed)) break;
        budget_ -= one.tried;
        if (one.best) exchange(*one.best);
        ++(one.best ? exchanged : failed);
      }
    }
    std::vector<Index> number;
    if (exchanged > 0) mesh_ = living_part(connectivity_, mesh_.nodes, mesh_.freedom, number);
    return exchanged;
  }

 private:
  struct Worth {
    double worst = 1, shortest = 1e300, score = 0;
    int irregular = 0;
  };

  struct Candidate {
    std::vector<Index> elements;
    std::vector<Index> original;
    PlanarMesh mesh;
    Worth worth;
  };

  /// What came out of one seed.
  struct Repair {
    std::optional<Candidate> best;
    long tried = 0;  ///< elements, over all attempts
  };

  bool is_enough(int failed) const { return failed >= most_failures || (aim_ == Aim::all && budget_ <= 0); }

  /// The first that are still poor and whose largest zones share no element; those that have to wait for them
  /// stay in `waiting`.
  std::vector<Index> next_seeds(std::vector<Index>& waiting, int most) const {
    std::vector<Index> seeds, later;
    std::set<Index> taken;
    size_t looked_at = 0;
    for (; looked_at < waiting.size() && seeds.size() < std::min<size_t>(most, most_at_once); ++looked_at) {
      const Index e = waiting[looked_at];
      if (!connectivity_.is_alive(e) || shape_of(e) >= options_.wanted || is_near_given(e)) continue;
      const std::vector<Index> zone = elements_within(connectivity_, e, largest_rings());
      if (std::any_of(zone.begin(), zone.end(), [&](Index other) { return taken.count(other) > 0; }))
        later.push_back(e);
      else
        seeds.push_back(e);
      taken.insert(zone.begin(), zone.end());
    }
    later.insert(later.end(), waiting.begin() + static_cast<std::ptrdiff_t>(looked_at), waiting.end());
    waiting = std::move(later);
    return seeds;
  }

  int largest_rings() const { return aim_ == Aim::all ? most_rings_uneven : most_rings; }

  /// A boundary with edges under the minimum, or a face narrower than that, is given: no mesh inside makes it
  /// better.
  bool is_given(Index e) const {
    const MeshElement& element = connectivity_.element(e);
    for (int i = 0; i < corner_count(element); ++i) {
      const Index a = element[i], b = element[(i + 1) % corner_count(element)];
      if (mesh_.freedom[a] != NodeFreedom::fixed || mesh_.freedom[b] != NodeFreedom::fixed) continue;
      const SurfaceNodes ends({mesh_.nodes[a], mesh_.nodes[b]}, map_);
      if (distance(ends.space(0), ends.space(1)) < options_.min_edge * (1 - 1e-6)) return true;
    }
    return false;
  }

  bool is_near_given(Index e) const {
    const std::vector<Index> near = elements_within(connectivity_, e, fewest_rings);
    return std::any_of(near.begin(), near.end(), [&](Index other) { return is_given(other); });
  }

  double shape_of(Index e) const {
    const MeshElement& element = connectivity_.element(e);
    PlanarMesh one;
    for (int i = 0; i < corner_count(element); ++i) {
      one.nodes.push_back(mesh_.nodes[element[i]]);
      one.freedom.push_back(mesh_.freedom[element[i]]);
    }
    one.elements.push_back({0, 1, 2, is_quad(element) ? 3 : no_index});
    return standing(SurfaceNodes(one.nodes, map_), one.freedom, one.elements[0], options_, aim_);
  }

  std::vector<Index> poor_elements() const {
    const SurfaceNodes nodes(mesh_.nodes, map_);
    std::vector<std::pair<double, Index>> poor;
    for (Index e = 0; e < Index(mesh_.elements.size()); ++e) {
      const double shape = standing(nodes, mesh_.freedom, mesh_.elements[e], options_, aim_);
      if (shape < options_.wanted) poor.emplace_back(shape, e);
    }
    std::sort(poor.begin(), poor.end());
    poor.resize(std::min(poor.size(), fewest_zones + mesh_.elements.size() / share_of_elements));
    std::vector<Index> out;
    for (const auto& [shape, e] : poor) out.push_back(e);
    return out;
  }

  Worth worth_of(const PlanarMesh& zone) const {
    const SurfaceNodes nodes(zone.nodes, map_);
    Worth worth;
    std::vector<int> valence(zone.nodes.size(), 0);
    int triangles = 0;
    for (const MeshElement& e : zone.elements) {
      worth.worst = std::min(worth.worst, standing(nodes, zone.freedom, e, options_, aim_));
      triangles += !is_quad(e);
      for (int i = 0; i < corner_count(e); ++i) {
        ++valence[e[i]];
        worth.shortest =
            std::min(worth.shortest, distance(nodes.space(e[i]), nodes.space(e[(i + 1) % corner_count(e)])));
      }
    }
    for (size_t n = 0; n < zone.nodes.size(); ++n)
      worth.irregular += zone.freedom[n] == NodeFreedom::free && valence[n] != 4;
    worth.score = std::min(worth.worst, options_.wanted + 0.1) - irregular_cost * worth.irregular -
                  triangle_cost * triangles;
    return worth;
  }

  /// All that is tried on one zone; nothing where it is not clearly better than before.
  std::optional<Candidate> polished(PlanarMesh zone, const Worth& before) const {
    SmoothingOptions smoothing{options_.size, options_.min_edge};
    if (aim_ == Aim::shape) smoothing.aim = SmoothingOptions::Aim::angles;
    smooth(zone, map_, smoothing);
    clean_up(zone, map_, {}, {options_.size, options_.min_edge});
    smooth(zone, map_, smoothing);
    if (worth_of(zone).worst < options_.wanted)
      relieve_flat_corners(zone, map_, {options_.size, options_.min_edge, flat_corner});
    const Worth worth = worth_of(zone);
    const double shortest = std::min(before.shortest, options_.min_edge);
    if (worth.shortest < shortest || worth.worst < before.worst + clear_gain || worth.score <= before.score)
      return std::nullopt;
    return Candidate{{}, {}, std::move(zone), worth};
  }

  /// The zone with the elements in `inside` (numbers in it) replaced by loop splitting.
  std::optional<PlanarMesh> meshed_anew(const PlanarMesh& zone, const std::vector<bool>& inside) const {
    std::vector<MeshElement> removed;
    PlanarMesh out{zone.nodes, zone.freedom, {}};
    for (size_t e = 0; e < zone.elements.size(); ++e)
      (inside[e] ? removed : out.elements).push_back(zone.elements[e]);
    const auto closed = closed_loop(outline_of(removed));
    if (!closed || closed->size() % 2) return std::nullopt;
    std::vector<Index> loop = *closed;
    if (has_fixed_inside(zone, removed, loop)) return std::nullopt;
    NodeLoops loops;
    loops.loops.emplace_back();
    for (const Index n : loop) {
      loops.loops[0].push_back(Index(loops.nodes.size()));
      loops.nodes.push_back(zone.nodes[n]);
    }
    const auto filled = mesh_by_subdivision(loops, map_, {options_.size, options_.min_edge});
    if (!filled) return std::nullopt;
    for (size_t n = loop.size(); n < filled->nodes.size(); ++n) {
      loop.push_back(Index(out.nodes.size()));
      out.nodes.push_back(filled->nodes[n]);
      out.freedom.push_back(NodeFreedom::free);
    }
    for (MeshElement e : filled->elements) {
      for (Index& n : e)
        if (n != no_index) n = loop[n];
      out.elements.push_back(e);
    }
    return out;
  }

  static bool has_fixed_inside(const PlanarMesh& zone, const std::vector<MeshElement>& removed,
                               const std::vector<Index>& loop) {
    const std::set<Index> outline(loop.begin(), loop.end());
    for (const MeshElement& e : removed)
      for (int i = 0; i < corner_count(e); ++i)
        if (zone.freedom[e[i]] != NodeFreedom::free && !outline.count(e[i])) return true;
    return false;
  }

  /// The zone's elements without those within so many rings of the seed, which are meshed anew; the zone
  /// itself for none.
  std::optional<PlanarMesh> start(const Zone& zone, Index seed, const std::vector<Index>& elements,
                                  int inner) const {
    if (inner == 0) return zone.mesh;
    const std::vector<Index> core = elements_within(connectivity_, seed, inner);
    if (core.size() == elements.size()) return std::nullopt;
    std::vector<bool> inside;
    for (const Index e : elements) inside.push_back(std::binary_search(core.begin(), core.end(), e));
    return meshed_anew(zone.mesh, inside);
  }

  /// The best that can be made of the elements within so many rings; nothing where it is not clearly better.
  std::optional<Candidate> best_zone(Index seed, const std::vector<Index>& elements, int rings,
                                     long& tried) const {
    Zone zone = zone_of(mesh_, connectivity_, elements);
    const Worth before = worth_of(zone.mesh);
    std::vector<std::optional<Candidate>> candidates(rings);
    std::vector<long> sizes(rings, 0);
    const auto attempt = [&](int inner) {
      auto mesh = start(zone, seed, elements, inner);
      if (!mesh) return;
      sizes[inner] = static_cast<long>(mesh->elements.size());
      candidates[inner] = polished(std::move(*mesh), before);
    };
    attempt(0);
    // Movement and edits alone are enough where they make the zone sound and no less regular.
    const bool is_sound = candidates[0] && candidates[0]->worth.worst >= options_.wanted &&
                          candidates[0]->worth.irregular <= before.irregular;
    if (!is_sound) tbb::parallel_for(1, rings, attempt);
    tried = std::accumulate(sizes.begin(), sizes.end(), tried);
    std::optional<Candidate> best;
    for (auto& candidate : candidates)
      if (candidate && (!best || candidate->worth.score > best->worth.score)) best = std::move(candidate);
    if (best) best->elements = elements, best->original = std::move(zone.original);
    return best;
  }

  /// Larger zones only where none smaller comes right.
  Repair repair(Index seed) const {
    Repair out;
    size_t before = 0;
    for (int rings = fewest_rings;
         rings <= largest_rings() && (!out.best || out.best->worth.worst < options_.wanted); ++rings) {
      const std::vector<Index> elements = elements_within(connectivity_, seed, rings);
      if (elements.size() == before) break;  // the whole mesh
      before = elements.size();
      auto candidate = best_zone(seed, elements, rings, out.tried);
      if (candidate && (!out.best || candidate->worth.worst > out.best->worth.worst))
        out.best = std::move(candidate);
    }
    return out;
  }

  void exchange(const Candidate& better) {
    for (const Index e : better.elements) connectivity_.remove_element(e);
    std::vector<Index> number(better.original);
    for (size_t n = number.size(); n < better.mesh.nodes.size(); ++n) {
      number.push_back(connectivity_.add_node());
      mesh_.nodes.push_back(better.mesh.nodes[n]);
      mesh_.freedom.push_back(NodeFreedom::free);
    }
    for (MeshElement e : better.mesh.elements) {
      for (Index& n : e)
        if (n != no_index) n = number[n];
      connectivity_.add_element(e);
    }
  }

  PlanarMesh& mesh_;
  QuadConnectivity connectivity_;
  const SurfaceMap* map_;
  ShapeRepairOptions options_;
  Aim aim_;
  long& budget_;
};

}  // namespace

int repair_shapes(PlanarMesh& mesh, const SurfaceMap* map, const ShapeRepairOptions& options) {
  int exchanged = 0;
  for (const Aim aim : {Aim::shape, Aim::all}) {
    int failed = 0;
    long budget = static_cast<long>(least_budget + mesh.elements.size());
    for (int round = 0; round < most_rounds; ++round) {
      const int now = ShapeRepair(mesh, map, options, aim, budget).run(failed);
      exchanged += now;
      if (now == 0) break;
    }
  }
  return exchanged;
}

}  // namespace beadmesh
