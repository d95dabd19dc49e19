#include "beadmesh/blocking/bead_blocks.h"

#include <algorithm>
#include <cmath>

#include "beadmesh/blocking/arm_line.h"
#include "beadmesh/blocking/axis_station.h"
#include "beadmesh/blocking/chord.h"

namespace beadmesh {
namespace {

constexpr double opposite_feet =
    radians(165);                    ///< a cut runs across the arm only where its feet face each other
constexpr double longest_fan = 7;    ///< sizes along the crest
constexpr double fan_margin = 1.12;  ///< minimum lengths a row has at a foot before the smoothing
constexpr double flat_sector = radians(140);  ///< arms further apart leave a straight far side between them

/// One end of an arm at a junction, seen outward from the junction.
struct ArmEnd {
  Index arm = no_index;
  bool at_end = false;  ///< the arm ends here: outward is against its own direction
  Vec2 direction;       ///< outward
};

/// The boundary between two neighbouring arm ends, counter-clockwise.
struct Sector {
  bool flat = false;
  BoundaryPosition foot;
  Index vertex = no_index;  ///< shared by both cuts where the sector is not flat
};

class BeadBlocks {
 public:
  BeadBlocks(const Skeleton& skeleton, const RidgeGraph& ridge, const PlanarRegion& region,
             const BeadBlockOptions& options)
      : skeleton_(skeleton),
        ridge_(ridge),
        options_(options),
        builder_(region),
        loop_lengths_(loop_lengths_of(region)) {
    options_.bands = std::clamp(options.bands, 1, std::max(1, options.elements_across / 2 - 1));
    for (size_t a = 0; a < ridge.arms.size(); ++a)
      arms_.emplace_back(skeleton.arms[a], ridge.arms[a], loop_lengths_);
    node_vertex_.assign(ridge.nodes.size(), no_index);
    start_chord_.resize(ridge.arms.size());
    end_chord_.resize(ridge.arms.size());
  }

  Result<BlockLayout> run() {
    for (Index n = 0; n < Index(ridge_.nodes.size()); ++n) {
      const RidgeNode& node = ridge_.nodes[n];
      if (node.arms.size() == 1 && !node.tip)
        return fail("blocking.tip", "an arm ends without a tip on the boundary");
      node_vertex_[n] =
          node.tip ? builder_.add_boundary_vertex(node.boundary) : builder_.add_vertex(node.point);
    }
    for (Index n = 0; n < Index(ridge_.nodes.size()); ++n)
      if (ridge_.nodes[n].arms.size() > 1) place_hub(n);
    for (Index a = 0; a < Index(arms_.size()); ++a)
      if (const auto placed = place_arm(a); !placed) return tl::unexpected(placed.error());
    for (Index n = 0; n < Index(ridge_.nodes.size()) && !is_mitred(); ++n)
      if (ridge_.nodes[n].arms.size() > 1) add_hub_blocks(n);
    return builder_.take();
  }

 private:
  struct Hub {
    std::vector<ArmEnd> ends;
    std::vector<Sector> sectors;  ///< sector i lies between ends i and i + 1
  };

  bool is_mitred() const { return options_.hub != HubForm::square; }

  std::vector<ArmEnd> ends_of(Index n) const {
    std::vector<ArmEnd> ends;
    const double reach = 1.5 * ridge_.nodes[n].radius;
    for (Index a : ridge_.nodes[n].arms) {
      const bool seen = std::any_of(ends.begin(), ends.end(), [&](const ArmEnd& e) { return e.arm == a; });
      const bool loop_arm = ridge_.arms[a].start == ridge_.arms[a].end;
      const bool at_end = loop_arm ? seen : ridge_.arms[a].end == n;
      const double along = at_end ? arms_[a].length() - reach : reach;
      ends.push_back({a, at_end, normalized(arms_[a].point(along) - ridge_.nodes[n].point)});
    }
    std::sort(ends.begin(), ends.end(), [](const ArmEnd& p, const ArmEnd& q) {
      return std::atan2(p.direction.y, p.direction.x) < std::atan2(q.direction.y, q.direction.x);
    });
    return ends;
  }

