#include "beadmesh/blocking/annular_blocks.h"

#include <algorithm>
#include <cmath>

#include "beadmesh/blocking/axis_station.h"
#include "beadmesh/blocking/chord.h"

namespace beadmesh {
namespace {

double wrapped(double position, double length) {
  const double at = std::fmod(position, length);
  return at < 0 ? at + length : at;
}

class AnnularBlocks {
 public:
  AnnularBlocks(const SkeletonArm& arm, const PlanarRegion& region, const AnnularBlockOptions& options)
      : arm_(arm), options_(options), builder_(region), loop_lengths_(loop_lengths_of(region)) {
    options_.prescribed.resize(2);
    options_.elements_on_loop.resize(2);
    length_ = length_of(arm);
    const AxisStation first = station_at(arm_, 0, loop_lengths_);
    loops_[0] = first.left.loop;
    loops_[1] = first.right.loop;
  }

  Result<BlockLayout> run() {
    if (loops_[0] == loops_[1])
      return fail("blocking.annular.loops", "both feet of the axis lie on one loop");
    if (const auto chosen = choose_counts(); !chosen) return tl::unexpected(chosen.error());
    place_chords();
    if (!chords_advance()) return fail("blocking.annular.feet", "the touching lines cross");
    for (size_t i = 0; i < chords_.size(); ++i) add_edges(i, (i + 1) % chords_.size());
    for (size_t i = 0; i < chords_.size(); ++i) add_blocks(chords_[i], chords_[(i + 1) % chords_.size()]);
    return builder_.take();
  }

 private:
  const std::vector<double>& prescribed(int side) const { return options_.prescribed[loops_[side]]; }

  Result<void> choose_counts() {
    for (int side = 0; side < 2; ++side)
      counts_[side] =
          prescribed(side).empty() ? options_.elements_on_loop[loops_[side]] : int(prescribed(side).size());
    for (int side = 0; side < 2; ++side)
      if (!counts_[side]) counts_[side] = counts_[1 - side];
    counts_[crest] = (counts_[0] + counts_[1] + 2) / 4 * 2;
    if (counts_[0] == counts_[1]) counts_[crest] = counts_[0];
    const auto [fewest, most] = std::minmax(counts_[0], counts_[1]);
    if (fewest < 8 || fewest % 2 || most % 2)
      return fail("blocking.annular.count", "a loop needs an even number of elements, at least 8");
    if (is_narrow() && fewest != most)
      return fail("blocking.annular.prescribed", "its two loops carry different numbers of nodes");
    if (most > 3 * counts_[crest] || counts_[crest] > 3 * fewest)
      return fail("blocking.annular.prescribed", "its two loops carry " + std::to_string(fewest) + " and " +
                                                     std::to_string(most) + " nodes");
    return {};
  }

  /// Cuts at the places where lines with equal shares have their nodes; lines of other counts follow with an
  /// even difference in every sector.
  void place_chords() {
    const int around = counts_[crest];
    const int pieces = around > 72 ? 6 : around > 48 ? 5 : 4;
    const int lead = prescribed(0).empty() ? 1 : 0;
    for (int i = 0; i <= pieces; ++i) {
      const int index = int(std::lround(double(counts_[lead]) * i / pieces));
      for (int line = 0; line < 3; ++line) {
        const double share = double(counts_[line]) * i / pieces;
        indices_[line].push_back(index + 2 * int(std::lround((share - index) / 2)));
      }
    }
    for (int i = 0; i < pieces; ++i)
      if (prescribed(lead).empty())
        add_chord(station_at(arm_, length_ * indices_[lead][i] / counts_[lead], loop_lengths_));
      else
        add_chord(prescribed_station(lead, i));
  }

  /// Touching line i, through a prescribed node of the leading side; node 0 is the one nearest to t = 0.
  AxisStation prescribed_station(int lead, size_t i) {
    if (i == 0) {
      const AxisStation zero = station_at(arm_, 0, loop_lengths_);
      shift_[lead] = nearest_node(lead, foot(zero, lead).position);
    }
    const double target = node_position(lead, indices_[lead][i]);
    AxisStation station = station_with_foot(lead, target);
    const int follower = 1 - lead;
    if (!prescribed(follower).empty()) {
      if (i == 0) shift_[follower] = nearest_node(follower, foot(station, follower).position);
      foot(station, follower).position = node_position(follower, indices_[follower][i]);
    }
    return station;
  }

  static BoundaryPosition& foot(AxisStation& station, int side) {
    return side == 0 ? station.left : station.right;
  }
  static BoundaryPosition foot(const AxisStation& station, int side) {
    return side == 0 ? station.left : station.right;
  }

  int nearest_node(int side, double position) const {
    const auto& nodes = prescribed(side);
    int best = 0;
    for (int i = 1; i < int(nodes.size()); ++i)
      if (std::abs(loop_difference(nodes[i], position, loop_lengths_[loops_[side]])) <
          std::abs(loop_difference(nodes[best], position, loop_lengths_[loops_[side]])))
        best = i;
    return best;
  }

  /// The left boundary is passed backward, the right one forward.
  double node_position(int side, int index) const {
    const auto& nodes = prescribed(side);
    const int n = int(nodes.size());
    const int step = side == 0 ? -index : index;
    return nodes[((shift_[side] + step) % n + n) % n];
  }

