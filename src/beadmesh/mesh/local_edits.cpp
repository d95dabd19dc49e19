#include "beadmesh/mesh/local_edits.h"

#include <algorithm>
#include <initializer_list>
#include <span>

namespace beadmesh {
namespace {

struct Candidate {
  double gain;
  Replacement edit;
};

/// Collects edits with what the penalties around them would gain. The gain is asked before an edit is put
/// together.
class Candidates {
 public:
  Candidates(const MeshEditor& editor, double least_gain) : editor_(editor), least_gain_(least_gain) {}

  /// What the penalty falls by where nodes get so many elements more or less.
  double gain(std::initializer_list<std::pair<Index, int>> changes) const {
    double sum = 0;
    for (const auto& [node, change] : changes) {
      const int valence = editor_.mesh().valence(node);
      sum += editor_.penalty(node, valence) - editor_.penalty(node, valence + change);
    }
    return sum;
  }
  bool is_welcome(double gain) const { return gain >= least_gain_; }
  void add(double gain, Replacement edit) { list_.push_back({gain, std::move(edit)}); }
  /// Best first; equal ones in the order they were found.
  std::vector<Candidate> sorted() {
    std::stable_sort(list_.begin(), list_.end(),
                     [](const auto& a, const auto& b) { return a.gain > b.gain; });
    return std::move(list_);
  }