  /// The foot of the arm's first medial point on its left or right, as seen outward.
  BoundaryPosition first_foot(const ArmEnd& end, bool left) const {
    const auto& points = skeleton_.arms[end.arm].points;
    const MedialPoint& p = end.at_end ? points.back() : points.front();
    const Foot& foot = p.feet[left == end.at_end ? 1 : 0];
    return {foot.loop, foot.position};
  }

  Sector sector_between(const ArmEnd& a, const ArmEnd& b) const {
    Sector sector;
    double angle = std::atan2(cross(a.direction, b.direction), dot(a.direction, b.direction));
    if (angle <= 0) angle += 2 * pi;
    sector.flat = angle >= flat_sector;
    const BoundaryPosition p = first_foot(a, true), q = first_foot(b, false);
    sector.foot = p;
    if (p.loop == q.loop) {
      const double length = loop_lengths_[p.loop];
      sector.foot.position =
          std::fmod(p.position + loop_difference(p.position, q.position, length) / 2 + length, length);
    }
    return sector;
  }

  void place_hub(Index n) {
    Hub hub;
    hub.ends = ends_of(n);
    const size_t k = hub.ends.size();
    for (size_t i = 0; i < k; ++i) {
      hub.sectors.push_back(sector_between(hub.ends[i], hub.ends[(i + 1) % k]));
      if (!hub.sectors[i].flat || is_mitred())
        hub.sectors[i].vertex = builder_.add_boundary_vertex(hub.sectors[i].foot);
    }
    for (size_t i = 0; i < k; ++i) {
      const Sector &right = hub.sectors[(i + k - 1) % k], &left = hub.sectors[i];
      is_mitred() ? place_mitre(n, hub.ends[i], right, left) : place_hub_chord(n, hub.ends[i], right, left);
    }
    hubs_.emplace_back(n, std::move(hub));
  }

  /// The cut at which an arm leaves its hub: through the feet of the sectors beside it.
  void place_hub_chord(Index n, const ArmEnd& end, const Sector& right, const Sector& left) {
    const ArmLine& line = arms_[end.arm];
    double along;
    if (!left.flat && !right.flat)
      along = line.nearest(lerp(builder_.point_of(left.vertex), builder_.point_of(right.vertex), 0.5));
    else if (!left.flat)
      along = line.nearest(builder_.point_of(left.vertex));
    else if (!right.flat)
      along = line.nearest(builder_.point_of(right.vertex));
    else
      along = end.at_end ? line.length() - ridge_.nodes[n].radius : ridge_.nodes[n].radius;
    const double least = 0.5 * ridge_.nodes[n].radius;
    along = end.at_end ? std::min(along, line.length() - least) : std::max(along, least);
    const AxisStation station = line.station(along);
    Chord outward;
    outward.along = along;
    outward.middle = builder_.add_vertex(line.point(along));
    outward.left =
        left.flat ? builder_.add_boundary_vertex(end.at_end ? station.right : station.left) : left.vertex;
    outward.right =
        right.flat ? builder_.add_boundary_vertex(end.at_end ? station.left : station.right) : right.vertex;
    (end.at_end ? end_chord_ : start_chord_)[end.arm] = end.at_end ? outward.turned() : outward;
  }

  /// The arm begins in the junction itself, between the lines to the feet beside it.
  void place_mitre(Index n, const ArmEnd& end, const Sector& right, const Sector& left) {
    Chord outward;
    outward.along = end.at_end ? arms_[end.arm].length() : 0;
    outward.middle = node_vertex_[n];
    outward.left = left.vertex;
    outward.right = right.vertex;
    (end.at_end ? end_chord_ : start_chord_)[end.arm] = end.at_end ? outward.turned() : outward;
  }

  bool has_tip(Index a, bool at_end) const {
    const Index n = at_end ? ridge_.arms[a].end : ridge_.arms[a].start;
    return ridge_.nodes[n].tip;
  }

