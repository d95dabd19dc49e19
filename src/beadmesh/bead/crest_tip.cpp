#include "beadmesh/bead/crest_tip.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "beadmesh/bead/plan_frame.h"

namespace beadmesh {
namespace {

constexpr double across_angle = radians(172);  ///< touching lines below it run askew
constexpr double window = 2.5;                 ///< how far behind the end is looked, in radii
constexpr double shortest_window = 0.6;        ///< what must be seen of the arm, in radii
constexpr double most_turn = 0.45;             ///< a parabola no longer follows what winds more
constexpr double steep_wall = radians(55);     ///< a place in plan says little of the place on such a wall
constexpr double most_detour = 1.1;            ///< over a place between its neighbours, on the way to the tip
constexpr int pieces = 12;                     ///< of the crest from there to the tip

/// Coordinates along and across the arm, in plan.
struct Course {
  double along = 0, aside = 0;
};

class CrestTipFinder {
 public:
  CrestTipFinder(const std::vector<MedialPoint>& arm, double radius, const PlanarRegion& region,
                 const SurfaceMap& map)
      : arm_(arm),
        radius_(radius),
        region_(region),
        map_(map),
        up_(up()),
        frame_(&map, arm.front().point, up_) {}

  std::optional<CrestTip> run() {
    if (!look_behind()) return std::nullopt;
    fit();
    if (std::abs(2 * bend_[2]) / radius_ * window > most_turn) return std::nullopt;
    CrestTip tip;
    tip.kept = seen_.front();
    if (!find_tip(tip)) return std::nullopt;
    carry_on(tip);
    return tip;
  }

 private:
  Vec3 up() const {
    Vec3 sum;
    double walked = 0;
    for (size_t i = 0; i < arm_.size() && walked < window * radius_; ++i) {
      for (const Foot& foot : arm_[i].feet) sum += map_.normal(map_.locate(foot.point));
      if (i) walked += distance(arm_[i - 1].point, arm_[i].point);
    }
    return normalized(sum);
  }

  /// The points behind the cap, not beyond the middle of the arm.
  bool look_behind() {
    double length = 0, walked = 0;
    for (size_t i = 1; i < arm_.size(); ++i) length += distance(arm_[i - 1].point, arm_[i].point);
    const double most = std::min(window * radius_, length / 2);
    for (size_t i = 0; i < arm_.size() && walked <= most; ++i) {
      if (arm_[i].subtended_angle >= across_angle) seen_.push_back(i), walked_.push_back(walked);
      if (i + 1 < arm_.size()) walked += distance(arm_[i].point, arm_[i + 1].point);
    }
    return seen_.size() >= 3 && walked_.back() - walked_.front() >= shortest_window * radius_ &&
           walked_.front() <= 1.5 * radius_;
  }

  Vec2 middle(size_t i) const {
    return lerp(frame_.to_plan(arm_[i].feet[0].point), frame_.to_plan(arm_[i].feet[1].point), 0.5);
  }

  double rise(size_t i) const {
    return frame_.height(arm_[i].point) -
           (frame_.height(arm_[i].feet[0].point) + frame_.height(arm_[i].feet[1].point)) / 2;
  }

  Course course_of(Vec2 plan) const {
    return {dot(plan - origin_, direction_), cross(direction_, plan - origin_)};
  }
  Vec2 plan_of(const Course& c) const {
    return origin_ + direction_ * c.along + left_normal(direction_) * c.aside;
  }

  /// A parabola through the middles of the touching lines, and the mean lean of the crest off it.
  void fit() {
    origin_ = middle(seen_.front());
    direction_ = normalized(origin_ - middle(seen_.back()));
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    double leaning = 0, heights = 0;
    for (const size_t i : seen_) {
      const Course m = course_of(middle(i));
      const Eigen::Vector3d row(1, m.along / radius_, m.along * m.along / (radius_ * radius_));
      a += row * row.transpose();
      b += row * m.aside;
      const double h = rise(i);
      leaning += (course_of(frame_.to_plan(arm_[i].point)).aside - m.aside) * h;
      heights += h * h;
    }
    const Eigen::Vector3d x = a.ldlt().solve(b);
    for (int k = 0; k < 3; ++k) bend_[k] = x[k];
    lean_ = heights > 0 ? leaning / heights : 0;
    end_of_bend_ = walked_.front();
  }

