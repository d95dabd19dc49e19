#include "beadmesh/mesh/patch_replacement.h"

#include <algorithm>
#include <cstdlib>

#include "beadmesh/mesh/patch_fill.h"

namespace beadmesh {
namespace {

/// A disc of quads that grows; its outline, and how many of its quads each outline node has.
class Patch {
 public:
  /// `marks` per element: those with `number` are in the patch.
  Patch(const MeshEditor& editor, size_t max_quads, std::vector<int>& marks, int number)
      : editor_(editor), mesh_(editor.mesh()), max_quads_(max_quads), marks_(marks), number_(number) {}

  const std::vector<Index>& quads() const { return quads_; }
  const std::vector<Index>& loop() const { return loop_; }
  int inside_count(Index node) const {
    int count = 0;
    for (const Index e : mesh_.star(node)) count += contains(e);
    return count;
  }
  std::vector<Index> inner_nodes() const {
    std::vector<Index> nodes;
    for (const Index e : quads_)
      for (const Index node : mesh_.element(e))
        if (!std::binary_search(sorted_loop_.begin(), sorted_loop_.end(), node)) nodes.push_back(node);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }

  /// Adds all quads around the node, then closes inward corners. False where that is no patch any more.
  bool start(Index seed) { return add_all(mesh_.star(seed)) && close(); }
  /// Adds a ring of quads; false also where there is none left.
  bool grow_ring() {
    const size_t before = quads_.size();
    std::vector<Index> ring;
    for (const Index node : loop_)
      for (const Index e : mesh_.star(node)) ring.push_back(e);
    return add_all(ring) && quads_.size() > before && close();
  }

 private:
  bool contains(Index quad) const { return marks_[quad] == number_; }

  bool add_all(const std::vector<Index>& quads) {
    for (const Index e : quads) {
      if (!is_quad(mesh_.element(e))) return false;
      if (contains(e)) continue;
      marks_[e] = number_;
      quads_.push_back(e);
    }
    return quads_.size() <= max_quads_;
  }

  /// Adds the last quad outside at outline nodes until none is left.
  bool close() {
    while (true) {
      if (!trace()) return false;
      std::vector<Index> missing;
      for (const Index node : loop_) {
        const int inside = inside_count(node), outside = mesh_.valence(node) - inside;
        if (outside != 1 || (editor_.is_boundary(node) && inside < 3)) continue;
        for (const Index e : mesh_.star(node))
          if (!contains(e)) missing.push_back(e);
      }
      if (missing.empty()) return inside_is_free();
      if (!add_all(missing)) return false;
    }
  }

  /// The outline as one counter-clockwise loop that meets no node twice.
  bool trace() {
    std::vector<std::pair<Index, Index>> outline;
    for (const Index e : quads_) {
      const MeshElement& quad = mesh_.element(e);
      for (int i = 0; i < 4; ++i) {
        const Index a = quad[i], b = quad[(i + 1) % 4], across = mesh_.element_with_edge(b, a);
        if (across == no_index || !contains(across)) outline.emplace_back(a, b);
      }
    }
    std::sort(outline.begin(), outline.end());
    for (size_t i = 1; i < outline.size(); ++i)
      if (outline[i].first == outline[i - 1].first) return false;
    loop_.clear();
    Index node = outline.front().first;
    do {
      loop_.push_back(node);
      const auto at = std::lower_bound(outline.begin(), outline.end(), std::pair{node, no_index});
      if (at == outline.end() || at->first != node) return false;
      node = at->second;
    } while (node != loop_.front() && loop_.size() <= outline.size());
    sorted_loop_ = loop_;
    std::sort(sorted_loop_.begin(), sorted_loop_.end());
    return loop_.size() == outline.size();
  }

  bool inside_is_free() const {
    for (const Index node : inner_nodes())
      if (!editor_.is_free(node) || editor_.is_boundary(node)) return false;
    return true;
  }

  const MeshEditor& editor_;
  const QuadConnectivity& mesh_;
  size_t max_quads_;
  std::vector<int>& marks_;
  int number_;
  std::vector<Index> quads_, loop_, sorted_loop_;
};

struct CornerChoice {
  double penalty;
  std::vector<int> corners;
};

/// Where the outline's corners may be: what each node costs as a corner (one quad inside) or on a side (two).
class CornerSearch {
 public:
  CornerSearch(const MeshEditor& editor, const Patch& patch) : size_(static_cast<int>(patch.loop().size())) {
    for (const Index node : patch.loop()) {
      const int outside = editor.mesh().valence(node) - patch.inside_count(node);
      const double side = editor.penalty(node, outside + 2);
      flat_ += side;
      change_.push_back(editor.penalty(node, outside + 1) - side);
    }
  }

  /// The two best fillable choices with a penalty below `limit`, best first: natural corners, up to two
  /// changes to them.
  std::vector<CornerChoice> run(double limit) {
    limit_ = limit;
    std::vector<int> natural;
    for (int i = 0; i < size_; ++i)
      if (change_[i] < 0) natural.push_back(i);
    if (natural.size() < 2 || natural.size() > 7) return {};
    vary(natural, 2);
    return std::move(found_);
  }

