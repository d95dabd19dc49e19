#include "beadmesh/read/facet_bulges.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "beadmesh/geometry/predicates.h"

namespace beadmesh::read {
namespace {

constexpr double tangent_angle = radians(0.01);

// A straight segment, or the bulge of a facet as a triangle.
struct Element {
  SegmentName name;
  Vec2 start, end, apex;  // a straight one: the apex is the start
  bool is_bulge = false;
  double low = 0, high = 0;  // along x
};

Element element_of(const PlanarRegion& region, SegmentName name) {
  const PlanarLoop& loop = region.loops[name.loop];
  const std::size_t i = name.segment;
  Element element{name, loop.points[i], loop.points[(i + 1) % loop.points.size()], loop.points[i], false, 0,
                  0};
  if (loop.curve[i] != no_index) {
    const PlanarCurve& curve = *region.curves[loop.curve[i]];
    const Vec2 out = curve.at(loop.parameters[i][0]).velocity, in = curve.at(loop.parameters[i][1]).velocity;
    const double turn = cross(out, in);
    if (turn != 0) {
      element.apex = element.start + out * (cross(element.end - element.start, in) / turn);
      element.is_bulge = true;
    }
  }
  element.low = std::min({element.start.x, element.end.x, element.apex.x});
  element.high = std::max({element.start.x, element.end.x, element.apex.x});
  return element;
}

bool contains(const Element& triangle, Vec2 p) {
  const double a = orient2d(triangle.start, triangle.end, p), b = orient2d(triangle.end, triangle.apex, p),
               c = orient2d(triangle.apex, triangle.start, p);
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

bool meet(const Element& a, const Element& b) {
  const auto sides = [](const Element& e) {
    return std::array<std::array<Vec2, 2>, 3>{{{e.start, e.end}, {e.end, e.apex}, {e.apex, e.start}}};
  };
  const std::size_t na = a.is_bulge ? 3 : 1, nb = b.is_bulge ? 3 : 1;
  for (std::size_t i = 0; i < na; ++i)
    for (std::size_t k = 0; k < nb; ++k) {
      const auto p = sides(a)[i], q = sides(b)[k];
      if (segments_intersect(p[0], p[1], q[0], q[1])) return true;
    }
  return (a.is_bulge && contains(a, b.start)) || (b.is_bulge && contains(b, a.start));
}

// Directions in which an element leaves its joint: along its tangent and along its chord.
std::array<Vec2, 2> leaving(const Element& element, bool at_start) {
  const Vec2 from = at_start ? element.start : element.end, to = at_start ? element.end : element.start;
  return {element.is_bulge ? element.apex - from : to - from, to - from};
}

// Neighbours: whether the angles in which they leave the joint overlap, other than by being tangent.
bool meet_beside_joint(const Element& before, const Element& after) {
  const std::array<Vec2, 2> a = leaving(before, false), b = leaving(after, true);
  if (angle_between(a[0], b[0]) <= tangent_angle) return false;
  const auto angle = [&](Vec2 v) { return std::atan2(cross(a[0], v), dot(a[0], v)); };
  const double other[] = {angle(b[0]), angle(b[0]) + std::atan2(cross(b[0], b[1]), dot(b[0], b[1]))};
  const double end = angle(a[1]);
  return std::max(std::min(0.0, end), std::min(other[0], other[1])) <=
         std::min(std::max(0.0, end), std::max(other[0], other[1]));
}

class BulgeSweep {
 public:
  explicit BulgeSweep(const PlanarRegion& region) : region_(region) {
    for (std::size_t l = 0; l < region.loops.size(); ++l)
      for (std::size_t i = 0; i < region.loops[l].points.size(); ++i)
        elements_.push_back(element_of(region, {l, i}));
    std::stable_sort(elements_.begin(), elements_.end(),
                     [](const Element& a, const Element& b) { return a.low < b.low; });
  }

  std::vector<BulgeConflict> run() {
    for (std::size_t i = 0; i < elements_.size(); ++i)
      for (std::size_t k = i + 1; k < elements_.size() && elements_[k].low <= elements_[i].high; ++k)
        if (elements_[i].is_bulge || elements_[k].is_bulge) compare(elements_[i], elements_[k]);
    return std::move(conflicts_);
  }

 private:
  void compare(const Element& a, const Element& b) {
    const bool ahead = follows(a, b), behind = follows(b, a);
    const bool conflict = !ahead && !behind
                              ? meet(a, b)
                              : (ahead && meet_beside_joint(a, b)) || (behind && meet_beside_joint(b, a));
    if (conflict)
      conflicts_.push_back(a.is_bulge ? BulgeConflict{a.name, b.name} : BulgeConflict{b.name, a.name});
  }
  // Whether b comes after a in their loop.
  bool follows(const Element& a, const Element& b) const {
    return a.name.loop == b.name.loop &&
           (a.name.segment + 1) % region_.loops[a.name.loop].points.size() == b.name.segment;
  }

  const PlanarRegion& region_;
  std::vector<Element> elements_;
  std::vector<BulgeConflict> conflicts_;
};

}  // namespace

std::vector<BulgeConflict> bulge_conflicts(const PlanarRegion& region) {
  return BulgeSweep(region).run();
}

}  // namespace beadmesh::read
