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
    length_ = length_of(arm);
    const AxisStation first = station_at(arm_, 0, loop_lengths_);
    loops_[0] = first.left.loop;
    loops_[1] = first.right.loop;
  }

  Result<BlockLayout> run() {
    if (loops_[0] == loops_[1])
      return fail("blocking.annular.loops", "both feet of the axis lie on one loop");
    if (!choose_count())
      return fail("blocking.annular.prescribed", "its two loops carry different numbers of nodes");
    place_chords();
    if (!chords_advance()) return fail("blocking.annular.feet", "the touching lines cross");
    for (size_t i = 0; i < chords_.size(); ++i) add_edges(i, (i + 1) % chords_.size());
    for (size_t i = 0; i < chords_.size(); ++i) add_blocks(chords_[i], chords_[(i + 1) % chords_.size()]);
    return builder_.take();
  }

 private:
  const std::vector<double>& prescribed(int side) const { return options_.prescribed[loops_[side]]; }

  bool choose_count() {
    const size_t a = prescribed(0).size(), b = prescribed(1).size();
    if (a && b && a != b) return false;
    around_ = a ? int(a) : b ? int(b) : options_.elements_around;
    return around_ >= 8;
  }

  void place_chords() {
    const int pieces = around_ > 72 ? 6 : around_ > 48 ? 5 : 4;
    const int lead = prescribed(0).empty() ? 1 : 0;
    for (int i = 0; i < pieces; ++i) {
      const int index = int(std::lround(double(around_) * i / pieces));
      indices_.push_back(index);
      if (prescribed(lead).empty())
        add_chord(station_at(arm_, length_ * index / around_, loop_lengths_));
      else
        add_chord(prescribed_station(lead, index));
    }
  }

  /// The touching line through prescribed node `index` of the leading side; node 0 is the one nearest to t =
  /// 0.
  AxisStation prescribed_station(int lead, int index) {
    if (index == 0) {
      const AxisStation zero = station_at(arm_, 0, loop_lengths_);
      shift_[lead] = nearest_node(lead, foot(zero, lead).position);
    }
    const double target = node_position(lead, index);
    AxisStation station = station_with_foot(lead, target);
    const int follower = 1 - lead;
    if (!prescribed(follower).empty()) {
      if (index == 0) shift_[follower] = nearest_node(follower, foot(station, follower).position);
      foot(station, follower).position = node_position(follower, index);
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
    const int samples = 4 * around_;
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
      add_chord_edges(builder_, a, options_.elements_across, false);
    const int last = j == 0 ? around_ : indices_[j];
    const int count = last - indices_[i];
    if (!is_narrow())
      builder_.add_edge(a.middle, b.middle, VirtualEdgeKind::ridge, axis_between(a.along, b.along), count);
    const Index left = builder_.add_boundary_edge(a.left, b.left, true, count);
    const Index right = builder_.add_boundary_edge(a.right, b.right, false, count);
    if (left == no_index || right == no_index) return;
    for (int k = indices_[i] + 1; k < last; ++k) {
      if (!prescribed(0).empty()) builder_.edge(left).prescribed.push_back(node_position(0, k));
      if (!prescribed(1).empty()) builder_.edge(right).prescribed.push_back(node_position(1, k));
    }
  }

  /// One element from loop to loop: no crest.
  bool is_narrow() const { return options_.elements_across == 1; }

  void add_blocks(const Chord& a, const Chord& b) {
    if (is_narrow()) {
      builder_.add_block({{{a.left, a.right}, {a.right, b.right}, {b.right, b.left}, {b.left, a.left}}});
      return;
    }
    builder_.add_block({{{a.left, a.middle}, {a.middle, b.middle}, {b.middle, b.left}, {b.left, a.left}}});
    builder_.add_block(
        {{{a.middle, a.right}, {a.right, b.right}, {b.right, b.middle}, {b.middle, a.middle}}});
  }

  const SkeletonArm& arm_;
  AnnularBlockOptions options_;
  BlockLayoutBuilder builder_;
  std::vector<double> loop_lengths_;
  double length_ = 0;
  Index loops_[2] = {0, 1};
  int around_ = 0;
  int shift_[2] = {0, 0};
  std::vector<int> indices_;
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
