#include "beadmesh/mesh/local_edits.h"

#include <algorithm>
#include <optional>

namespace beadmesh {
namespace {

struct Candidate {
  double gain;
  Replacement edit;
};

/// Collects edits with what the penalties around them would gain.
class Candidates {
 public:
  explicit Candidates(const MeshEditor& editor) : editor_(editor) {}

  void add(Replacement edit) {
    const double gain = gain_of(edit);
    if (gain >= least_gain) list_.push_back({gain, std::move(edit)});
  }
  /// Best first; equal ones in the order they were found.
  std::vector<Candidate> sorted() {
    std::stable_sort(list_.begin(), list_.end(),
                     [](const auto& a, const auto& b) { return a.gain > b.gain; });
    return std::move(list_);
  }
  double least_gain = 0.5;

 private:
  double gain_of(const Replacement& edit) const {
    std::vector<std::pair<Index, int>> change;
    const auto count = [&](const MeshElement& element, int step) {
      for (int i = 0; i < corner_count(element); ++i) change.emplace_back(element[i], step);
    };
    for (const Index e : edit.removed) count(editor_.mesh().element(e), -1);
    for (const MeshElement& element : edit.added) count(element, 1);
    std::sort(change.begin(), change.end());
    double gain = 0;
    for (size_t begin = 0, end = 0; begin < change.size(); begin = end) {
      int sum = 0;
      for (; end < change.size() && change[end].first == change[begin].first; ++end)
        sum += change[end].second;
      const Index node = change[begin].first;
      if (node >= editor_.mesh().node_count()) {
        gain -= (sum - 4) * (sum - 4);
        continue;
      }
      const int valence = editor_.mesh().valence(node);
      gain += editor_.penalty(node, valence) - (valence + sum > 0 ? editor_.penalty(node, valence + sum) : 0);
    }
    return gain;
  }