  /// Where the middle line runs: the parabola up to the end of the arm, then straight on.
  double middle_aside(double along) const {
    const double on_bend = std::min(along, end_of_bend_) / radius_;
    const double aside = bend_[0] + bend_[1] * on_bend + bend_[2] * on_bend * on_bend;
    return aside + (along / radius_ - on_bend) * (bend_[1] + 2 * bend_[2] * on_bend);
  }

  bool find_tip(CrestTip& tip) {
    tip.loop = arm_[seen_.front()].feet[0].loop;
    const auto& points = region_.loops[tip.loop].points;
    double position = 0, nearest = 4 * radius_;
    bool found = false;
    for (size_t i = 0; i < points.size(); ++i) {
      const Vec2 a = points[i], b = points[(i + 1) % points.size()];
      if (distance(a, arm_.front().point) < 4 * radius_) {
        const Course from = course_of(frame_.to_plan(a)), to = course_of(frame_.to_plan(b));
        const double off_a = from.aside - middle_aside(from.along), off_b = to.aside - middle_aside(to.along);
        if ((off_a < 0) != (off_b < 0)) {
          const double t = off_a / (off_a - off_b), along = from.along + t * (to.along - from.along);
          if (along > 0 && along < nearest) {
            nearest = along;
            tip.point = lerp(a, b, t);
            tip.position = position + t * distance(a, b);
            found = true;
          }
        }
      }
      position += distance(a, b);
    }
    return found;
  }

  void carry_on(CrestTip& tip) const {
    const size_t start = seen_.front();
    const double foot = frame_.height(arm_[start].point) - rise(start), tip_height = frame_.height(tip.point);
    const double reach = course_of(frame_.to_plan(tip.point)).along;
    Vec2 guess = arm_[start].point, last = guess;
    for (int k = 1; k < pieces; ++k) {
      const double share = double(k) / pieces, along = reach * share;
      for (int round = 0; round < 4; ++round) {
        const double h = frame_.height(guess) - (foot + (tip_height - foot) * share);
        guess = frame_.to_flat(plan_of({along, middle_aside(along) + lean_ * h}), guess);
      }
      const double left = distance(last, tip.point), then = distance(guess, tip.point);
      if (then >= left || distance(last, guess) + then > most_detour * left || is_steep_between(last, guess))
        return down_the_wall(tip, start);
      last = guess;
      tip.crest.push_back(guess);
    }
  }

  bool is_steep_between(Vec2 a, Vec2 b) const {
    for (const double t : {0.25, 0.5, 0.75, 1.0})
      if (angle_between(map_.normal(map_.locate(lerp(a, b, t))), up_) > steep_wall) return true;
    return false;
  }

  /// Straight on the unrolled wall, from where it begins.
  void down_the_wall(CrestTip& tip, size_t start) const {
    const Vec2 from = tip.crest.empty() ? arm_[start].point : tip.crest.back();
    const int left = pieces - int(tip.crest.size());
    for (int k = 1; k < left; ++k) tip.crest.push_back(lerp(from, tip.point, double(k) / left));
  }

  const std::vector<MedialPoint>& arm_;
  double radius_;
  const PlanarRegion& region_;
  const SurfaceMap& map_;
  Vec3 up_;
  PlanFrame frame_;
  std::vector<size_t> seen_;
  std::vector<double> walked_;
  Vec2 origin_, direction_;
  double bend_[3] = {0, 0, 0};  ///< of the middle line, mm; lengths along it in radii
  double lean_ = 0;             ///< of the crest: aside per height
  double end_of_bend_ = 0;
};

}  // namespace

std::optional<CrestTip> crest_tip(const std::vector<MedialPoint>& arm, double radius,
                                  const PlanarRegion& region, const SurfaceMap& map) {
  if (arm.size() < 3 || radius <= 0) return std::nullopt;
  return CrestTipFinder(arm, radius, region, map).run();
}

}  // namespace beadmesh
