#include "beadmesh/bead/shape_letter.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

// ---------------------------------------------------------------- one arm: bends

/// A stretch of an arm that turns one way.
struct Bend {
  double turn = 0;    ///< radians, positive to the left
  double length = 0;  ///< along the arm
  double middle = 0;  ///< arc length of its middle
};

struct ArmShape {
  double length = 0;
  double thickness = 0;
  double left = 0, right = 0;  ///< total turn each way, radians
  std::vector<Bend> bends;     ///< stretches that bend, those under 15 degrees left out
};

std::vector<Vec2> resampled(const SkeletonArm& arm, double step) {
  std::vector<Vec2> out{arm.points.front().point};
  double carried = 0;
  for (size_t i = 1; i < arm.points.size(); ++i) {
    const Vec2 a = arm.points[i - 1].point, b = arm.points[i].point;
    const double length = distance(a, b);
    double at = step - carried;
    for (; at <= length; at += step) out.push_back(lerp(a, b, at / length));
    carried = length - (at - step);
  }
  return out;
}

double mean_thickness(const SkeletonArm& arm) {
  double sum = 0, length = 0;
  for (size_t i = 1; i < arm.points.size(); ++i) {
    const double step = distance(arm.points[i - 1].point, arm.points[i].point);
    sum += step * (arm.points[i - 1].radius + arm.points[i].radius);
    length += step;
  }
  return length > 0 ? sum / length : 0;
}

/// Turning over windows of half the thickness: shorter wiggles are noise, not shape.
ArmShape shape_of(const SkeletonArm& arm) {
  ArmShape out;
  out.length = length_of(arm);
  out.thickness = mean_thickness(arm);
  const double step = std::max(out.thickness / 2, out.length / 200);
  const auto points = resampled(arm, step);
  std::vector<double> turns;
  for (size_t i = 1; i + 1 < points.size(); ++i) {
    const Vec2 u = points[i] - points[i - 1], v = points[i + 1] - points[i];
    turns.push_back(std::atan2(cross(u, v), dot(u, v)));
    (turns.back() > 0 ? out.left : out.right) += std::abs(turns.back());
  }
  // Per window: a radius of ten thicknesses is a curve. So is a wider one that goes on along the whole arm.
  const double mean = (out.left + out.right) / double(std::max<size_t>(turns.size(), 1));
  const double straight = std::min(radians(3), mean / 2);
  Bend current;
  const auto close = [&] {
    if (std::abs(current.turn) > radians(15)) out.bends.push_back(current);
    current = {};
  };
  for (size_t i = 0; i < turns.size(); ++i) {
    const double turn = turns[i];
    const bool bends = std::abs(turn) > straight;
    if (!bends || (current.turn != 0 && (turn > 0) != (current.turn > 0))) close();
    if (!bends) continue;
    const double at = double(i + 1) * step;
    current.middle = current.length == 0 ? at : current.middle + step / 2;
    current.length += step;
    current.turn += turn;
  }
  close();
  return out;
}

/// A bend that a person calls a corner: 40 degrees and more within a short stretch of the arm.
bool is_sharp(const Bend& bend, const ArmShape& arm) {
  return std::abs(bend.turn) > radians(40) && bend.length < std::max(3.5 * arm.thickness, 0.35 * arm.length);
}

std::string letter_of_one_way(const ArmShape& arm, double total) {
  double bent = 0, middle = 0, sharp = 0;
  for (const Bend& b : arm.bends) {
    bent += b.length;
    middle += b.length * b.middle;
    sharp += is_sharp(b, arm) ? 1 : 0;
  }
  const double straight_share = 1 - bent / arm.length;
  const double off_middle = std::abs(middle / std::max(bent, 1e-300) / arm.length - 0.5);
  if (total > radians(285)) return "G";
  if (straight_share < 0.3 && sharp == 0) return total < radians(150) ? "arc" : "C";
  if (arm.bends.size() >= 3) return "G";
  if (arm.bends.size() == 2) return total > radians(235) ? "G" : "U";
  if (total > radians(125)) return off_middle < 0.08 ? "U" : "J";
  if (total > radians(40) && straight_share > 0.3) return off_middle < 0.28 ? "L" : "J";
  return total < radians(150) ? "arc" : "C";
}

