#include "beadmesh/bead/ridge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "beadmesh/bead/crest_tip.h"
#include "beadmesh/bead/plan_frame.h"

namespace beadmesh {
namespace {

using Polyline = std::vector<Vec2>;

/// Where an arm stands after walking `reach` from one of its ends, and its tangent there, pointing away from
/// that end.
struct Reached {
  Vec2 point;
  Vec2 tangent;
  size_t kept = 0;       ///< points nearer to the end than the reached one
  Vec2 beyond;           ///< tangent further out, over a long stretch
  bool settled = true;   ///< the junction's fillets end before
  Vec2 far_end;          ///< last point of the arm
  bool is_leaf = false;  ///< the arm ends there in a tip
};

Polyline oriented(const Polyline& points, bool at_end) {
  return at_end ? Polyline(points.rbegin(), points.rend()) : points;
}

/// Least-squares direction of the polyline within `window` around the walked length `reach`: the smoothed
/// tangent of section 4.3 without its dependence on single samples.
Vec2 tangent_around(const Polyline& points, double reach, double window) {
  Vec2 first = points.front(), last = points.front();
  double walked = 0;
  bool begun = false;
  for (size_t i = 1; i < points.size(); ++i) {
    const double step = distance(points[i - 1], points[i]);
    const double low = reach - window, high = reach + window;
    if (!begun && walked + step > low) {
      const double t = step > 0 ? std::clamp((low - walked) / step, 0.0, 1.0) : 0.0;
      first = lerp(points[i - 1], points[i], t);
      begun = true;
    }
    if (begun) {
      const double t = step > 0 ? std::clamp((high - walked) / step, 0.0, 1.0) : 1.0;
      last = lerp(points[i - 1], points[i], t);
    }
    walked += step;
    if (walked >= high) break;
  }
  return normalized(last - first);
}

Reached walk(const Polyline& points, double reach, double radius) {
  double walked = 0;
  Reached out;
  out.point = out.far_end = points.back();
  out.kept = points.size();
  out.beyond = tangent_around(points, reach + radius, radius);
  for (size_t i = 1; i < points.size(); ++i) {
    const double step = distance(points[i - 1], points[i]);
    if (walked + step >= reach) {
      out.point = step > 0 ? lerp(points[i - 1], points[i], (reach - walked) / step) : points[i];
      out.kept = i;
      break;
    }
    walked += step;
  }
  out.tangent = tangent_around(points, reach + 0.2 * radius, 0.2 * radius);
  return out;
}

std::optional<Vec2> intersection(Vec2 p, Vec2 u, Vec2 q, Vec2 v) {
  const double det = cross(u, v);
  if (std::abs(det) < 0.2 * norm(u) * norm(v))
    return std::nullopt;  // near-parallel lines meet nowhere useful
  return p + u * (cross(q - p, v) / det);
}

/// How far the end of a stub may lie beside the line of the arm opposite, as a share of the radius.
constexpr double stub_miss = 0.1;
constexpr size_t no_point_kept = std::numeric_limits<size_t>::max();

struct Tip {
  Vec2 point;
  BoundaryPosition boundary;
};

/// First hit of the ray with the region's boundary.
std::optional<Tip> first_hit(const PlanarRegion& region, Vec2 from, Vec2 direction) {
  std::optional<Tip> best;
  double best_t = 0;
  for (Index l = 0; l < Index(region.loops.size()); ++l) {
    const auto& points = region.loops[l].points;
    double position = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      const Vec2 a = points[i], b = points[(i + 1) % points.size()];
      const double det = cross(direction, b - a);
      if (det != 0) {
        const double t = cross(a - from, b - a) / det, s = cross(a - from, direction) / det;
        if (t > 0 && s >= 0 && s <= 1 && (!best || t < best_t)) {
          best_t = t;
          best = Tip{lerp(a, b, s), {l, position + s * distance(a, b)}};
        }
      }
      position += distance(a, b);
    }
  }
  return best;
}

class RidgeBuilder {
 public:
  RidgeBuilder(const Skeleton& skeleton, const PlanarRegion& region, const SurfaceMap* map,
               const RidgeOptions& options)
      : skeleton_(skeleton), region_(region), map_(map), options_(options) {}

