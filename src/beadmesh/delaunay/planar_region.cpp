#include "beadmesh/delaunay/planar_region.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "beadmesh/delaunay/constrained_net.h"
#include "beadmesh/geometry/predicates.h"

namespace beadmesh {
namespace {

using delaunay::ConstrainedNet;
using delaunay::EdgeNet;
using delaunay::NetConflict;

std::string loop_name(std::size_t loop) {
  return fmt::format("loop {}", loop + 1);
}

Failure region_failure(const char* what, std::size_t loop, std::string message, std::string hint = {}) {
  return fail(fmt::format("delaunay.region.{}", what), std::move(message), std::move(hint), loop_name(loop));
}

// How errors call points.
class Names {
 public:
  Names(const PlanarRegion& region, const PointName& name) : region_(region), name_(name) {}
  /// Without its coordinates.
  std::string bare(std::size_t loop, std::size_t point) const {
    return name_ ? name_(loop, point) : fmt::format("point {} of {}", point + 1, loop_name(loop));
  }
  std::string operator()(std::size_t loop, std::size_t point) const {
    const Vec2 p = region_.loops[loop].points[point];
    return fmt::format("{} ({}, {})", bare(loop, point), p.x, p.y);
  }

 private:
  const PlanarRegion& region_;
  const PointName& name_;
};

bool is_collinear(const std::vector<Vec2>& points) {
  const Vec2 a = points.front();
  const auto b = std::find_if(points.begin(), points.end(), [&](Vec2 p) { return !(p == a); });
  if (b == points.end()) return true;
  return std::all_of(points.begin(), points.end(), [&](Vec2 p) { return orient2d(a, *b, p) == 0; });
}

Result<void> check_loop(const PlanarLoop& loop, std::size_t l, const Names& name) {
  const auto& points = loop.points;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_in_exact_range(points[i]))
      return region_failure("not_finite", l, name(l, i) + " is not finite or out of range",
                            "a coordinate must be 0 or of a magnitude between 1e-60 and 1e60");
  if (points.size() < 3)
    return region_failure(
        "few_points", l,
        fmt::format("{} point{}, at least 3 are needed", points.size(), points.size() == 1 ? "" : "s"));
  const auto fits = [&](std::size_t entries) { return entries == 0 || entries == points.size(); };
  if (!fits(loop.corner.size()) || !fits(loop.curve.size()) || loop.parameters.size() != loop.curve.size())
    return region_failure(
        "attributes", l,
        fmt::format("{} points, but {} corner, {} curve and {} parameter entries", points.size(),
                    loop.corner.size(), loop.curve.size(), loop.parameters.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i] == points[(i + 1) % points.size()])
      return region_failure("repeated_point", l,
                            fmt::format("{} and {} are equal, and follow each other", name.bare(l, i),
                                        name(l, (i + 1) % points.size())));
  if (is_collinear(points))
    return region_failure("zero_area", l, "all points are on one line; the first is " + name(l, 0));
  return {};
}

// Every segment's curve must exist and run from its one end to its other.
Result<void> check_curves(const PlanarRegion& region, std::size_t l, double tolerance) {
  const PlanarLoop& loop = region.loops[l];
  for (std::size_t i = 0; i < loop.curve.size(); ++i) {
    if (loop.curve[i] == no_index) continue;
    const auto id = static_cast<std::size_t>(loop.curve[i]);
    if (loop.curve[i] < 0 || id >= region.curves.size() || !region.curves[id])
      return region_failure(
          "attributes", l,
          fmt::format("segment {} lies on curve {}, which does not exist", i + 1, loop.curve[i]));
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      const std::size_t at = (i + end) % loop.points.size();
      const Vec2 on_curve = region.curves[id]->at(loop.parameters[i][end]).point;
      if (!(distance(on_curve, loop.points[at]) <= tolerance))
        return region_failure("attributes", l,
                              fmt::format("the curve of segment {} passes point {} at a distance of {}",
                                          i + 1, at + 1, distance(on_curve, loop.points[at])));
    }
  }
  return {};
}

