#include "beadmesh/blocking/chord.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

/// Element length in a clamp, as a share of the size: ends curve the most.
constexpr double cap_scale = 0.75;

double boundary_distance(const BlockLayoutBuilder& builder, double from, double to, Index loop) {
  const double length = builder.loop_length(loop);
  double d = std::fmod(from - to, length);  // backward
  return d < 0 ? d + length : d;
}

Vec2 point_along(const std::vector<Vec2>& line, double share) {
  double length = 0;
  for (size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  double left = share * length;
  for (size_t i = 1; i < line.size(); ++i) {
    const double step = distance(line[i - 1], line[i]);
    if (left <= step && step > 0) return lerp(line[i - 1], line[i], left / step);
    left -= step;
  }
  return line.back();
}

/// The part of a polyline on one side of a share of its length, end points left out.
std::vector<Vec2> inner_part(const std::vector<Vec2>& line, double from_share, double to_share) {
  double length = 0;
  for (size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  std::vector<Vec2> out;
  double at = 0;
  for (size_t i = 1; i + 1 < line.size(); ++i) {
    at += distance(line[i - 1], line[i]);
    if (at > from_share * length * (1 + 1e-9) && at < to_share * length * (1 - 1e-9)) out.push_back(line[i]);
  }
  return out;
}

class CapBuilder {
 public:
  CapBuilder(BlockLayoutBuilder& builder, const Chord& chord, Index tip, const std::vector<Vec2>& crest,
             const CapOptions& options)
      : builder_(builder),
        chord_(chord),
        tip_(tip),
        options_(options),
        half_core_(std::max(0, options.elements_across / 2 - options.bands)) {
    crest_.push_back(builder.point_of(chord.middle));
    crest_.insert(crest_.end(), crest.begin(), crest.end());
    crest_.push_back(builder.point_of(tip));
    const auto& vertices = builder.layout().vertices;
    loop_ = vertices[chord.left].boundary.loop;
    left_at_ = vertices[chord.left].boundary.position;
    tip_at_ = vertices[tip].boundary.position;
    left_arc_ = boundary_distance(builder, left_at_, tip_at_, loop_);
    right_arc_ = boundary_distance(builder, tip_at_, vertices[chord.right].boundary.position, loop_);
    if (half_core_ == 0) {
      left_tip_arc_ = tip_arc(+1, left_arc_);
      right_tip_arc_ = tip_arc(-1, right_arc_);
    }
    rows_ = options.rows ? options.rows : std::max(1, best_rows() + options.extra_rows);
  }

  /// Rows along the cap: elements near the size both round the arc and along the crest; none under the
  /// minimum where that is possible.
  int best_rows() const {
    double crest = 0;
    for (size_t i = 1; i < crest_.size(); ++i) crest += distance(crest_[i - 1], crest_[i]);
    const double arcs = left_arc_ + right_arc_ - left_tip_arc_ - right_tip_arc_,
                 size = cap_scale * options_.size;
    const int end_rows = half_core_ == 0 ? 0 : options_.bands;  // the tip's own
    int best = 1;
    double best_misfit = 1e300;
    for (int p = 1; p <= 40; ++p) {
      const double round = arcs / (2 * (p + half_core_)), along = crest / (p + end_rows);
      if (p > 1 && std::min(round, along) < 1.12 * options_.min_edge) break;
      const double misfit = std::abs(std::log(round / size)) + std::abs(std::log(along / size));
      if (misfit < best_misfit) {
        best_misfit = misfit;
        best = p;
      }
    }
    return best;
  }

  void run() { half_core_ == 0 ? add_without_core() : add_with_core(); }

 private:
  Index boundary_vertex(double back_from_left) {
    double at = std::fmod(left_at_ - back_from_left, builder_.loop_length(loop_));
    if (at < 0) at += builder_.loop_length(loop_);
    return builder_.add_boundary_vertex({loop_, at});
  }

  /// Arc from the tip to the bend without a core, where the chord is as long as the radius and no shorter
  /// than the minimum; at most two thirds of the way to the cut.
  double tip_arc(int side, double arc) const {
    // Unrolled caps are a little larger than they are in space.
    const double wanted = std::max(options_.radius, 1.15 * options_.min_edge);
    const Vec2 tip = builder_.point_of(tip_);
    const double most = arc * 2 / 3;
    for (double s = 0; s < most; s += most / 200)
      if (distance(builder_.point_at({loop_, tip_at_ + side * s}), tip) >= wanted) return s;
    return most;
  }

  /// Two bands that bend round at a corner on the arc; the tip is regular.
  void add_without_core() {
    const Index left_bend = boundary_vertex(left_arc_ - left_tip_arc_);
    const Index right_bend = boundary_vertex(left_arc_ + right_tip_arc_);
    builder_.add_edge(chord_.middle, tip_, VirtualEdgeKind::ridge, inner_part(crest_, 0, 1), rows_);
    builder_.add_boundary_edge(chord_.left, left_bend, true);
    builder_.add_boundary_edge(left_bend, tip_, true, 1);
    builder_.add_boundary_edge(tip_, right_bend, true, 1);
    builder_.add_boundary_edge(right_bend, chord_.right, true);
    builder_.add_block(
        {{{chord_.middle, tip_}, {tip_, left_bend}, {left_bend, chord_.left}, {chord_.left, chord_.middle}}});
    builder_.add_block({{{tip_, chord_.middle},
                         {chord_.middle, chord_.right},
                         {chord_.right, right_bend},
                         {right_bend, tip_}}});
  }

  void add_with_core() {
    const double share = double(rows_) / (rows_ + half_core_);
    const Index left_arc = boundary_vertex(share * left_arc_);
    const Index right_arc = boundary_vertex(left_arc_ + (1 - share) * right_arc_);
    const double core_share = double(rows_) / (rows_ + options_.bands);
    const Index core_end = builder_.add_vertex(point_along(crest_, core_share));
    const Index a = chord_.left_path[1], b = chord_.right_path[1];
    const Index s = builder_.add_vertex(core_corner(core_end, a, left_arc));
    const Index r = builder_.add_vertex(core_corner(core_end, b, right_arc));
    const auto inner = VirtualEdgeKind::inner;
    builder_.add_edge(chord_.middle, core_end, VirtualEdgeKind::ridge, inner_part(crest_, 0, core_share),
                      rows_);
    builder_.add_edge(core_end, tip_, VirtualEdgeKind::ridge, inner_part(crest_, core_share, 1),
                      options_.bands);
    builder_.add_edge(a, s, inner);
    builder_.add_edge(b, r, inner);
    builder_.add_edge(s, core_end, inner, {}, half_core_);
    builder_.add_edge(core_end, r, inner, {}, half_core_);
    builder_.add_edge(s, left_arc, inner, {}, options_.bands);
    builder_.add_edge(r, right_arc, inner, {}, options_.bands);
    builder_.add_boundary_edge(chord_.left, left_arc, true);
    builder_.add_boundary_edge(left_arc, tip_, true, half_core_);
    builder_.add_boundary_edge(tip_, right_arc, true, half_core_);
    builder_.add_boundary_edge(right_arc, chord_.right, true);
    const Index o = chord_.middle;
    builder_.add_block({{{chord_.left, a}, {a, s}, {s, left_arc}, {left_arc, chord_.left}}});
    builder_.add_block({{{a, o}, {o, core_end}, {core_end, s}, {s, a}}});
    builder_.add_block({{{o, b}, {b, r}, {r, core_end}, {core_end, o}}});
    builder_.add_block({{{b, chord_.right}, {chord_.right, right_arc}, {right_arc, r}, {r, b}}});
    builder_.add_block({{{s, core_end}, {core_end, tip_}, {tip_, left_arc}, {left_arc, s}}});
    builder_.add_block({{{core_end, r}, {r, right_arc}, {right_arc, tip_}, {tip_, core_end}}});
  }

  /// Between the core's side, carried on, and the arc: the smoothing does the rest.
  Vec2 core_corner(Index core_end, Index side, Index arc) const {
    const Vec2 offset = builder_.point_of(side) - builder_.point_of(chord_.middle);
    const Vec2 carried = builder_.point_of(core_end) + offset * 0.8;
    return lerp(carried, builder_.point_of(arc), 0.15);
  }

  BlockLayoutBuilder& builder_;
  const Chord& chord_;
  Index tip_;
  CapOptions options_;
  int half_core_;
  double left_tip_arc_ = 0, right_tip_arc_ = 0;  ///< without a core: from the tip to the bends
  int rows_ = 1;
  std::vector<Vec2> crest_;
  Index loop_ = 0;
  double left_at_ = 0, tip_at_ = 0, left_arc_ = 0, right_arc_ = 0;
};

}  // namespace

void add_chord_edges(BlockLayoutBuilder& builder, Chord& chord, int elements_across, int bands) {
  const int half = elements_across / 2;
  chord.left_path = {chord.left, chord.middle};
  chord.right_path = {chord.middle, chord.right};
  if (bands == 0 || half <= bands) {
    builder.add_edge(chord.left, chord.middle, VirtualEdgeKind::split, {}, half);
    builder.add_edge(chord.middle, chord.right, VirtualEdgeKind::split, {}, half);
    return;
  }
  const double share = double(bands) / half;
  const Vec2 middle = builder.point_of(chord.middle);
  const Index a = builder.add_vertex(lerp(builder.point_of(chord.left), middle, share));
  const Index b = builder.add_vertex(lerp(builder.point_of(chord.right), middle, share));
  builder.add_edge(chord.left, a, VirtualEdgeKind::split, {}, bands);
  builder.add_edge(a, chord.middle, VirtualEdgeKind::split, {}, half - bands);
  builder.add_edge(chord.middle, b, VirtualEdgeKind::split, {}, half - bands);
  builder.add_edge(b, chord.right, VirtualEdgeKind::split, {}, bands);
  chord.left_path = {chord.left, a, chord.middle};
  chord.right_path = {chord.middle, b, chord.right};
}

void add_end_cap(BlockLayoutBuilder& builder, const Chord& chord, Index tip, const std::vector<Vec2>& crest,
                 const CapOptions& options) {
  CapBuilder(builder, chord, tip, crest, options).run();
}

}  // namespace beadmesh
