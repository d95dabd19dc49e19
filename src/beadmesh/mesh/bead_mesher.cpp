#include "beadmesh/mesh/bead_mesher.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "beadmesh/bead/crest_offset.h"
#include "beadmesh/blocking/annular_blocks.h"
#include "beadmesh/blocking/bead_blocks.h"
#include "beadmesh/blocking/element_counts.h"
#include "beadmesh/blocking/narrow_blocks.h"
#include "beadmesh/geometry/polyline.h"
#include "beadmesh/mesh/bead_section.h"
#include "beadmesh/mesh/block_mesher.h"
#include "beadmesh/mesh/quality_criteria.h"
#include "beadmesh/mesh/ridge_insertion.h"
#include "beadmesh/mesh/smoothing.h"
#include "beadmesh/mesh/topological_cleanup.h"

namespace beadmesh {
namespace {

/// Worst scaled Jacobian that a bead mesh may show before the next method is tried.
constexpr double acceptable_jacobian = 0.35;
/// Fewer elements across are tried where no score reaches it.
constexpr double fair_score = 0.5;
/// In rings also where the worst shape is under it.
constexpr double fair_shape_of_rings = 0.93;
/// Scaled Jacobian that is given up for the surface and for warpage: in beads with and without junctions.
/// Where arms meet in mitres, corners are sharper anyhow; rings have no corner at all.
constexpr double floor_of_junctions = 0.7, floor_without = 0.858, floor_of_rings = 0.94;
/// What falls short of the floor by less is good enough to stop looking for a better variant.
constexpr double good_enough = 0.015;
/// Shapes that are better than the floor count so much less.
constexpr double surplus_share = 0.2;
/// What is missing to the floor counts so much more.
constexpr double shortfall_weight = 2;

/// What a bead would lose in score if all of its elements failed the usual criteria.
constexpr double failure_cost = 4;

/// More than the worst scaled Jacobian gains (up to 0.06 has been seen) while the elements come nearer to the
/// surface: a variant further behind the best is given up before.
constexpr double most_gain_on_surface = 0.12;
/// The same once they have come nearer.
constexpr double most_gain_when_near = 0.05;

/// Distance between a section of the bead and the elements across it, as a share of the size.
constexpr double acceptable_deviation = 0.08;
/// What a bead loses in score for each size that it lies further from the surface.
constexpr double deviation_cost = 5;
constexpr int most_across = 12;
/// Two rows around the core follow a wall; the core needs two elements more.
constexpr int least_across_of_two_bands = 6;
/// What a cut across may lose of its width in clamps and hubs.
constexpr double across_margin = 1.03;
/// In minimum lengths: narrower beads may be too narrow for the corners of a clamp, though two elements fit
/// across.
constexpr double narrow_width = 3;

struct Width {
  double mean = 0, least = 0;
};

/// Thickness over the arms; the ends are left out, where clamps narrow it on purpose.
Width width_of(const Skeleton& skeleton) {
  double sum = 0, length = 0, least = 1e300;
  for (const SkeletonArm& arm : skeleton.arms)
    for (size_t i = 0; i < arm.points.size(); ++i) {
      if (i > 0) {
        const double step = distance(arm.points[i - 1].point, arm.points[i].point);
        sum += step * (arm.points[i - 1].radius + arm.points[i].radius);
        length += step;
      }
      least = std::min(least, 2 * arm.points[i].radius);
    }
  return {length > 0 ? sum / length : least, least};
}

Result<BeadMesh> mesh_layout(Result<BlockLayout> layout, const SurfaceMap& map,
                             const BeadMesherOptions& options) {
  if (!layout) return tl::unexpected(layout.error());
  const auto counted = assign_counts(*layout, edge_lengths(*layout, map), {options.size, options.min_edge});
  if (!counted) return tl::unexpected(counted.error());
  BeadMesh mesh = map_blocks(*layout, map);
  mesh.method = "blocks";
  return mesh;
}

struct Judged {
  BeadMesh mesh;
  double shape = 0;   ///< worst scaled Jacobian
  double score = 0;   ///< worst scaled Jacobian, less what the distance from the surface takes away
  double rank = 0;    ///< the score, less what failing elements take away: the best of all attempts is kept
  bool good = false;  ///< no better one need be looked for
};

/// `floor`: the scaled Jacobian beyond which more counts little.
double score_of(const SmoothingReport& report, double size, double floor) {
  const double excess = std::max(0.0, report.deviation / size - acceptable_deviation);
  const double surplus = report.scaled_jacobian_min - floor;
  return floor + (surplus > 0 ? surplus_share : shortfall_weight) * surplus - deviation_cost * excess;
}

/// The loops of the boundary as lines to slide along, but for those whose nodes a neighbour has set. Tips
/// stay, and so does all of a bead one element wide: nothing inside would hold its sides.
void free_boundary(BeadMesh& mesh, const PlanarRegion& region, const BeadMesherOptions& options) {
  if (mesh.crest_lines.empty()) return;
  std::vector<bool> is_tip(mesh.mesh.nodes.size(), false);
  for (const auto& crest : mesh.crest_lines) is_tip[crest.front()] = is_tip[crest.back()] = true;
  for (Index l = 0; l < Index(region.loops.size()); ++l) {
    if (l < Index(options.prescribed.size()) && !options.prescribed[l].empty()) continue;
    SlidingLine line{Polyline<Vec2>(region.loops[l].points, true), {}, {}, false};
    const double length = line.curve.length();
    std::vector<std::pair<double, Index>> nodes;
    for (const BoundaryNode& node : mesh.boundary)
      if (node.at.loop == l)
        nodes.emplace_back(node.at.position - std::floor(node.at.position / length) * length, node.node);
    std::sort(nodes.begin(), nodes.end());
    for (const auto& [at, node] : nodes) {
      line.at.push_back(at);
      line.nodes.push_back(node);
      if (!is_tip[node]) mesh.mesh.freedom[node] = NodeFreedom::sliding;
    }
    mesh.lines.push_back(std::move(line));
  }
}

/// The boundary nodes where they have slid to, to stay there.
void take_over_boundary(BeadMesh& mesh) {
  std::vector<double> at(mesh.mesh.nodes.size(), -1);
  for (const SlidingLine& line : mesh.lines)
    for (size_t i = 0; i < line.nodes.size(); ++i)
      if (line.curve.is_closed()) at[line.nodes[i]] = line.at[i];
  for (BoundaryNode& node : mesh.boundary) {
    NodeFreedom& freedom = mesh.mesh.freedom[node.node];
    if (freedom == NodeFreedom::sliding) node.at.position = at[node.node];
    freedom = NodeFreedom::fixed;
  }
}

std::vector<Vec3> on_surface(const PlanarMesh& mesh, const FaceStudy& study) {
  std::vector<Vec3> nodes;
  for (const Vec2 p : mesh.nodes) nodes.push_back(study.lift(p));
  return nodes;
}

double share_of_failing(const PlanarMesh& mesh, const FaceStudy& study, const BeadMesherOptions& options) {
  const std::vector<Vec3> nodes = on_surface(mesh, study);
  const QualityCriteria criteria = criteria_of_sizes(options.size, options.min_edge);
  const auto failing = std::count_if(mesh.elements.begin(), mesh.elements.end(),
                                     [&](const MeshElement& e) { return fails_any(nodes, e, criteria); });
  return mesh.elements.empty() ? 0 : double(failing) / double(mesh.elements.size());
}

double shortest_edge(const PlanarMesh& mesh, const FaceStudy& study) {
  const std::vector<Vec3> nodes = on_surface(mesh, study);
  double shortest = 1e300;
  for (const MeshElement& element : mesh.elements)
    for (int i = 0; i < corner_count(element); ++i)
      shortest =
          std::min(shortest, distance(nodes[element[i]], nodes[element[(i + 1) % corner_count(element)]]));
  return shortest;
}

/// The score, less what failing elements take away.
double rank_of(double score, const PlanarMesh& mesh, const FaceStudy& study,
               const BeadMesherOptions& options) {
  return score - failure_cost * share_of_failing(mesh, study, options);
}

bool is_long_enough(const PlanarMesh& mesh, const FaceStudy& study, double min_edge) {
  return shortest_edge(mesh, study) >= min_edge * (1 - 1e-6);
}

/// Lengths are kept on the facets. Where an edge falls under the minimum on the surface itself, it is
/// smoothed again with as much more; not where the rank is so far behind `best_rank` that it is given up
/// anyhow.
SmoothingReport smooth_on_surface(BeadMesh& mesh, const FaceStudy& study, const BeadMesherOptions& options,
                                  double floor, double best_rank) {
  const BeadMesh before = mesh;
  SmoothingOptions smoothing{options.size, options.min_edge, 20, 10, 10, best_rank - most_gain_on_surface,
                             floor};
  smoothing.hopeless_when_near = best_rank - most_gain_when_near;
  SmoothingReport report = smooth(mesh.mesh, study.map.get(), mesh.lines, smoothing);
  if (report.given_up || report.edges_below_min > 0) return report;
  if (is_long_enough(mesh.mesh, study, options.min_edge)) return report;
  const double rank = rank_of(score_of(report, options.size, floor), mesh.mesh, study, options);
  report.given_up = rank < best_rank - most_gain_on_surface;
  if (report.given_up) return report;
  smoothing.min_edge *= std::min(1.08, 1.003 * options.min_edge / shortest_edge(mesh.mesh, study));
  mesh = before;
  report = smooth(mesh.mesh, study.map.get(), mesh.lines, smoothing);
  report.edges_below_min = is_long_enough(mesh.mesh, study, options.min_edge) ? 0 : 1;
  return report;
}

/// Smooths and judges. What falls short is said in the failure; so is a shape far behind the best rank so
/// far.
Result<Judged> finished(Result<BeadMesh> mesh, const FaceStudy& study, const BeadMesherOptions& options,
                        double floor, double best_rank) {
  if (!mesh) return tl::unexpected(mesh.error());
  free_boundary(*mesh, study.region, options);
  const SmoothingReport report = smooth_on_surface(*mesh, study, options, floor, best_rank);
  take_over_boundary(*mesh);
  if (report.inverted > 0)
    return fail("mesh.bead.inverted", std::to_string(report.inverted) + " elements inverted");
  if (report.edges_below_min > 0)
    return fail("mesh.bead.min_edge",
                std::to_string(report.edges_below_min) + " edges under the minimum length");
  if (report.given_up || report.scaled_jacobian_min < acceptable_jacobian)
    return fail("mesh.bead.jacobian",
                "scaled Jacobian " + std::to_string(report.scaled_jacobian_min).substr(0, 5));
  const double score = score_of(report, options.size, floor),
               rank = rank_of(score, mesh->mesh, study, options);
  return Judged{std::move(*mesh), report.scaled_jacobian_min, score, rank,
                rank == score && score > floor - good_enough};
}

std::vector<std::array<Index, 2>> crest_edges(const BeadMesh& mesh) {
  std::vector<std::array<Index, 2>> edges;
  for (const auto& line : mesh.crest_lines)
    for (size_t i = 1; i < line.size(); ++i) edges.push_back({line[i - 1], line[i]});
  return edges;
}

void renumber(BeadMesh& mesh, const std::vector<Index>& renumbered) {
  if (renumbered.empty()) return;
  for (BoundaryNode& node : mesh.boundary) node.node = renumbered[node.node];
  for (auto& line : mesh.crest_lines)
    for (Index& n : line) n = renumbered[n];
}

bool is_prescribed(const BeadMesherOptions& options) {
  return std::any_of(options.prescribed.begin(), options.prescribed.end(),
                     [](const auto& l) { return !l.empty(); });
}

class BeadMesher {
 public:
  BeadMesher(const FaceStudy& study, const MedialObject& medial, const BeadMesherOptions& options)
      : study_(study),
        options_(options),
        skeleton_(skeleton_of(medial)),
        crest_(moved_to_crest(skeleton_, *study.map)),
        width_(width_of(skeleton_)) {}