Result<void> check_loops(const PlanarRegion& region, const Names& name) {
  if (region.loops.empty()) return fail("delaunay.region.empty", "the region has no loop");
  const double tolerance = 1e-6 * diagonal(region);
  for (std::size_t l = 0; l < region.loops.size(); ++l) {
    if (auto checked = check_loop(region.loops[l], l, name); !checked) return checked;
    if (auto checked = check_curves(region, l, tolerance); !checked) return checked;
  }
  return {};
}

// All points in one array, and the way back to the loops.
struct FlatLoops {
  std::vector<Vec2> points;
  std::vector<std::vector<Index>> loops;
  std::vector<Index> first;  // per loop; one more at the end

  explicit FlatLoops(const PlanarRegion& region) {
    for (const PlanarLoop& loop : region.loops) {
      first.push_back(static_cast<Index>(points.size()));
      points.insert(points.end(), loop.points.begin(), loop.points.end());
      auto& indices = loops.emplace_back(loop.points.size());
      for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = first.back() + static_cast<Index>(i);
    }
    first.push_back(static_cast<Index>(points.size()));
  }
  std::size_t loop_of(Index i) const {
    return std::upper_bound(first.begin(), first.end(), i) - first.begin() - 1;
  }
};

Failure conflict_failure(const NetConflict& conflict, const FlatLoops& flat, const Names& names) {
  const auto name = [&](Index i) {
    const std::size_t l = flat.loop_of(i);
    return names(l, static_cast<std::size_t>(i - flat.first[l]));
  };
  const auto segment = [&](Index a, Index b) {
    return fmt::format("the segment from {} to {}", name(a), name(b));
  };
  if (conflict.kind == NetConflict::Kind::crossing)
    return region_failure("crossing", flat.loop_of(conflict.a),
                          segment(conflict.a, conflict.b) + " crosses " + segment(conflict.c, conflict.d));
  if (conflict.kind == NetConflict::Kind::point_on_edge)
    return region_failure("touching", flat.loop_of(conflict.c),
                          name(conflict.c) + " lies on " + segment(conflict.a, conflict.b));
  return region_failure("touching", flat.loop_of(conflict.b),
                        name(conflict.b) + " is also " + name(conflict.a));
}

// How many loops are around each loop: the triangles are flooded from the outside, one layer after the other.
class LoopDepths {
 public:
  LoopDepths(ConstrainedNet& constrained, const FlatLoops& flat)
      : constrained_(constrained), net_(constrained.net), depth_(flat.loops.size(), no_index) {
    loop_of_edge_.assign(constrained.is_constraint.size(), no_index);
    for (std::size_t l = 0, i = 0; l < flat.loops.size(); ++l)
      for (std::size_t k = 0; k < flat.loops[l].size(); ++k)
        loop_of_edge_[constrained.loop_edges[i++] / 2] = l;
  }

  std::vector<Index> run() {
    std::vector<Index> layer = outside_layer();
    for (Index depth = 0; !layer.empty(); ++depth) {
      next_layer_.clear();
      for (const Index e : layer) enter(e, depth);
      layer.swap(next_layer_);
    }
    return depth_;
  }

 private:
  std::vector<Index> outside_layer() {
    std::vector<Index> edges;
    Index e = constrained_.outside;
    do {
      net_.face(e) = 0;
      edges.push_back(e);
      e = net_.next_of_face(e);
    } while (e != constrained_.outside);
    return edges;
  }
  // The face on the left of e belongs to the layer; goes on from there.
  void enter(Index e, Index depth);
  void pass(Index e, Index depth);

  ConstrainedNet& constrained_;
  EdgeNet& net_;
  std::vector<Index> depth_;
  std::vector<Index> loop_of_edge_;  // per undirected edge
  std::vector<Index> next_layer_, stack_;
};

void LoopDepths::enter(Index e, Index depth) {
  stack_.clear();
  if (depth == 0)
    pass(e, depth);  // the outside is no triangle: each edge of the hull comes on its own
  else
    stack_.push_back(e);
  while (!stack_.empty()) {
    Index side = stack_.back();
    stack_.pop_back();
    if (net_.face(side) != no_index) continue;
    for (int k = 0; k < 3; ++k, side = net_.next_of_face(side)) net_.face(side) = depth;
    for (int k = 0; k < 3; ++k, side = net_.next_of_face(side)) pass(side, depth);
  }
}