  /// Where the clamp begins (section 4.2): thickness over 2 MEL and r + d over 4 MEL, d from the S vertex. In
  /// an end that is no true arc the feet near S lie close together: the cut waits until they face each other.
  double cap_position(Index a, bool at_end) const {
    const ArmLine& line = arms_[a];
    const RidgeNode& node = ridge_.nodes[at_end ? ridge_.arms[a].end : ridge_.arms[a].start];
    const double mel = options_.min_edge;
    const double step = mel / 10;
    const double beyond = distance(node.point, node.medial_point);  // the ridge runs on to the tip
    // Without a core the clamp is two rows: the bends take half the radius behind S, then comes one more.
    double d = options_.elements_across > 2 ? std::max(0.0, 4 * mel - node.radius)
                                            : 0.55 * node.radius + std::max(1.15 * mel, 0.75 * options_.size);
    for (; d + beyond < line.length(); d += step) {
      const AxisStation station = line.station(at_end ? line.length() - beyond - d : beyond + d);
      if (2 * station.radius > 2 * mel && station.subtended_angle > opposite_feet) break;
    }
    return at_end ? line.length() - beyond - d : beyond + d;
  }

  Chord chord_on_arm(Index a, double along) {
    const AxisStation station = arms_[a].station(along);
    Chord chord;
    chord.along = along;
    chord.middle = builder_.add_vertex(arms_[a].point(along));
    chord.left = builder_.add_boundary_vertex(station.left);
    chord.right = builder_.add_boundary_vertex(station.right);
    return chord;
  }

  Result<void> place_arm(Index a) {
    const bool start_tip = has_tip(a, false), end_tip = has_tip(a, true);
    const double first = start_tip ? cap_position(a, false) : start_chord_[a].along;
    const double last = end_tip ? cap_position(a, true) : end_chord_[a].along;
    if (last - first < 0.8 * options_.min_edge * (start_tip || end_tip ? 2 : 1))
      return place_short_arm(a, start_tip, end_tip, (first + last) / 2);
    if (start_tip) start_chord_[a] = chord_on_arm(a, first);
    if (end_tip) end_chord_[a] = chord_on_arm(a, last);
    add_chord_edges(builder_, start_chord_[a], options_.elements_across, start_tip ? options_.bands : 0);
    add_chord_edges(builder_, end_chord_[a], options_.elements_across, end_tip ? options_.bands : 0);
    add_strip(a, start_chord_[a], end_chord_[a]);
    add_caps(a, start_tip, end_tip);
    return {};
  }

  /// No room for a strip: the two ends share one cut.
  Result<void> place_short_arm(Index a, bool start_tip, bool end_tip, double middle) {
    if (is_mitred() && !(start_tip && end_tip))
      return fail("blocking.short_arm", "an arm is too short for a strip between mitres");
    if (!start_tip && !end_tip)
      return fail("blocking.short_arm", "two junctions are too near for a block between them");
    if (options_.elements_along)
      return fail("blocking.no_strip", "an arm is too short for a strip with a number of elements along");
    Chord shared =
        start_tip && end_tip ? chord_on_arm(a, middle) : (start_tip ? end_chord_[a] : start_chord_[a]);
    add_chord_edges(builder_, shared, options_.elements_across, options_.bands);
    start_chord_[a] = end_chord_[a] = shared;
    add_caps(a, start_tip, end_tip);
    return {};
  }

  void add_caps(Index a, bool start_tip, bool end_tip) {
    const ArmLine& line = arms_[a];
    const size_t first_block = builder_.layout().blocks.size();
    if (end_tip)
      add_end_cap(builder_, end_chord_[a], node_vertex_[ridge_.arms[a].end],
                  line.between(end_chord_[a].along, line.length()), cap_options(ridge_.arms[a].end));
    if (start_tip) {
      std::vector<Vec2> crest = line.between(0, start_chord_[a].along);
      std::reverse(crest.begin(), crest.end());
      add_end_cap(builder_, start_chord_[a].turned(), node_vertex_[ridge_.arms[a].start], crest,
                  cap_options(ridge_.arms[a].start));
    }
    builder_.mark_cap(first_block);
  }

  CapOptions cap_options(Index node) const {
    return {options_.elements_across, ridge_.nodes[node].radius, options_.size, options_.min_edge,
            options_.extra_rows,      options_.clamp_rows,       options_.bands};
  }

  /// True where the touching line keeps the order of its neighbours on both boundaries.
  bool advances(const Chord& from, const AxisStation& to) const {
    const auto& vertices = builder_.layout().vertices;
    const BoundaryPosition left = vertices[from.left].boundary, right = vertices[from.right].boundary;
    if (left.loop != to.left.loop || right.loop != to.right.loop) return false;
    const double least = 0.5 * options_.min_edge;
    return loop_difference(left.position, to.left.position, loop_lengths_[left.loop]) < -least &&
           loop_difference(right.position, to.right.position, loop_lengths_[right.loop]) > least;
  }

