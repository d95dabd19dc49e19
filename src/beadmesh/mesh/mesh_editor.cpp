#include "beadmesh/mesh/mesh_editor.h"

#include "beadmesh/mesh/element_zone.h"

#include <algorithm>

namespace beadmesh {
namespace {

using DirectedEdge = std::pair<Index, Index>;

std::array<Index, 2> ordered(Index a, Index b) {
  return {std::min(a, b), std::max(a, b)};
}

std::vector<DirectedEdge> directed_edges(const std::vector<MeshElement>& elements) {
  std::vector<DirectedEdge> edges;
  for (const MeshElement& element : elements) {
    const int count = corner_count(element);
    for (int i = 0; i < count; ++i) edges.emplace_back(element[i], element[(i + 1) % count]);
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Edges without a twin among the same elements: the outline of the disc.
std::vector<DirectedEdge> outline(const std::vector<MeshElement>& elements) {
  const std::vector<DirectedEdge> edges = directed_edges(elements);
  std::vector<DirectedEdge> result;
  for (const auto& [a, b] : edges)
    if (!std::binary_search(edges.begin(), edges.end(), DirectedEdge{b, a})) result.emplace_back(a, b);
  return result;
}

/// Angle from `from` counter-clockwise to `to`, in (0, 2 pi].
double turn(Vec2 from, Vec2 to) {
  const double angle = std::atan2(cross(from, to), dot(from, to));
  return angle > 1e-12 ? angle : angle + 2 * pi;
}

/// Right angles that the elements at a boundary node have to fill; its current valence where it is no plain
/// one.
double boundary_angle(const QuadConnectivity& mesh, const SurfaceNodes& nodes, Index node) {
  Index out = no_index, in = no_index;
  int outs = 0;
  for (const Index e : mesh.star(node)) {
    const auto [next, previous] = corner_neighbours(mesh.element(e), node);
    if (mesh.element_with_edge(next, node) == no_index) out = next, ++outs;
    if (mesh.element_with_edge(node, previous) == no_index) in = previous;
  }
  if (outs != 1 || in == no_index) return mesh.valence(node);
  return turn(nodes.flat(out) - nodes.flat(node), nodes.flat(in) - nodes.flat(node)) / (pi / 2);
}

double area(const SurfaceNodes& nodes, const MeshElement& element) {
  const Vec3 a = nodes.space(element[0]), b = nodes.space(element[1]), c = nodes.space(element[2]);
  return norm(is_quad(element) ? cross(c - a, nodes.space(element[3]) - b) : cross(b - a, c - a)) / 2;
}

/// Weight of the squared logarithm of length over size against the squared lack of scaled Jacobian.
constexpr double size_weight = 0.3;
/// Energy that one irregular node less may cost.
constexpr double price_of_regularity = 0.1;
/// Edits whose energy is so many times what is allowed, where the new nodes start and after one round of
/// relaxing, never come right; nor do those whose edges are so much too long then. Of 189 edits that were
/// kept on three panels the largest were 4.8 and 2.5 times (one above 2.0), and 0.96 too long; nine of ten
/// that were smoothed in vain are above.
constexpr double hopeless_at_start = 5, hopeless_when_relaxed = 2, hopeless_excess = 1.5;
constexpr double energy_room = 0.1;
/// By so much a corner between given nodes may get better when the fourth node moves off the plane.
constexpr double corner_room = 0.03;

}  // namespace

MeshEditor::MeshEditor(PlanarMesh& mesh, const SurfaceMap* map,
                       const std::vector<std::array<Index, 2>>& kept_edges, const EditorLimits& limits)
    : limits_(limits),
      nodes_(mesh.nodes, map),
      mesh_(mesh),
      freedom_(mesh.freedom),
      motion_(nodes_, mesh_, freedom_, no_lines_,
              {limits.size, limits.min_edge * 1.005, limits.good_enough}) {
  for (const auto& [a, b] : kept_edges) kept_edges_.push_back(ordered(a, b));
  std::sort(kept_edges_.begin(), kept_edges_.end());
  for (Index node = 0; node < mesh_.node_count(); ++node) {
    boundary_.push_back(mesh_.has_boundary_edge(node));
    angle_.push_back(boundary_[node] ? boundary_angle(mesh_, nodes_, node) : 4.0);
    if (boundary_[node]) freedom_[node] = NodeFreedom::fixed;
  }
}

bool MeshEditor::is_kept_edge(Index a, Index b) const {
  return std::binary_search(kept_edges_.begin(), kept_edges_.end(), ordered(a, b));
}

double MeshEditor::penalty(Index node, int valence) const {
  if (valence <= 0) return 1000;
  const double angle = angle_[node], miss = valence - angle, per_element = angle / valence;
  // At the boundary no valence may fit well: only what is worse than the best counts.
  const double best = boundary_[node] ? std::max(1.0, std::round(angle)) - angle : 0;
  double penalty = miss * miss - best * best;
  if (boundary_[node]) penalty *= 0.9;
  if (per_element > 1.6) penalty += 20 * (per_element - 1.5);
  return penalty;
}

int MeshEditor::count_irregular() const {
  int count = 0;
  for (Index node = 0; node < mesh_.node_count(); ++node) {
    const std::vector<Index>& star = mesh_.star(node);
    if (boundary_[node] || star.empty()) continue;
    const bool quads =
        std::all_of(star.begin(), star.end(), [&](Index e) { return is_quad(mesh_.element(e)); });
    if (star.size() != 4 || !quads) ++count;
  }
  return count;
}

int MeshEditor::count_triangles() const {
  int count = 0;
  for (Index e = 0; e < mesh_.element_count(); ++e)
    if (mesh_.is_alive(e) && !is_quad(mesh_.element(e))) ++count;
  return count;
}

std::vector<Index> MeshEditor::corners_of(const std::vector<MeshElement>& elements) const {
  std::vector<Index> nodes;
  for (const MeshElement& element : elements)
    nodes.insert(nodes.end(), element.begin(), element.begin() + corner_count(element));
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

bool MeshEditor::respects_kept_edges(const std::vector<MeshElement>& before,
                                     const std::vector<MeshElement>& after) const {
  if (kept_edges_.empty()) return true;
  const std::vector<DirectedEdge> edges = directed_edges(after);
  for (const auto& [a, b] : directed_edges(before))
    if (is_kept_edge(a, b) && !std::binary_search(edges.begin(), edges.end(), DirectedEdge{a, b}))
      return false;
  return true;
}

void MeshEditor::apply(const Replacement& edit, Undo& undo) {
  undo.element_count = mesh_.element_count();
  undo.node_count = mesh_.node_count();
  for (const Index e : edit.removed) {
    undo.removed.emplace_back(e, mesh_.element(e));
    mesh_.remove_element(e);
  }
  for (const Vec2 position : edit.new_nodes) {
    nodes_.add(nodes_.place(position, nodes_[undo.removed.front().second[0]].triangle));
    mesh_.add_node();
    freedom_.push_back(NodeFreedom::free);
    boundary_.push_back(false);
    angle_.push_back(4);
  }
  for (const MeshElement& element : edit.added) mesh_.add_element(element);
  for (const auto& [node, position] : edit.moved) {
    undo.places.emplace_back(node, nodes_[node]);
    nodes_.set(node, nodes_.place(position, nodes_[node].triangle));
  }
}

void MeshEditor::roll_back(const Undo& undo) {
  for (size_t i = undo.places.size(); i-- > 0;) nodes_.set(undo.places[i].first, undo.places[i].second);
  mesh_.remove_last_elements(undo.element_count);
  mesh_.remove_last_nodes(undo.node_count);
  nodes_.truncate(undo.node_count);
  freedom_.resize(undo.node_count);
  boundary_.resize(undo.node_count);
  angle_.resize(undo.node_count);
  for (const auto& [e, corners] : undo.removed) mesh_.restore_element(e, corners);
}

/// The outline is the same, no edge is used twice in one direction, no node lies between two elements only,
/// and nothing but free inner nodes has vanished.
bool MeshEditor::is_sound(const std::vector<MeshElement>& before, const std::vector<MeshElement>& after,
                          const std::vector<Index>& rim) const {
  if (outline(before) != outline(after)) return false;
  const std::vector<DirectedEdge> edges = directed_edges(after);
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return false;
  for (const MeshElement& element : after)
    for (int i = 0; i < corner_count(element); ++i)
      for (int j = 0; j < i; ++j)
        if (element[i] == element[j]) return false;
  for (const DirectedEdge& edge : edges) {
    int uses = 0;
    for (const Index e : mesh_.star(edge.first))
      uses += corner_neighbours(mesh_.element(e), edge.first).first == edge.second;
    if (uses != 1) return false;
  }
  for (const Index node : rim) {
    const int valence = mesh_.valence(node);
    if (valence == 0 && (boundary_[node] || !is_free(node))) return false;
    if (valence > 0 && valence < 3 && !boundary_[node]) return false;
  }
  return true;
}

/// Free nodes among the given ones and their neighbours, ascending.
std::vector<Index> MeshEditor::zone_around(const std::vector<Index>& nodes) const {
  std::vector<Index> zone;
  for (const Index node : nodes)
    for (const Index e : mesh_.star(node)) {
      const MeshElement& element = mesh_.element(e);
      for (int i = 0; i < corner_count(element); ++i)
        if (is_free(element[i])) zone.push_back(element[i]);
    }
  std::sort(zone.begin(), zone.end());
  zone.erase(std::unique(zone.begin(), zone.end()), zone.end());
  return zone;
}

std::vector<Index> MeshEditor::elements_around(const std::vector<Index>& nodes,
                                               const std::vector<Index>& zone) const {
  std::vector<Index> elements;
  for (const std::vector<Index>* list : {&nodes, &zone})
    for (const Index node : *list)
      elements.insert(elements.end(), mesh_.star(node).begin(), mesh_.star(node).end());
  std::sort(elements.begin(), elements.end());
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  return elements;
}

/// Scaled Jacobian that movements can reach at most: corners between nodes that stay are given.
double MeshEditor::reachable(const std::vector<Index>& elements) const {
  double least = 1;
  for (const Index e : elements) {
    const MeshElement& element = mesh_.element(e);
    const int count = corner_count(element);
    for (int i = 0; i < count; ++i) {
      if (is_free(element[i]) || is_free(element[(i + 1) % count]) ||
          is_free(element[(i + count - 1) % count]))
        continue;
      least = std::min(least, shapes_of(places_of(nodes_, element)).jacobian[i]);
    }
  }
  return least;
}

/// What the worst scaled Jacobian must be after an edit.
double MeshEditor::wanted_worst(const Judgement& before, EditAim aim) const {
  switch (aim) {
    case EditAim::longer_edges:
      return std::min(before.worst, 0.25);
    case EditAim::better_shape:
      return before.worst + 0.05;
    case EditAim::fewer_triangles:
      return std::min(before.worst, 0.3);
    case EditAim::fewer_irregular:
      break;
  }
  return std::min(before.worst, limits_.good_enough);
}

/// Seen before the nodes around an edit have been smoothed, or after a first round of it: will it be undone?
bool MeshEditor::is_hopeless(const Judgement& now, const Judgement& before, double share) const {
  const double gain = before.penalty - now.penalty;
  return now.energy > share * (before.energy + price_of_regularity * gain) + energy_room ||
         (share == hopeless_when_relaxed && now.excess > before.excess + hopeless_excess);
}

MeshEditor::Judgement MeshEditor::judge(const std::vector<Index>& nodes,
                                        const std::vector<Index>& zone) const {
  Judgement judgement;
  for (const Index node : nodes)
    if (!mesh_.star(node).empty()) judgement.penalty += penalty(node);
  for (const Index e : elements_around(nodes, zone)) {
    const MeshElement& element = mesh_.element(e);
    const int count = corner_count(element);
    if (count == 3) judgement.penalty += 6;
    const double quality = signed_quality(nodes_, element);
    judgement.worst = std::min(judgement.worst, quality);
    double misfit = 0;
    for (int i = 0; i < count; ++i) {
      const double length = distance(nodes_.space(element[i]), nodes_.space(element[(i + 1) % count]));
      if (length < limits_.min_edge) judgement.shortage += 1 - length / limits_.min_edge;
      if (length > 1.8 * limits_.size) judgement.excess += length / limits_.size - 1.8;
      const double stretch = std::log(std::max(length, 1e-9) / limits_.size);
      misfit += stretch * stretch / count;
    }
    judgement.energy += area(nodes_, element) / (limits_.size * limits_.size) *
                        ((1 - quality) * (1 - quality) + size_weight * misfit);
  }
  return judgement;
}

bool MeshEditor::is_better(const Judgement& after, const Judgement& before, EditAim aim) const {
  if (after.worst < wanted_worst(before, aim)) return false;
  if (aim == EditAim::longer_edges) return after.shortage < 0.5 * before.shortage;
  if (after.shortage > before.shortage) return false;
  if (aim == EditAim::fewer_triangles) return true;
  if (after.excess > before.excess + 1e-9) return false;
  if (aim == EditAim::better_shape) return true;
  const double gain = before.penalty - after.penalty;
  return gain >= 0.5 && after.energy <= before.energy + price_of_regularity * gain;
}

/// Cheap moves first; false where they show that the edit leads nowhere, or `is_hopeless` says so after the
/// first round.
bool MeshEditor::smooth_zone(const std::vector<Index>& zone, const std::function<bool()>& is_hopeless) {
  const auto worst = [&] {
    double result = 1;
    for (const Index node : zone) result = std::min(result, motion_.worst_around(node));
    return result;
  };
  for (int round = 0; round < 6 && worst() < 0.05; ++round)
    for (const Index node : zone)
      if (motion_.worst_around(node) < 0.1) motion_.untangle(node);
  for (int round = 0; round < 4; ++round) {
    bool moved = false;
    for (const Index node : zone)
      if (motion_.relax(node)) moved |= motion_.last_step() > 0.03 * limits_.size;
    if (round == 0 && is_hopeless()) return false;
    if (!moved) break;
    if (round == 1 && worst() < 0) return false;
  }
  for (int round = 0; round < 4; ++round) {
    bool moved = false;
    for (const Index node : zone) {
      const double quality = motion_.worst_around(node);
      if (quality > 0.8 && motion_.shortfall(node) <= 0) continue;
      if (motion_.optimise(node, quality < 0.7 ? MotionAim::worst : MotionAim::mean))
        moved |= motion_.last_step() > 0.01 * limits_.size;
    }
    if (!moved) break;
  }
  return true;
}

bool MeshEditor::try_replace(const Replacement& edit, EditAim aim, std::vector<Index>& touched) {
  std::vector<MeshElement> before;
  for (const Index e : edit.removed) before.push_back(mesh_.element(e));
  if (before.empty() || !respects_kept_edges(before, edit.added)) return false;

  std::vector<Index> rim = corners_of(before);
  const Judgement old = judge(rim, zone_around(rim));
  Undo undo;
  apply(edit, undo);
  for (Index node = undo.node_count; node < mesh_.node_count(); ++node) rim.push_back(node);
  if (!is_sound(before, edit.added, rim)) {
    roll_back(undo);
    return false;
  }
  const std::vector<Index> zone = zone_around(rim);
  for (const Index node : zone) undo.places.emplace_back(node, nodes_[node]);
  const auto is_hopeless_now = [&](double share) {
    return aim == EditAim::fewer_irregular && is_hopeless(judge(rim, zone), old, share);
  };
  if (reachable(elements_around(rim, zone)) + corner_room < wanted_worst(old, aim) ||
      is_hopeless_now(hopeless_at_start) ||
      !smooth_zone(zone, [&] { return is_hopeless_now(hopeless_when_relaxed); }) ||
      !is_better(judge(rim, zone), old, aim)) {
    roll_back(undo);
    return false;
  }
  touched.clear();
  for (const Index node : rim)
    if (!mesh_.star(node).empty()) touched.push_back(node);
  return true;
}

std::vector<Index> MeshEditor::write_back(PlanarMesh& mesh) const {
  std::vector<Vec2> places;
  for (Index node = 0; node < mesh_.node_count(); ++node) places.push_back(nodes_.flat(node));
  std::vector<NodeFreedom> freedom = mesh.freedom;
  freedom.resize(mesh_.node_count(), NodeFreedom::free);
  std::vector<Index> number;
  PlanarMesh living = living_part(mesh_, places, freedom, number);
  number.resize(mesh.nodes.size());
  mesh = std::move(living);
  return number;
}

}  // namespace beadmesh