void LoopDepths::pass(Index e, Index depth) {
  if (net_.face(e ^ 1) != no_index) return;
  if (!constrained_.is_constrained(e)) {
    stack_.push_back(e ^ 1);
    return;
  }
  depth_[loop_of_edge_[e / 2]] = depth;
  next_layer_.push_back(e ^ 1);
}

// Exact for a loop that does not cross itself: the turn at its lowest leftmost point.
bool is_counter_clockwise(const std::vector<Vec2>& points) {
  const auto lowest = std::min_element(points.begin(), points.end(),
                                       [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  const std::size_t n = points.size(), i = lowest - points.begin();
  return orient2d(points[(i + n - 1) % n], points[i], points[(i + 1) % n]) > 0;
}

// The first point stays the first.
void reverse_loop(PlanarLoop& loop) {
  std::reverse(loop.points.begin() + 1, loop.points.end());
  if (!loop.corner.empty()) std::reverse(loop.corner.begin() + 1, loop.corner.end());
  std::reverse(loop.curve.begin(), loop.curve.end());
  std::reverse(loop.parameters.begin(), loop.parameters.end());
  for (std::array<double, 2>& ends : loop.parameters) std::swap(ends[0], ends[1]);
}

Result<std::size_t> outer_loop(const PlanarRegion& region, const std::vector<Index>& depth,
                               const Names& name) {
  const auto area = [&](std::size_t l) { return std::abs(signed_area(region.loops[l])); };
  std::size_t outer = region.loops.size();
  for (std::size_t l = 0; l < depth.size(); ++l)
    if (depth[l] == 0 && (outer == region.loops.size() || area(l) > area(outer))) outer = l;
  for (std::size_t l = 0; l < depth.size(); ++l) {
    if (depth[l] == 0 && l != outer)
      return region_failure("outside", l,
                            fmt::format("it lies outside of the outer loop, {}; its first point is {}",
                                        loop_name(outer), name(l, 0)));
    if (depth[l] > 1)
      return region_failure("nested", l, "it lies inside of a hole; its first point is " + name(l, 0));
  }
  return outer;
}

}  // namespace

bool contains(const PlanarRegion& region, Vec2 point) {
  bool inside = false;
  for (const PlanarLoop& loop : region.loops)
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const Vec2 a = loop.points[i], b = loop.points[i + 1 < loop.points.size() ? i + 1 : 0];
      if ((a.y > point.y) != (b.y > point.y)) inside ^= (orient2d(a, b, point) > 0) == (b.y > a.y);
    }
  return inside;
}

double signed_area(const PlanarLoop& loop) {
  double twice = 0;
  const auto& p = loop.points;
  for (std::size_t i = 1; i + 1 < p.size(); ++i) twice += cross(p[i] - p[0], p[i + 1] - p[0]);
  return twice / 2;
}

double diagonal(const PlanarRegion& region) {
  bool any = false;
  Vec2 low, high;
  for (const PlanarLoop& loop : region.loops)
    for (const Vec2 p : loop.points) {
      if (!std::exchange(any, true)) low = high = p;
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  return distance(low, high);
}

Result<PlanarRegion> checked_region(PlanarRegion region) {
  return checked_region(std::move(region), {});
}

Result<PlanarRegion> checked_region(PlanarRegion region, const PointName& point_name) {
  const Names name(region, point_name);
  if (auto checked = check_loops(region, name); !checked) return Failure(checked.error());
  const FlatLoops flat(region);
  auto net = delaunay::constrained_net(flat.points, flat.loops);
  if (!net) return conflict_failure(net.error(), flat, name);
  const auto outer = outer_loop(region, LoopDepths(*net, flat).run(), name);
  if (!outer) return Failure(outer.error());
  std::rotate(region.loops.begin(), region.loops.begin() + *outer, region.loops.begin() + *outer + 1);
  for (std::size_t l = 0; l < region.loops.size(); ++l)
    if (is_counter_clockwise(region.loops[l].points) != (l == 0)) reverse_loop(region.loops[l]);
  return region;
}

}  // namespace beadmesh