 private:
  double penalty_of(const std::vector<int>& corners) const {
    double penalty = flat_ + (corners.size() == 4 ? 0 : 1);
    for (const int corner : corners) penalty += change_[corner];
    return penalty;
  }

  void vary(const std::vector<int>& corners, int changes) {
    consider(corners);
    if (changes == 0) return;
    const bool local = changes == 1;
    for (size_t i = 0; i < corners.size(); ++i) {
      std::vector<int> fewer = corners;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
      if (!local) vary(fewer, 0);
      // Another node instead: any on the first change, near ones on the second.
      for (int other = 0; other < size_; ++other) {
        const int gap = std::abs(other - corners[i]), shift = std::min(gap, size_ - gap);
        if (shift <= 4) vary_with(fewer, other, changes - 1);
      }
    }
    if (!local && corners.size() < 5)
      for (int other = 0; other < size_; ++other) vary_with(corners, other, 0);
  }

  void vary_with(std::vector<int> corners, int added, int changes) {
    const auto at = std::lower_bound(corners.begin(), corners.end(), added);
    if (at != corners.end() && *at == added) return;
    corners.insert(at, added);
    if (penalty_of(corners) < limit_) vary(corners, changes);
  }

  void consider(const std::vector<int>& corners) {
    if (corners.size() < 3 || corners.size() > 5) return;
    const double penalty = penalty_of(corners);
    if (penalty >= limit_) return;
    std::array<int, 5> sides;
    for (size_t i = 0; i < corners.size(); ++i)
      sides[i] = i + 1 < corners.size() ? corners[i + 1] - corners[i] : corners[0] - corners[i] + size_;
    if (!patch_divisions({sides.data(), corners.size()})) return;
    if (found_.size() == 1 && found_[0].corners == corners) return;
    found_.push_back({penalty, corners});
    std::stable_sort(found_.begin(), found_.end(),
                     [](const auto& a, const auto& b) { return a.penalty < b.penalty; });
    if (found_.size() < 3) return;
    found_.pop_back();
    limit_ = found_.back().penalty;
  }

  int size_;
  double flat_ = 0, limit_ = 0;
  std::vector<double> change_;
  std::vector<CornerChoice> found_;
};

/// What a replacement is known by: its quads, then the nodes at the new corners. Numbers of elements are not
/// used again.
std::vector<Index> signature(const Patch& patch, const std::vector<int>& corners) {
  std::vector<Index> key = patch.quads();
  std::sort(key.begin(), key.end());
  key.push_back(no_index);
  for (const int corner : corners) key.push_back(patch.loop()[corner]);
  std::sort(key.end() - static_cast<std::ptrdiff_t>(corners.size()), key.end());
  return key;
}

/// Larger patches are grown from the seeds of smaller ones: what was tried in vain before is not tried again.
bool fill_anew(MeshEditor& editor, const Patch& patch, EditAim aim, std::set<std::vector<Index>>& failed,
               std::vector<Index>& touched) {
  double penalty = 0;
  for (const Index node : patch.inner_nodes()) penalty += editor.penalty(node);
  for (const Index node : patch.loop()) penalty += editor.penalty(node);
  const bool for_shape = aim == EditAim::better_shape;
  if (penalty < 1.5 && !for_shape) return false;
  const std::vector<CornerChoice> choices =
      CornerSearch(editor, patch).run(for_shape ? penalty + 4 : penalty - 0.5);
  std::vector<Vec2> positions;
  for (const Index node : patch.loop()) positions.push_back(editor.nodes().flat(node));
  for (const CornerChoice& choice : choices) {
    if (!failed.insert(signature(patch, choice.corners)).second) continue;
    PatchFill fill = fill_patch(patch.loop(), positions, choice.corners, editor.mesh().node_count());
    Replacement edit{patch.quads(), std::move(fill.new_nodes), std::move(fill.quads), {}};
    if (editor.try_replace(edit, aim, touched)) return true;
  }
  return false;
}

}  // namespace

bool PatchReplacement::improve(Index seed, int max_quads, std::vector<Index>& touched) {
  return editor_.is_irregular(seed) && grow_and_fill(seed, max_quads, EditAim::fewer_irregular, touched);
}

bool PatchReplacement::improve_shape(Index seed, int max_quads, std::vector<Index>& touched) {
  return grow_and_fill(seed, max_quads, EditAim::better_shape, touched);
}

bool PatchReplacement::grow_and_fill(Index seed, int max_quads, EditAim aim, std::vector<Index>& touched) {
  marks_.resize(editor_.mesh().element_count(), 0);
  Patch patch(editor_, max_quads, marks_, ++patches_);
  if (!patch.start(seed)) return false;
  do {
    if (fill_anew(editor_, patch, aim, failed_, touched)) return true;
  } while (patch.grow_ring());
  return false;
}

}  // namespace beadmesh