 private:
  const MeshEditor& editor_;
  double least_gain_;
  std::vector<Candidate> list_;
};

MeshElement with_corner(MeshElement element, Index from, Index to) {
  for (Index& corner : element)
    if (corner == from) corner = to;
  return element;
}

/// The quad's corner `gone` merged into the opposite one.
void add_collapse(const MeshEditor& editor, Index quad, Index gone, Candidates& candidates) {
  const QuadConnectivity& mesh = editor.mesh();
  const MeshElement& corners = mesh.element(quad);
  if (!editor.is_free(gone) || editor.is_boundary(gone)) return;
  const int at = corner_of(corners, gone);
  const Index stays = corners[(at + 2) % 4];
  const double gain = editor.penalty(gone) + candidates.gain({{stays, mesh.valence(gone) - 2},
                                                              {corners[(at + 1) % 4], -1},
                                                              {corners[(at + 3) % 4], -1}});
  if (!candidates.is_welcome(gain)) return;
  Replacement edit;
  for (const Index e : mesh.star(gone)) {
    edit.removed.push_back(e);
    if (e == quad) continue;
    const MeshElement& element = mesh.element(e);
    if (std::find(element.begin(), element.end(), stays) != element.end()) return;
    edit.added.push_back(with_corner(element, gone, stays));
  }
  if (editor.is_free(stays))
    edit.moved.emplace_back(stays, (editor.nodes().flat(gone) + editor.nodes().flat(stays)) / 2);
  candidates.add(gain, std::move(edit));
}

/// The edge u-w between two quads exchanged for one of the other two diagonals of their hexagon.
void add_rotations(const MeshEditor& editor, Index u, Index w, Candidates& candidates) {
  const QuadConnectivity& mesh = editor.mesh();
  const Index left = mesh.element_with_edge(u, w), right = mesh.element_with_edge(w, u);
  if (left == no_index || right == no_index || editor.is_kept_edge(u, w)) return;
  const MeshElement &a = mesh.element(left), &b = mesh.element(right);
  if (!is_quad(a) || !is_quad(b)) return;
  const Index x = a[(corner_of(a, w) + 1) % 4], y = a[(corner_of(a, w) + 2) % 4];
  const Index p = b[(corner_of(b, u) + 1) % 4], q = b[(corner_of(b, u) + 2) % 4];
  const double to_xp = candidates.gain({{u, -1}, {w, -1}, {x, 1}, {p, 1}});
  const double to_yq = candidates.gain({{u, -1}, {w, -1}, {y, 1}, {q, 1}});
  if (candidates.is_welcome(to_xp))
    candidates.add(to_xp, {{left, right}, {}, {{x, y, u, p}, {p, q, w, x}}, {}});
  if (candidates.is_welcome(to_yq))
    candidates.add(to_yq, {{left, right}, {}, {{y, u, p, q}, {q, w, x, y}}, {}});
}

/// Elements around an inner node in turn, counter-clockwise, from the one that has the edge node -> first.
std::vector<Index> ordered_star(const QuadConnectivity& mesh, Index node) {
  std::vector<Index> ring;
  Index e = mesh.star(node).front();
  do {
    ring.push_back(e);
    e = mesh.element_with_edge(node, corner_neighbours(mesh.element(e), node).second);
  } while (e != no_index && e != ring.front() && ring.size() <= mesh.star(node).size());
  return ring;
}

/// The elements first .. first + count - 1 of the node's ring get a node of their own; a quad opens in
/// between.
void add_split(const MeshEditor& editor, Index node, const std::vector<Index>& ring, size_t first,
               size_t count, Candidates& candidates) {
  const QuadConnectivity& mesh = editor.mesh();
  const auto sector = [&](size_t i) { return mesh.element(ring[(first + i) % ring.size()]); };
  const Index from = corner_neighbours(sector(0), node).first;
  const Index to = corner_neighbours(sector(count - 1), node).second;
  const int fresh_valence = static_cast<int>(count) + 1;
  const double gain = candidates.gain({{node, 1 - static_cast<int>(count)}, {from, 1}, {to, 1}}) -
                      (fresh_valence - 4) * (fresh_valence - 4);
  if (!candidates.is_welcome(gain)) return;
  const Index fresh = mesh.node_count();
  Replacement edit;
  Vec2 ahead, behind;
  for (size_t i = 0; i < ring.size(); ++i) {
    const auto [next, previous] = corner_neighbours(sector(i), node);
    const Vec2 middle = (editor.nodes().flat(next) + editor.nodes().flat(previous)) / 2;
    (i < count ? ahead : behind) += middle / static_cast<double>(i < count ? count : ring.size() - count);
    if (i >= count) continue;
    edit.removed.push_back(ring[(first + i) % ring.size()]);
    edit.added.push_back(with_corner(sector(i), node, fresh));
  }
  edit.added.push_back({node, from, fresh, to});
  const Vec2 centre = editor.nodes().flat(node);
  edit.new_nodes.push_back(lerp(centre, ahead, 0.4));
  edit.moved.emplace_back(node, lerp(centre, behind, 0.4));
  candidates.add(gain, std::move(edit));
}

/// Two adjacent inner nodes of valence three: the hexagon around their four quads with two quads instead.
void add_side_collapses(const MeshEditor& editor, Index a, Index b, Candidates& candidates) {
  const QuadConnectivity& mesh = editor.mesh();
  const auto is_three = [&](Index node) {
    return mesh.valence(node) == 3 && !editor.is_boundary(node) && editor.is_free(node);
  };
  if (!is_three(a) || !is_three(b)) return;
  std::vector<Index> removed = mesh.star(a);
  for (const Index e : mesh.star(b))
    if (std::find(removed.begin(), removed.end(), e) == removed.end()) removed.push_back(e);
  if (removed.size() != 4) return;
  std::vector<std::pair<Index, Index>> next;
  for (const Index e : removed) {
    const MeshElement& element = mesh.element(e);
    if (!is_quad(element)) return;
    for (int i = 0; i < 4; ++i) {
      const Index from = element[i], to = element[(i + 1) % 4];
      if (from != a && from != b && to != a && to != b) next.emplace_back(from, to);
    }
  }
  if (next.size() != 6) return;
  std::array<Index, 6> hexagon = {next[0].first};
  for (int i = 1; i < 6; ++i) {
    const auto at = std::find_if(next.begin(), next.end(),
                                 [&](const auto& edge) { return edge.first == hexagon[i - 1]; });
    if (at == next.end()) return;
    hexagon[i] = at->second;
  }
  for (int i = 0; i < 3; ++i) {
    const auto corner = [&](int k) { return hexagon[(i + k) % 6]; };
    double gain = editor.penalty(a) + editor.penalty(b);
    for (int k = 0; k < 6; ++k) {
      const auto has_corner = [&](Index e) {
        return mesh.element(e)[corner_of(mesh.element(e), corner(k))] == corner(k);
      };
      const int before = static_cast<int>(std::count_if(removed.begin(), removed.end(), has_corner));
      gain += candidates.gain({{corner(k), (k % 3 == 0 ? 2 : 1) - before}});
    }
    if (!candidates.is_welcome(gain)) continue;
    candidates.add(
        gain, {removed,
               {},
               {{corner(0), corner(1), corner(2), corner(3)}, {corner(3), corner(4), corner(5), corner(0)}},
               {}});
  }
}

void add_collapses_and_rotations(const MeshEditor& editor, Index node, Candidates& candidates) {
  const QuadConnectivity& mesh = editor.mesh();
  for (const Index e : mesh.star(node)) {
    const MeshElement& element = mesh.element(e);
    if (!is_quad(element)) continue;
    for (const Index corner : element) add_collapse(editor, e, corner, candidates);
    const auto [next, previous] = corner_neighbours(element, node);
    const Index opposite = element[(corner_of(element, node) + 2) % 4];
    add_rotations(editor, node, next, candidates);
    // Sides of the quad away from the node: rotating them brings an edge to the node.
    add_rotations(editor, next, opposite, candidates);
    add_rotations(editor, opposite, previous, candidates);
  }
}

void add_splits(const MeshEditor& editor, Index node, Candidates& candidates, int least_valence) {
  if (editor.is_boundary(node) || !editor.is_free(node) || editor.mesh().valence(node) < least_valence)
    return;
  const std::vector<Index> ring = ordered_star(editor.mesh(), node);
  if (ring.size() != editor.mesh().star(node).size()) return;
  for (size_t count = 2; count + 2 <= ring.size() && 2 * count <= ring.size(); ++count)
    for (size_t first = 0; first < ring.size(); ++first)
      add_split(editor, node, ring, first, count, candidates);
}

bool try_best(MeshEditor& editor, Candidates& candidates, EditAim aim, size_t attempts,
              std::vector<Index>& touched) {
  const std::vector<Candidate> list = candidates.sorted();
  for (size_t i = 0; i < std::min(attempts, list.size()); ++i)
    if (editor.try_replace(list[i].edit, aim, touched)) return true;
  return false;
}

/// Edits at any of the nodes, whatever they cost in regularity up to a bound, in the order of that cost.
bool try_edits_at(MeshEditor& editor, std::span<const Index> nodes, EditAim aim, double least_gain,
                  size_t attempts, std::vector<Index>& touched) {
  Candidates candidates(editor, least_gain);
  for (const Index node : nodes) {
    add_collapses_and_rotations(editor, node, candidates);
    add_splits(editor, node, candidates, 3);
  }
  return try_best(editor, candidates, aim, attempts, touched);
}

}  // namespace

bool improve_locally(MeshEditor& editor, Index node, std::vector<Index>& touched) {
  if (!editor.is_irregular(node)) return false;
  Candidates candidates(editor, 0.5);
  add_collapses_and_rotations(editor, node, candidates);
  for (const Index other : editor.mesh().neighbours(node))
    add_side_collapses(editor, node, other, candidates);
  add_splits(editor, node, candidates, 5);
  return try_best(editor, candidates, EditAim::fewer_irregular, 3, touched);
}

int remove_doublets(MeshEditor& editor) {
  int edits = 0;
  std::vector<Index> touched;
  for (Index node = 0; node < editor.mesh().node_count(); ++node) {
    const QuadConnectivity& mesh = editor.mesh();
    if (mesh.valence(node) != 2 || editor.is_boundary(node) || !editor.is_free(node)) continue;
    const MeshElement &a = mesh.element(mesh.star(node)[0]), &b = mesh.element(mesh.star(node)[1]);
    if (!is_quad(a) || !is_quad(b)) continue;
    const int i = corner_of(a, node);
    const Index far = b[(corner_of(b, node) + 2) % 4];
    const MeshElement merged = {a[(i + 1) % 4], a[(i + 2) % 4], a[(i + 3) % 4], far};
    if (far == merged[1]) continue;
    if (editor.try_replace({mesh.star(node), {}, {merged}, {}}, EditAim::fewer_irregular, touched)) ++edits;
  }
  return edits;
}

namespace {

struct ShortEdge {
  double length;
  Index a, b;
  friend auto operator<=>(const ShortEdge&, const ShortEdge&) = default;
};

/// Edges below the minimum with an end that can move, shortest first; not more than a small share of the
/// mesh.
std::vector<ShortEdge> short_edges(const MeshEditor& editor) {
  std::vector<ShortEdge> edges;
  const Index count = editor.mesh().node_count();
  for (Index a = 0; a < count; ++a)
    for (const Index b : editor.mesh().neighbours(a)) {
      if (b < a || (!editor.is_free(a) && !editor.is_free(b))) continue;
      const double length = distance(editor.nodes().space(a), editor.nodes().space(b));
      if (length < editor.limits().min_edge) edges.push_back({length, a, b});
    }
  std::sort(edges.begin(), edges.end());
  edges.resize(std::min<size_t>(edges.size(), static_cast<size_t>(50 + count / 50)));
  return edges;
}

}  // namespace

int remove_short_edges(MeshEditor& editor) {
  int edits = 0;
  std::vector<Index> touched;
  for (int round = 0; round < 5; ++round) {
    const int before = edits;
    for (const ShortEdge& edge : short_edges(editor)) {
      // An edit before may have taken an end away or lengthened the edge.
      if (editor.mesh().star(edge.a).empty() || editor.mesh().star(edge.b).empty()) continue;
      if (distance(editor.nodes().space(edge.a), editor.nodes().space(edge.b)) >= editor.limits().min_edge)
        continue;
      const std::array<Index, 2> ends = {edge.a, edge.b};
      if (try_edits_at(editor, ends, EditAim::longer_edges, -30, 20, touched)) ++edits;
    }
    if (edits == before) break;
  }
  return edits;
}

std::vector<Index> poor_elements(const MeshEditor& editor, double wanted) {
  std::vector<std::pair<double, Index>> poor;
  Index alive = 0;
  for (Index e = 0; e < editor.mesh().element_count(); ++e) {
    if (!editor.mesh().is_alive(e)) continue;
    ++alive;
    const double quality = signed_quality(editor.nodes(), editor.mesh().element(e));
    if (quality < wanted) poor.emplace_back(quality, e);
  }
  std::sort(poor.begin(), poor.end());
  // A mesh that is poor all over is not repaired element by element.
  poor.resize(std::min<size_t>(poor.size(), static_cast<size_t>(50 + alive / 50)));
  std::vector<Index> elements;
  for (const auto& [quality, e] : poor) elements.push_back(e);
  return elements;
}

int improve_shapes(MeshEditor& editor, double wanted) {
  int edits = 0;
  std::vector<Index> touched;
  for (const Index e : poor_elements(editor, wanted)) {
    if (!editor.mesh().is_alive(e)) continue;
    const MeshElement corners = editor.mesh().element(e);
    const std::span<const Index> nodes(corners.data(), static_cast<size_t>(corner_count(corners)));
    if (try_edits_at(editor, nodes, EditAim::better_shape, -8, 20, touched)) ++edits;
  }
  return edits;
}

}  // namespace beadmesh