  RidgeGraph run() {
    for (const SkeletonNode& node : skeleton_.nodes)
      graph_.nodes.push_back({node.point, node.point, node.radius, false, false, {}, node.arms});
    for (const SkeletonArm& arm : skeleton_.arms) graph_.arms.push_back(curve_of(arm));
    carried_.assign(graph_.arms.size(), false);
    for (Index n = 0; n < Index(graph_.nodes.size()); ++n)
      if (graph_.nodes[n].arms.size() >= 3) straighten(n);
    for (Index n = 0; n < Index(graph_.nodes.size()); ++n)
      if (graph_.nodes[n].arms.size() == 1) extend_to_tip(n);
    return std::move(graph_);
  }

 private:
  RidgeArm curve_of(const SkeletonArm& arm) const {
    RidgeArm curve{arm.start, arm.end, {}};
    for (const MedialPoint& p : arm.points) curve.points.push_back(p.point);
    // Merged junctions moved: the arm follows its nodes.
    if (arm.start != no_index) curve.points.front() = skeleton_.nodes[arm.start].point;
    if (arm.end != no_index) curve.points.back() = skeleton_.nodes[arm.end].point;
    return curve;
  }

  void extend_to_tip(Index n) {
    const Index a = graph_.nodes[n].arms[0];
    if (!carried_[a] && map_ && follow_to_tip(n, a)) return;
    RidgeNode& node = graph_.nodes[n];
    RidgeArm& arm = graph_.arms[a];
    const bool at_end = arm.end == n;
    const Polyline inward = oriented(arm.points, at_end);
    if (inward.size() < 2) return;
    const Vec2 outward = -tangent_around(inward, 0.5 * node.radius, 0.5 * node.radius);
    const auto tip = first_hit(region_, node.point, outward);
    if (!tip) return;
    if (at_end)
      arm.points.push_back(tip->point);
    else
      arm.points.insert(arm.points.begin(), tip->point);
    set_tip(node, *tip);
  }

  static void set_tip(RidgeNode& node, const Tip& tip) {
    node.tip = true;
    node.point = tip.point;
    node.boundary = tip.boundary;
  }

  /// False where the arm is too short to see how its crest runs.
  bool follow_to_tip(Index n, Index a) {
    RidgeArm& arm = graph_.arms[a];
    const bool at_end = arm.end == n;
    std::vector<MedialPoint> medial = skeleton_.arms[a].points;
    if (at_end) std::reverse(medial.begin(), medial.end());
    const auto tip = crest_tip(medial, graph_.nodes[n].radius, region_, *map_);
    if (!tip) return false;
    Polyline curve{tip->point};
    curve.insert(curve.end(), tip->crest.rbegin(), tip->crest.rend());
    const Polyline inward = oriented(arm.points, at_end);
    const auto from = std::find(inward.begin(), inward.end(), medial[tip->kept].point);
    if (from == inward.end()) return false;
    curve.insert(curve.end(), from, inward.end());
    arm.points = oriented(curve, at_end);
    set_tip(graph_.nodes[n], {tip->point, {tip->loop, tip->position}});
    return true;
  }

  /// The arms' ends at node n: which arm, and whether it ends there. A loop arm appears with both its ends.
  std::vector<std::pair<Index, bool>> ends_at(Index n) const {
    std::vector<std::pair<Index, bool>> ends;
    for (Index a : graph_.nodes[n].arms) {
      const RidgeArm& arm = graph_.arms[a];
      const bool seen = std::any_of(ends.begin(), ends.end(), [&](const auto& e) { return e.first == a; });
      ends.emplace_back(a, arm.start == arm.end ? seen : arm.end == n);
    }
    return ends;
  }