  Result<BeadMesh> annular() {
    AnnularBlockOptions blocks;
    blocks.prescribed = options_.prescribed;
    blocks.elements_on_loop = elements_on_loops();
    floor_ = floor_of_rings;
    if (const auto asked = options_.control.elements_along) {
      if (const auto fits = check_around(*asked); !fits) return tl::unexpected(fits.error());
      blocks.elements_on_loop.assign(2, *asked);
    }
    for (int m : counts_across()) {
      blocks.elements_across = across_ = m;
      if (attempt("blocks", [&] {
            return mesh_layout(blocks_of_annular_bead(crest_, study_.region, blocks), *study_.map, options_);
          }))
        return result();
      // Fewer elements across leave more room for graded rows, and in tight corners.
      if (best_ && best_->score >= fair_score && best_->shape >= fair_shape_of_rings) return result();
    }
    if (best_) return result();
    return last_resort([&] {
      blocks.elements_across = 1;
      return blocks_of_annular_bead(crest_, study_.region, blocks);
    });
  }

  Result<BeadMesh> armed() {
    if (is_prescribed(options_))
      return fail("mesh.bead.prescribed", "a neighbour has set the nodes of its boundary");
    const RidgeGraph ridge = ridge_of(crest_, study_.region, study_.map.get());
    const bool joins = std::any_of(ridge.nodes.begin(), ridge.nodes.end(),
                                   [](const RidgeNode& node) { return node.arms.size() > 1; });
    floor_ = joins ? floor_of_junctions : floor_without;
    for (int m : counts_across()) {
      across_ = m;
      if (armed_with(ridge, m, forms(m, joins))) return result();
      // Fewer elements across only where no clamp would do.
      if (best_ && best_->score >= fair_score) return result();
    }
    if (best_) return result();
    return last_resort([&] {
      return blocks_of_narrow_bead(skeleton_, ridge, study_.region, {options_.size, options_.min_edge});
    });
  }