  const MeshEditor& editor_;
  std::vector<Candidate> list_;
};

MeshElement with_corner(MeshElement element, Index from, Index to) {
  for (Index& corner : element)
    if (corner == from) corner = to;
  return element;
}

/// The quad's corner `gone` merged into the opposite one.
std::optional<Replacement> collapse(const MeshEditor& editor, Index quad, Index gone) {
  const QuadConnectivity& mesh = editor.mesh();
  const MeshElement& corners = mesh.element(quad);
  if (!is_quad(corners) || !editor.is_free(gone) || editor.is_boundary(gone)) return std::nullopt;
  const Index stays = corners[(corner_of(corners, gone) + 2) % 4];
  Replacement edit;
  for (const Index e : mesh.star(gone)) {
    edit.removed.push_back(e);
    if (e == quad) continue;
    const MeshElement& element = mesh.element(e);
    if (std::find(element.begin(), element.end(), stays) != element.end()) return std::nullopt;
    edit.added.push_back(with_corner(element, gone, stays));
  }
  if (editor.is_free(stays))
    edit.moved.emplace_back(stays, (editor.nodes().flat(gone) + editor.nodes().flat(stays)) / 2);
  return edit;
}

/// The edge u-w between two quads exchanged for one of the other two diagonals of their hexagon.
std::optional<Replacement> rotate(const MeshEditor& editor, Index u, Index w, bool clockwise) {
  const QuadConnectivity& mesh = editor.mesh();
  const Index left = mesh.element_with_edge(u, w), right = mesh.element_with_edge(w, u);
  if (left == no_index || right == no_index || editor.is_kept_edge(u, w)) return std::nullopt;
  const MeshElement &a = mesh.element(left), &b = mesh.element(right);
  if (!is_quad(a) || !is_quad(b)) return std::nullopt;
  const Index x = a[(corner_of(a, w) + 1) % 4], y = a[(corner_of(a, w) + 2) % 4];
  const Index p = b[(corner_of(b, u) + 1) % 4], q = b[(corner_of(b, u) + 2) % 4];
  Replacement edit;
  edit.removed = {left, right};
  if (clockwise)
    edit.added = {{x, y, u, p}, {p, q, w, x}};
  else
    edit.added = {{y, u, p, q}, {q, w, x, y}};
  return edit;
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
Replacement split(const MeshEditor& editor, Index node, const std::vector<Index>& ring, size_t first,
                  size_t count) {
  const QuadConnectivity& mesh = editor.mesh();
  const Index fresh = mesh.node_count();
  Replacement edit;
  Vec2 ahead, behind;
  for (size_t i = 0; i < ring.size(); ++i) {
    const Index e = ring[(first + i) % ring.size()];
    const auto [next, previous] = corner_neighbours(mesh.element(e), node);
    const Vec2 middle = (editor.nodes().flat(next) + editor.nodes().flat(previous)) / 2;
    (i < count ? ahead : behind) += middle / static_cast<double>(i < count ? count : ring.size() - count);
    if (i >= count) continue;
    edit.removed.push_back(e);
    edit.added.push_back(with_corner(mesh.element(e), node, fresh));
  }
  const Index from = corner_neighbours(mesh.element(edit.removed.front()), node).first;
  const Index to = corner_neighbours(mesh.element(edit.removed.back()), node).second;
  edit.added.push_back({node, from, fresh, to});
  const Vec2 centre = editor.nodes().flat(node);
  edit.new_nodes.push_back(lerp(centre, ahead, 0.4));
  edit.moved.emplace_back(node, lerp(centre, behind, 0.4));
  return edit;
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
    candidates.add(
        {removed,
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
    for (const Index corner : element)
      if (const auto edit = collapse(editor, e, corner)) candidates.add(*edit);
    const Index next = corner_neighbours(element, node).first;
    for (const bool clockwise : {false, true}) {
      if (const auto edit = rotate(editor, node, next, clockwise)) candidates.add(*edit);
      // Sides of the quad away from the node: rotating them brings an edge to the node.
      const Index opposite = element[(corner_of(element, node) + 2) % 4];
      if (const auto edit = rotate(editor, next, opposite, clockwise)) candidates.add(*edit);
      const Index previous = corner_neighbours(element, node).second;
      if (const auto edit = rotate(editor, opposite, previous, clockwise)) candidates.add(*edit);
    }
  }
}

void add_splits(const MeshEditor& editor, Index node, Candidates& candidates) {
  if (editor.is_boundary(node) || !editor.is_free(node) || editor.mesh().valence(node) < 5) return;
  const std::vector<Index> ring = ordered_star(editor.mesh(), node);
  if (ring.size() != editor.mesh().star(node).size()) return;
  for (size_t count = 2; 2 * count <= ring.size(); ++count)
    for (size_t first = 0; first < ring.size(); ++first)
      candidates.add(split(editor, node, ring, first, count));
}

bool try_best(MeshEditor& editor, Candidates& candidates, EditAim aim, size_t attempts,
              std::vector<Index>& touched) {
  const std::vector<Candidate> list = candidates.sorted();
  for (size_t i = 0; i < std::min(attempts, list.size()); ++i)
    if (editor.try_replace(list[i].edit, aim, touched)) return true;
  return false;
}

bool repair_edge(MeshEditor& editor, Index a, Index b, std::vector<Index>& touched) {
  Candidates candidates(editor);
  candidates.least_gain = -30;
  for (const Index node : {a, b}) {
    add_collapses_and_rotations(editor, node, candidates);
    add_splits(editor, node, candidates);
  }
  return try_best(editor, candidates, EditAim::longer_edges, 40, touched);
}

}  // namespace

bool improve_locally(MeshEditor& editor, Index node, std::vector<Index>& touched) {
  if (!editor.is_irregular(node)) return false;
  Candidates candidates(editor);
  add_collapses_and_rotations(editor, node, candidates);
  for (const Index other : editor.mesh().neighbours(node))
    add_side_collapses(editor, node, other, candidates);
  add_splits(editor, node, candidates);
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

int remove_short_edges(MeshEditor& editor) {
  int edits = 0;
  std::vector<Index> touched;
  for (int round = 0; round < 5; ++round) {
    const int before = edits;
    for (Index node = 0; node < editor.mesh().node_count(); ++node)
      for (const Index other : editor.mesh().neighbours(node)) {
        if (other < node) continue;
        const double length = distance(editor.nodes().space(node), editor.nodes().space(other));
        if (length >= editor.limits().min_edge) continue;
        if (!editor.is_free(node) && !editor.is_free(other)) continue;
        if (!repair_edge(editor, node, other, touched)) continue;
        ++edits;
        break;
      }
    if (edits == before) break;
  }
  return edits;
}

}  // namespace beadmesh