std::string letter_of_arm(const SkeletonArm& arm) {
  const ArmShape shape = shape_of(arm);
  const double small = std::min(shape.left, shape.right), total = std::max(shape.left, shape.right);
  if (shape.bends.empty() || total < radians(18)) return "I";
  bool both_ways = false;
  int sharp = 0;
  double bent = 0;
  for (const Bend& b : shape.bends) {
    bent += b.length;
    both_ways |= (b.turn > 0) != (shape.bends[0].turn > 0);
    sharp += is_sharp(b, shape);
  }
  if (both_ways && small > radians(12))
    return sharp == 2 && shape.bends.size() == 2 && bent < 0.5 * shape.length ? "Z" : "S";
  return letter_of_one_way(shape, total);
}

// ---------------------------------------------------------------- several arms

struct Counts {
  int ends = 0;
  std::vector<Index> junctions;
  int cycles = 0;
};

Counts count(const Skeleton& skeleton) {
  Counts out;
  for (Index n = 0; n < Index(skeleton.nodes.size()); ++n) {
    const size_t degree = skeleton.nodes[n].arms.size();
    if (degree == 1) ++out.ends;
    if (degree >= 3) out.junctions.push_back(n);
  }
  out.cycles = int(skeleton.arms.size()) - int(skeleton.nodes.size()) + 1;
  return out;
}

/// Outward direction of an arm beyond the fillets of its junction.
Vec2 settled_direction(const SkeletonArm& arm, bool at_end, double radius) {
  const double length = length_of(arm);
  const double from = std::min(1.3 * radius, 0.4 * length), to = std::min(3.5 * radius, 0.9 * length);
  const Vec2 start = at_end ? arm.points.back().point : arm.points.front().point;
  const auto place = [&](double reach) {
    double walked = 0;
    const int n = int(arm.points.size());
    const auto at = [&](int i) { return arm.points[at_end ? n - 1 - i : i].point; };
    for (int i = 1; i < n; ++i) {
      const double step = distance(at(i - 1), at(i));
      if (walked + step >= reach && step > 0) return lerp(at(i - 1), at(i), (reach - walked) / step);
      walked += step;
    }
    return at(n - 1);
  };
  const Vec2 d = place(to) - place(from);
  return norm(d) > 0 ? normalized(d) : normalized(place(to) - start);
}

std::vector<Vec2> directions_from(const Skeleton& skeleton, Index node) {
  std::vector<Vec2> out;
  for (Index a : skeleton.nodes[node].arms)
    out.push_back(
        settled_direction(skeleton.arms[a], skeleton.arms[a].end == node, skeleton.nodes[node].radius));
  return out;
}

constexpr double through = radians(155);       ///< two arms of a T are one bar
constexpr double curved_spine = radians(140);  ///< the same along the spine of a comb, which may be curved

/// Index of the arm that stands off the through pair (the other two, `least` apart), or no_index for a Y.
Index stem_of(const Skeleton& skeleton, Index node, double least = through) {
  const auto d = directions_from(skeleton, node);
  Index stem = no_index;
  double best = least;
  for (int k = 0; k < 3; ++k) {
    const double angle = angle_between(d[(k + 1) % 3], d[(k + 2) % 3]);
    if (angle > best) {
      best = angle;
      stem = skeleton.nodes[node].arms[k];
    }
  }
  return stem;
}

bool is_end_arm(const Skeleton& skeleton, Index arm) {
  return skeleton.nodes[skeleton.arms[arm].start].arms.size() == 1 ||
         skeleton.nodes[skeleton.arms[arm].end].arms.size() == 1;
}

/// Arms of a junction that bend round into teeth beside its stem, as a rounded corner of the spine does.
int bent_teeth(const Skeleton& skeleton, Index node) {
  const Index stem = stem_of(skeleton, node);
  if (stem == no_index || !is_end_arm(skeleton, stem)) return 0;
  const SkeletonArm& tooth = skeleton.arms[stem];
  const Vec2 along = settled_direction(tooth, tooth.end == node, skeleton.nodes[node].radius);
  int count = 0;
  for (Index a : skeleton.nodes[node].arms) {
    const SkeletonArm& arm = skeleton.arms[a];
    if (a == stem || !is_end_arm(skeleton, a)) continue;
    const bool leaves_at_end = arm.end == node;
    const Index tip = leaves_at_end ? arm.start : arm.end;
    const Vec2 outward = -settled_direction(arm, !leaves_at_end, skeleton.nodes[tip].radius);
    count += angle_between(outward, along) < radians(25);
  }
  return count;
}