 private:
  /// How arms end and meet.
  struct Form {
    HubForm hub;
    int bands;
  };

  /// Forms to be tried with m elements across, the likeliest first.
  static std::vector<Form> forms(int elements_across, bool joins) {
    std::vector<Form> out;
    const int most_bands = elements_across >= least_across_of_two_bands ? 2 : 1;
    for (int bands = most_bands; bands >= 1; --bands) {
      if (joins) out.push_back({HubForm::mitre, bands});
      if (joins && bands == most_bands) out.push_back({HubForm::fan, bands});
      out.push_back({HubForm::square, bands});
    }
    return out;
  }

  /// Every form, then the best of them with other rows in its clamps; true where one is good enough.
  bool armed_with(const RidgeGraph& ridge, int elements_across, const std::vector<Form>& forms) {
    Form best = forms.front();
    for (const Form& form : forms) {
      const double before = best_ ? best_->rank : -1e300;
      if (attempt_form(ridge, elements_across, form, 0)) return true;
      if (best_ && best_->rank > before) best = form;
    }
    for (int extra_rows : {1, -1, 2}) {
      if (options_.control.clamp_rows) break;
      if (attempt_form(ridge, elements_across, best, extra_rows)) return true;
    }
    return false;
  }

  bool attempt_form(const RidgeGraph& ridge, int elements_across, const Form& form, int extra_rows) {
    const BeadBlockOptions blocks{options_.size,
                                  options_.min_edge,
                                  elements_across,
                                  extra_rows,
                                  options_.control.elements_along.value_or(0),
                                  options_.control.clamp_rows.value_or(0),
                                  form.bands,
                                  form.hub};
    return attempt("blocks", [&] {
      return mesh_layout(blocks_of_bead(skeleton_, ridge, study_.region, blocks), *study_.map, options_);
    });
  }