  AxisStation as_station(const Chord& chord) const {
    const auto& vertices = builder_.layout().vertices;
    AxisStation out;
    out.left = vertices[chord.left].boundary;
    out.right = vertices[chord.right].boundary;
    return out;
  }

  /// A cut where the fan of rows behind a mitre has come to stand across the arm.
  struct Fan {
    double along = 0;
    int rows = 0;  ///< 0: none
  };

  /// Length of the shorter side between a cut of the arm and the touching line at `along`.
  double shorter_side(Index a, const Chord& from, double along) const {
    const AxisStation to = arms_[a].station(along);
    const auto& vertices = builder_.layout().vertices;
    const BoundaryPosition left = vertices[from.left].boundary, right = vertices[from.right].boundary;
    if (left.loop != to.left.loop || right.loop != to.right.loop) return 0;
    return std::min(std::abs(loop_difference(left.position, to.left.position, loop_lengths_[left.loop])),
                    std::abs(loop_difference(right.position, to.right.position, loop_lengths_[right.loop])));
  }

  /// Behind a mitre the crest is longer than the feet by as much as the mitre runs along the arm. The cut is
  /// put where the number of rows that the feet have room for suits the crest best.
  Fan fan_behind(Index a, const Chord& mitre, double room) const {
    const double step = options_.size / 5, outward = mitre.along > 0 ? -1 : 1;
    Fan best;
    double best_misfit = 1e300;
    for (double length = 2 * options_.size; length <= std::min(room, longest_fan * options_.size);
         length += step) {
      const double along = mitre.along + outward * length;
      const int rows = int(shorter_side(a, mitre, along) / (fan_margin * options_.min_edge));
      const double misfit = std::abs(std::log(length / (std::max(rows, 1) * options_.size)));
      if (rows < 1 || misfit > best_misfit - 1e-9) continue;
      best = {along, rows};
      best_misfit = misfit;
    }
    return best;
  }

  /// Strip of an arm; where it begins or ends in a mitre, with a fan of rows there.
  void add_strip(Index a, const Chord& first, const Chord& last) {
    const bool fans = options_.hub == HubForm::fan && !options_.elements_along;
    const bool at_start = fans && !has_tip(a, false), at_end = fans && !has_tip(a, true);
    const double room = (last.along - first.along) / (at_start && at_end ? 2 : 1) - options_.size;
    Chord from = first, to = last;
    const Fan near = at_start ? fan_behind(a, first, room) : Fan{},
              far = at_end ? fan_behind(a, last, room) : Fan{};
    if (near.rows) from = cut_of_strip(a, near.along);
    if (far.rows) to = cut_of_strip(a, far.along);
    if (near.rows) add_strip_blocks(a, first, from, near.rows);
    add_even_strip(a, from, to);
    if (far.rows) add_strip_blocks(a, to, last, far.rows);
  }

  Chord cut_of_strip(Index a, double along) {
    Chord chord = chord_on_arm(a, along);
    add_chord_edges(builder_, chord, options_.elements_across, 0);
    return chord;
  }

  /// Touching lines about every four elements keep the two sides of a winding arm in step.
  void add_even_strip(Index a, const Chord& first, const Chord& last) {
    const double length = last.along - first.along;
    const int asked = options_.elements_along;
    const double size = asked ? length / asked : options_.size;
    const int pieces = std::max(1, int(std::lround(length / (4 * size))));
    const auto count_to = [&](double along) {
      return int(std::lround(asked * (along - first.along) / length));
    };
    Chord before = first;
    for (int i = 1; i < pieces; ++i) {
      const double along = first.along + length * i / pieces;
      const AxisStation station = arms_[a].station(along);
      if (!advances(before, station)) continue;
      Chord cut;
      cut.left = builder_.add_boundary_vertex(station.left);
      cut.right = builder_.add_boundary_vertex(station.right);
      if (!advances(cut, as_station(last))) continue;
      cut.along = along;
      cut.middle = builder_.add_vertex(arms_[a].point(along));
      add_chord_edges(builder_, cut, options_.elements_across, 0);
      add_strip_blocks(a, before, cut, count_to(along) - count_to(before.along));
      before = cut;
    }
    add_strip_blocks(a, before, last, count_to(last.along) - count_to(before.along));
  }