std::string letter_of_one_junction(const Skeleton& skeleton, Index node) {
  const size_t degree = skeleton.nodes[node].arms.size();
  if (degree == 4) return "X";
  if (degree != 3) return "tree";
  if (stem_of(skeleton, node) == no_index) return "Y";
  const int bent = bent_teeth(skeleton, node);
  return bent == 0 ? "T" : bent == 1 ? "F" : "comb";
}

std::string letter_of_two_junctions(const Skeleton& skeleton, const Counts& counts) {
  const Index a = counts.junctions[0], b = counts.junctions[1];
  const Index stem_a = stem_of(skeleton, a), stem_b = stem_of(skeleton, b);
  const auto joins = [&](Index arm) { return arm != no_index && !is_end_arm(skeleton, arm); };
  if (joins(stem_a) && joins(stem_b)) return "H";
  const bool teeth = stem_a != no_index && stem_b != no_index && !joins(stem_a) && !joins(stem_b);
  if (!teeth) return "tree";
  return bent_teeth(skeleton, a) + bent_teeth(skeleton, b) > 0 ? "comb" : "F";
}

/// A tooth's direction against its spine: which side of the way from the junction to the next one it stands
/// on.
bool teeth_on_one_side(const Skeleton& skeleton, const Counts& counts) {
  Vec2 mean{0, 0};
  std::vector<Vec2> stems;
  for (Index n : counts.junctions) {
    if (skeleton.nodes[n].arms.size() != 3) return false;
    for (Index a : skeleton.nodes[n].arms) {
      if (!is_end_arm(skeleton, a)) continue;
      const SkeletonArm& arm = skeleton.arms[a];
      const Vec2 direction = settled_direction(arm, arm.end == n, skeleton.nodes[n].radius);
      const Index stem = stem_of(skeleton, n, curved_spine);
      if (stem == a || stem == no_index) stems.push_back(direction);
    }
  }
  for (Vec2 s : stems) mean += s;
  for (Vec2 s : stems)
    if (dot(s, mean) <= 0) return false;
  return stems.size() + 1 >= counts.junctions.size();
}

/// Three prongs of about one direction on a bar with a handle against them.
bool is_trident(const Skeleton& skeleton, const Counts& counts) {
  if (counts.ends != 4 || counts.junctions.size() > 2) return false;
  std::vector<Vec2> tips;  // direction in which every end arm runs out
  for (Index n = 0; n < Index(skeleton.nodes.size()); ++n) {
    if (skeleton.nodes[n].arms.size() != 1) continue;
    const SkeletonArm& arm = skeleton.arms[skeleton.nodes[n].arms[0]];
    tips.push_back(-settled_direction(arm, arm.end == n, skeleton.nodes[n].radius));
  }
  for (size_t handle = 0; handle < tips.size(); ++handle) {
    bool all = true;
    for (size_t k = 0; k < tips.size(); ++k)
      if (k != handle) all = all && angle_between(tips[k], -tips[handle]) < radians(25);
    if (all) return true;
  }
  return false;
}

std::string letter_of_tree(const Skeleton& skeleton, const Counts& counts) {
  if (is_trident(skeleton, counts)) return "trident";
  if (counts.junctions.size() == 1) return letter_of_one_junction(skeleton, counts.junctions[0]);
  if (counts.junctions.size() == 2 && counts.ends == 4) {
    const std::string letter = letter_of_two_junctions(skeleton, counts);
    if (letter != "tree") return letter;
  }
  if (teeth_on_one_side(skeleton, counts)) return counts.junctions.size() >= 3 ? "comb" : "F";
  return "tree";
}

}  // namespace

std::string shape_letter(const Skeleton& skeleton) {
  if (skeleton.arms.empty()) return "I";
  const Counts counts = count(skeleton);
  const bool all_closed = std::all_of(skeleton.arms.begin(), skeleton.arms.end(),
                                      [](const SkeletonArm& arm) { return arm.start == no_index; });
  if (all_closed) return "ring";
  if (counts.cycles > 0) return "ladder";
  if (counts.junctions.empty()) return letter_of_arm(skeleton.arms[0]);
  return letter_of_tree(skeleton, counts);
}

}  // namespace beadmesh