  BeadMethod method() const { return options_.control.method.value_or(BeadMethod::automatic); }

  /// Elements across to be tried by blocks, best first; none where another method is asked for.
  std::vector<int> counts_across() const {
    if (method() == BeadMethod::ridge) return {};
    if (const auto asked = options_.control.elements_across)
      return *asked > 1 ? std::vector<int>{*asked} : std::vector<int>{};
    std::vector<int> counts;
    for (int m = across(); m >= 2; m -= 2)
      if (m * options_.min_edge <= width_.least) counts.push_back(m);
    return counts;
  }

  std::vector<int> elements_on_loops() const {
    double axis = 0;
    for (const SkeletonArm& arm : skeleton_.arms) axis += length_of(arm);
    std::vector<int> counts = options_.elements_on_loop;
    counts.resize(2);
    for (int& count : counts)
      if (!count) count = std::max(8, 2 * int(std::lround(axis / options_.size / 2)));
    return counts;
  }

  Result<void> check_around(int asked) const {
    if (asked < 8 || asked % 2)
      return fail("mesh.bead.around", "a ring needs an even number of elements around, at least 8");
    for (const auto& nodes : options_.prescribed)
      if (!nodes.empty() && int(nodes.size()) != asked)
        return fail("mesh.bead.around", "a neighbour has set " + std::to_string(nodes.size()) + " around");
    return {};
  }