  /// How far the fillets of a junction bend an arm: until the thickness has settled, at least the radius
  /// (section 4.3) as far as the arm has room.
  struct Reach {
    double length = 0;
    bool settled = false;  ///< the thickness has come to rest within it
  };

  bool is_leaf(const std::pair<Index, bool>& end) const {
    const SkeletonArm& arm = skeleton_.arms[end.first];
    return skeleton_.nodes[end.second ? arm.start : arm.end].arms.size() == 1;
  }

  Reach reach_of(const std::pair<Index, bool>& end, double radius) const {
    const auto& points = skeleton_.arms[end.first].points;
    const int n = int(points.size());
    const auto at = [&](int i) -> const MedialPoint& { return points[end.second ? n - 1 - i : i]; };
    std::vector<double> along{0};
    for (int i = 1; i < n; ++i) along.push_back(along.back() + distance(at(i - 1).point, at(i).point));
    const double most = std::min(3.5 * radius, (is_leaf(end) ? 0.75 : 0.45) * along.back());
    // Settled where it is near the thinnest and the next stretch does not get noticeably thinner.
    double thin = at(0).radius;
    for (int i = 0; i < n && along[i] <= most; ++i) thin = std::min(thin, at(i).radius);
    const double ahead = radius / 3;
    for (int i = 0; i < n && along[i] + ahead <= most; ++i) {
      double thinnest = at(i).radius;
      for (int k = i + 1; k < n && along[k] <= along[i] + ahead; ++k)
        thinnest = std::min(thinnest, at(k).radius);
      if (at(i).radius <= std::min(1.003 * thinnest, 1.02 * thin))
        return {std::min(std::max(radius, along[i] + 0.15 * radius), most), true};
    }
    return {most, false};
  }

  /// Normal of the sheet: mean over the feet of the arms' first medial points.
  Vec3 up_at(const std::vector<std::pair<Index, bool>>& ends) const {
    Vec3 sum;
    for (const auto& [a, at_end] : ends) {
      const auto& points = skeleton_.arms[a].points;
      for (const Foot& foot : (at_end ? points.back() : points.front()).feet)
        if (map_) sum += map_->normal(map_->locate(foot.point));
    }
    return normalized(sum);
  }

  /// Squares a T; the arms of any other junction are carried on straight to where they meet best.
  void straighten(Index n) {
    const auto ends = ends_at(n);
    RidgeNode& node = graph_.nodes[n];
    const PlanFrame frame(map_, node.point, up_at(ends));
    std::vector<Reached> reached;
    for (const auto& end : ends) {
      Polyline points = oriented(graph_.arms[end.first].points, end.second);
      if (points.size() < 2) return;
      for (Vec2& p : points) p = frame.to_plan(p);
      const Reach reach = reach_of(end, node.radius);
      reached.push_back(walk(points, reach.length, node.radius));
      reached.back().settled = reach.settled;
      reached.back().is_leaf = is_leaf(end);
    }
    carry_through(reached, node.radius);
    const Vec2 centre = frame.to_plan(node.point);
    auto target = reached.size() == 3 ? squared_position(reached) : std::nullopt;
    if (!target) target = best_meeting(reached, node.radius);
    if (!target || distance(*target, centre) > node.radius) return;
    node.point = frame.to_flat(*target, node.point);
    node.squared = true;
    for (size_t k = 0; k < ends.size(); ++k)
      replace_end(ends[k].first, ends[k].second, reached[k], *target, frame);
  }