  static std::vector<Index> back(std::vector<Index> path) {
    std::reverse(path.begin(), path.end());
    return path;
  }

  /// `count` elements along; 0: from the size.
  void add_strip_blocks(Index a, const Chord& from, const Chord& to, int count) {
    builder_.add_edge(from.middle, to.middle, VirtualEdgeKind::ridge, arms_[a].between(from.along, to.along),
                      count);
    builder_.add_boundary_edge(from.left, to.left, true);
    builder_.add_boundary_edge(from.right, to.right, false);
    builder_.add_block(
        {{from.left_path, {from.middle, to.middle}, back(to.left_path), {to.left, from.left}}});
    builder_.add_block(
        {{from.right_path, {from.right, to.right}, back(to.right_path), {to.middle, from.middle}}});
  }

  Chord outward_chord(const ArmEnd& end) const {
    return end.at_end ? end_chord_[end.arm].turned() : start_chord_[end.arm];
  }

  void add_ridge_stub(Index n, const ArmEnd& end, const Chord& chord) {
    const ArmLine& line = arms_[end.arm];
    std::vector<Vec2> points =
        end.at_end ? line.between(chord.along, line.length()) : line.between(0, chord.along);
    if (!end.at_end) std::reverse(points.begin(), points.end());
    builder_.add_edge(chord.middle, node_vertex_[n], VirtualEdgeKind::ridge, points,
                      options_.elements_across / 2);
  }

  void add_hub_blocks(Index n) {
    const auto found = std::find_if(hubs_.begin(), hubs_.end(), [&](const auto& h) { return h.first == n; });
    const Hub& hub = found->second;
    const size_t k = hub.ends.size();
    for (const ArmEnd& end : hub.ends) add_ridge_stub(n, end, outward_chord(end));
    for (size_t i = 0; i < k; ++i)
      add_sector_blocks(n, hub.sectors[i], outward_chord(hub.ends[i]), outward_chord(hub.ends[(i + 1) % k]));
  }

  void add_sector_blocks(Index n, const Sector& sector, const Chord& before, const Chord& after) {
    const Index centre = node_vertex_[n];
    if (!sector.flat) {
      builder_.add_block({{{centre, before.middle},
                           back(before.left_path),
                           back(after.right_path),
                           {after.middle, centre}}});
      return;
    }
    const int half = options_.elements_across / 2;
    const BoundaryPosition a = builder_.layout().vertices[before.left].boundary;
    const BoundaryPosition b = builder_.layout().vertices[after.right].boundary;
    double forward = std::fmod(b.position - a.position, loop_lengths_[a.loop]);
    if (forward < 0) forward += loop_lengths_[a.loop];
    const Index far =
        builder_.add_boundary_vertex({a.loop, std::fmod(a.position + forward / 2, loop_lengths_[a.loop])});
    builder_.add_edge(centre, far, VirtualEdgeKind::inner, {}, half);
    builder_.add_boundary_edge(before.left, far, false, half);
    builder_.add_boundary_edge(far, after.right, false, half);
    builder_.add_block(
        {{{centre, before.middle}, back(before.left_path), {before.left, far}, {far, centre}}});
    builder_.add_block({{{centre, far}, {far, after.right}, back(after.right_path), {after.middle, centre}}});
  }

  const Skeleton& skeleton_;
  const RidgeGraph& ridge_;
  BeadBlockOptions options_;
  BlockLayoutBuilder builder_;
  std::vector<double> loop_lengths_;
  std::vector<ArmLine> arms_;
  std::vector<Index> node_vertex_;
  std::vector<Chord> start_chord_, end_chord_;
  std::vector<std::pair<Index, Hub>> hubs_;
};

}  // namespace

Result<BlockLayout> blocks_of_bead(const Skeleton& skeleton, const RidgeGraph& ridge,
                                   const PlanarRegion& region, const BeadBlockOptions& options) {
  for (const RidgeArm& arm : ridge.arms)
    if (arm.start == no_index || arm.points.size() < 2)
      return fail("blocking.arm", "an arm is closed or has no length");
  return BeadBlocks(skeleton, ridge, region, options).run();
}

}  // namespace beadmesh