  /// The even number nearest to the size; more where the sections need it and the minimum length allows it.
  int across() const {
    int m = elements_across(width_.mean, width_.least, {options_.size, options_.min_edge});
    while (m < most_across && (m + 2) * across_margin * options_.min_edge <= width_.least &&
           section_deviation(crest_, *study_.map, m) > acceptable_deviation * options_.size)
      m += 2;
    return m;
  }

  /// Keeps the best mesh so far; true where it is good enough to stop.
  bool attempt(const std::string& name, const std::function<Result<BeadMesh>()>& make) {
    auto mesh = make();
    if (mesh && !is_new(mesh->mesh)) return false;
    auto judged = finished(std::move(mesh), study_, options_, floor_, best_ ? best_->rank : -2);
    if (!judged) {
      const std::string reason = name + ": " + judged.error().message;
      if (std::find(reasons_.begin(), reasons_.end(), reason) == reasons_.end()) reasons_.push_back(reason);
      return false;
    }
    const bool good = judged->good;
    if (!best_ || judged->rank > best_->rank) {
      best_ = std::move(*judged);
      if (best_->mesh.method == "blocks") best_->mesh.elements_across = across_;
    }
    return good;
  }

  /// Clamps differ in name only where there is no room for what they ask.
  bool is_new(const PlanarMesh& start) {
    const bool known = std::any_of(tried_.begin(), tried_.end(), [&](const PlanarMesh& other) {
      return other.nodes == start.nodes && other.elements == start.elements;
    });
    if (!known) tried_.push_back(start);
    return !known;
  }

  /// Reasons are told only where the first method failed altogether.
  Result<BeadMesh> result() {
    if (best_->mesh.method != "blocks") best_->mesh.notes = reasons_;
    if (best_->mesh.elements_across == 1)
      best_->mesh.notes.push_back("one element across: two of the minimum length do not fit");
    return std::move(best_->mesh);
  }

  /// One element across where two do not fit, then ridge insertion.
  Result<BeadMesh> last_resort(const std::function<Result<BlockLayout>()>& narrow) {
    if (method() != BeadMethod::ridge && options_.control.elements_across.value_or(1) == 1 &&
        width_.least < narrow_width * options_.min_edge) {
      across_ = 1;
      if (width_.least < options_.min_edge)
        reasons_.push_back("blocks: narrower than the minimum length");
      else
        attempt("blocks one element wide", [&] { return mesh_layout(narrow(), *study_.map, options_); });
      if (best_) return result();
    }
    if (!is_prescribed(options_) && method() != BeadMethod::blocks)
      attempt("ridge", [&] { return by_ridge(); });
    if (best_) return result();
    std::string all;
    for (const std::string& reason : reasons_) all += (all.empty() ? "" : "; ") + reason;
    return fail("mesh.bead.failed", all);
  }

  Result<BeadMesh> by_ridge() {
    const RidgeGraph ridge = ridge_of(crest_, study_.region, study_.map.get());
    auto mesh =
        mesh_by_ridge_insertion(ridge, study_.region, *study_.map, {options_.size, options_.min_edge});
    if (!mesh) return mesh;
    const CleanupReport report =
        clean_up(mesh->mesh, study_.map.get(), crest_edges(*mesh), {options_.size, options_.min_edge});
    renumber(*mesh, report.renumbered);
    for (const auto& crest : mesh->crest_lines) mesh->lines.push_back(line_through(crest, mesh->mesh.nodes));
    return mesh;
  }

  const FaceStudy& study_;
  BeadMesherOptions options_;
  Skeleton skeleton_;
  Skeleton crest_;  ///< the same, its points on the crest
  Width width_;
  double floor_ = floor_without;
  int across_ = 0;  ///< of the blocks tried last
  std::vector<std::string> reasons_;
  std::vector<PlanarMesh> tried_;  ///< before smoothing
  std::optional<Judged> best_;
};

}  // namespace

Result<BeadMesh> mesh_bead(const FaceStudy& study, const MedialObject& medial, BeadKind kind,
                           const BeadMesherOptions& options) {
  if (options.control.elements_across == 1)
    return fail("mesh.bead.across", "blocks need two elements across, one on each side of the crest");
  BeadMesher mesher(study, medial, options);
  return kind == BeadKind::annular ? mesher.annular() : mesher.armed();
}

}  // namespace beadmesh