  /// Searches the axis for the place whose foot is nearest to the target.
  AxisStation station_with_foot(int side, double target) const {
    const int samples = 4 * counts_[side];
    const double loop_length = loop_lengths_[loops_[side]];
    const auto miss = [&](double along) {
      return std::abs(
          loop_difference(foot(station_at(arm_, along, loop_lengths_), side).position, target, loop_length));
    };
    double best = 0;
    for (int i = 1; i < samples; ++i)
      if (miss(length_ * i / samples) < miss(best)) best = length_ * i / samples;
    for (double step = length_ / samples; step > 1e-6 * length_; step /= 2) {
      if (miss(best + step) < miss(best))
        best += step;
      else if (miss(best - step) < miss(best))
        best -= step;
    }
    AxisStation station = station_at(arm_, wrapped(best, length_), loop_lengths_);
    foot(station, side).position = target;
    return station;
  }

  void add_chord(const AxisStation& station) {
    Chord chord;
    chord.along = station.along;
    chord.middle = builder_.add_vertex(station.centre);
    chord.left = builder_.add_boundary_vertex(station.left);
    chord.right = builder_.add_boundary_vertex(station.right);
    chords_.push_back(chord);
  }

  bool chords_advance() const {
    const auto& vertices = builder_.layout().vertices;
    double left = 0, right = 0;
    for (size_t i = 0; i < chords_.size(); ++i) {
      const Chord &a = chords_[i], &b = chords_[(i + 1) % chords_.size()];
      left += wrapped(vertices[a.left].boundary.position - vertices[b.left].boundary.position,
                      loop_lengths_[loops_[0]]);
      right += wrapped(vertices[b.right].boundary.position - vertices[a.right].boundary.position,
                       loop_lengths_[loops_[1]]);
    }
    return std::abs(left - loop_lengths_[loops_[0]]) < 1e-6 * left &&
           std::abs(right - loop_lengths_[loops_[1]]) < 1e-6 * right;
  }

  std::vector<Vec2> axis_between(double from, double to) const {
    if (to <= from) to += length_;
    const auto at = distances_along(arm_);
    std::vector<Vec2> out;
    const double margin = 1e-6 * length_;
    for (int turn = 0; turn < 2; ++turn)
      for (size_t i = 0; i < at.size(); ++i) {
        const double s = at[i] + turn * length_;
        if (s > from + margin && s < to - margin) out.push_back(arm_.points[i].point);
      }
    return out;
  }

  void add_edges(size_t i, size_t j) {
    Chord &a = chords_[i], &b = chords_[j];
    if (is_narrow())
      builder_.add_edge(a.left, a.right, VirtualEdgeKind::split, {}, 1);
    else
      add_chord_edges(builder_, a, options_.elements_across, 0);
    if (!is_narrow())
      builder_.add_edge(a.middle, b.middle, VirtualEdgeKind::ridge, axis_between(a.along, b.along),
                        indices_[crest][i + 1] - indices_[crest][i]);
    for (int side = 0; side < 2; ++side) {
      const int first = indices_[side][i], last = indices_[side][i + 1];
      const Index edge = side == 0 ? builder_.add_boundary_edge(a.left, b.left, true, last - first)
                                   : builder_.add_boundary_edge(a.right, b.right, false, last - first);
      if (edge == no_index || prescribed(side).empty()) continue;
      for (int k = first + 1; k < last; ++k) builder_.edge(edge).prescribed.push_back(node_position(side, k));
    }
  }

  /// One element from loop to loop: no crest.
  bool is_narrow() const { return options_.elements_across == 1; }

  void add_blocks(const Chord& a, const Chord& b) {
    if (is_narrow()) {
      builder_.add_block({{{a.left, a.right}, {a.right, b.right}, {b.right, b.left}, {b.left, a.left}}});
      return;
    }
    builder_.add_block({{{a.middle, b.middle}, {b.middle, b.left}, {b.left, a.left}, {a.left, a.middle}}},
                       counts_[0] != counts_[crest]);
    builder_.add_block({{{b.middle, a.middle}, {a.middle, a.right}, {a.right, b.right}, {b.right, b.middle}}},
                       counts_[1] != counts_[crest]);
  }

  static constexpr int crest = 2;  ///< the third line, beside the left and the right loop

  const SkeletonArm& arm_;
  AnnularBlockOptions options_;
  BlockLayoutBuilder builder_;
  std::vector<double> loop_lengths_;
  double length_ = 0;
  Index loops_[2] = {0, 1};
  int counts_[3] = {0, 0, 0};    ///< elements on the left loop, the right loop, the crest
  std::vector<int> indices_[3];  ///< of the nodes of each line at the cuts; the last is the first again
  int shift_[2] = {0, 0};
  std::vector<Chord> chords_;
};

}  // namespace

Result<BlockLayout> blocks_of_annular_bead(const Skeleton& skeleton, const PlanarRegion& region,
                                           const AnnularBlockOptions& options) {
  if (skeleton.arms.size() != 1 || skeleton.arms[0].start != no_index || region.loops.size() != 2)
    return fail("blocking.annular.axis", "its axis is not one closed edge between two loops");
  return AnnularBlocks(skeleton.arms[0], region, options).run();
}

}  // namespace beadmesh