  /// A stub that the fillets bend up to its cap has no straight part of its own: where a settled arm opposite
  /// points at its end, it is that arm carried on.
  void carry_through(std::vector<Reached>& reached, double radius) const {
    for (Reached& stub : reached) {
      if (stub.settled || !stub.is_leaf) continue;
      for (const Reached& through : reached) {
        const Vec2 direction = -through.beyond, to_end = stub.far_end - through.point;
        if (!through.settled || angle_between(through.beyond, stub.tangent) <= options_.straight_angle ||
            std::abs(cross(direction, to_end)) > stub_miss * radius)
          continue;
        stub.point = stub.far_end = through.point + direction * dot(direction, to_end);
        stub.tangent = direction;
        stub.kept = no_point_kept;
        break;
      }
    }
  }

  /// Point nearest to all the arms' lines (least squares); none where they miss it by a tenth of the radius.
  static std::optional<Vec2> best_meeting(const std::vector<Reached>& reached, double radius) {
    double xx = 0, xy = 0, yy = 0;
    Vec2 b{0, 0};
    for (const Reached& r : reached) {
      const Vec2 n = left_normal(r.tangent);
      xx += n.x * n.x;
      xy += n.x * n.y;
      yy += n.y * n.y;
      b += n * dot(n, r.point);
    }
    const double det = xx * yy - xy * xy;
    if (det < 0.05) return std::nullopt;
    const Vec2 at{(b.x * yy - b.y * xy) / det, (b.y * xx - b.x * xy) / det};
    for (const Reached& r : reached)
      if (std::abs(cross(r.tangent, at - r.point)) > 0.1 * radius) return std::nullopt;
    return at;
  }

  /// Conditions 1 and 2 of section 4.3; of several pairs the one with the largest angle.
  std::optional<Vec2> squared_position(const std::vector<Reached>& r) const {
    std::optional<Vec2> best;
    double best_angle = options_.straight_angle;
    for (int k = 0; k < 3; ++k) {
      const Reached &i = r[(k + 1) % 3], &j = r[(k + 2) % 3];
      const double angle = angle_between(i.tangent, j.tangent);
      if (angle <= best_angle) continue;
      const Vec2 to_i = i.point - r[k].point, to_j = j.point - r[k].point;
      if (angle_between(to_i, -r[k].tangent) >= angle_between(to_i, to_j)) continue;
      const auto at = intersection(r[k].point, r[k].tangent, i.point, j.point - i.point);
      if (!at) continue;
      best = at;
      best_angle = angle;
    }
    return best;
  }

  /// The arm's end up to the reached point becomes a straight line in plan, in eight pieces.
  void replace_end(Index a, bool at_end, const Reached& reached, Vec2 target, const PlanFrame& frame) {
    const Polyline points = oriented(graph_.arms[a].points, at_end);
    const bool whole = reached.kept >= points.size();
    Polyline cut{at_end ? graph_.nodes[graph_.arms[a].end].point : graph_.nodes[graph_.arms[a].start].point};
    const bool carried = reached.kept == no_point_kept;
    const Vec2 to = whole && !carried ? frame.to_plan(points.back()) : reached.point;
    for (int i = 1; i <= 8; ++i) cut.push_back(frame.to_flat(lerp(target, to, i / 8.0), cut.back()));
    carried_[a] = carried_[a] || carried;
    if (carried)
      graph_.nodes[at_end ? graph_.arms[a].start : graph_.arms[a].end].point = cut.back();
    else if (whole)
      cut.back() = points.back();
    for (size_t k = reached.kept; k < points.size(); ++k)
      if (distance(points[k], cut.back()) > 1e-6) cut.push_back(points[k]);
    graph_.arms[a].points = oriented(cut, at_end);
  }

  const Skeleton& skeleton_;
  const PlanarRegion& region_;
  const SurfaceMap* map_;
  RidgeOptions options_;
  RidgeGraph graph_;
  std::vector<bool> carried_;  ///< arms that are another one carried on
};

}  // namespace

RidgeGraph ridge_of(const Skeleton& skeleton, const PlanarRegion& region, const SurfaceMap* map,
                    const RidgeOptions& options) {
  return RidgeBuilder(skeleton, region, map, options).run();
}

}  // namespace beadmesh
