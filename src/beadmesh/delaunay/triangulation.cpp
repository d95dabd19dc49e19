#include "beadmesh/delaunay/triangulation.h"

#include <fmt/format.h>

#include "beadmesh/delaunay/constrained_net.h"
#include "beadmesh/geometry/predicates.h"

namespace beadmesh {
namespace {

using delaunay::ConstrainedNet;
using delaunay::EdgeNet;
using delaunay::NetConflict;

std::string named(Index i, const std::vector<Vec2>& points) {
  return fmt::format("point {} ({}, {})", i, points[i].x, points[i].y);
}

Failure failure(const NetConflict& conflict, const std::vector<Vec2>& points) {
  const auto entity = fmt::format("point {}", conflict.c == no_index ? conflict.a : conflict.c);
  const auto name = [&](Index i) { return named(i, points); };
  switch (conflict.kind) {
    case NetConflict::Kind::duplicate:
      return fail("delaunay.duplicate", fmt::format("{} equals point {}", name(conflict.a), conflict.b), {},
                  entity);
    case NetConflict::Kind::point_on_edge:
      return fail("delaunay.point_on_edge",
                  fmt::format("{} lies on the edge from {} to {}", name(conflict.c), name(conflict.a),
                              name(conflict.b)),
                  {}, entity);
    case NetConflict::Kind::crossing:
      return fail("delaunay.crossing",
                  fmt::format("the edge from {} to {} crosses the edge from {} to {}", name(conflict.a),
                              name(conflict.b), name(conflict.c), name(conflict.d)),
                  {}, entity);
    case NetConflict::Kind::repeated_edge:
      break;
  }
  return fail("delaunay.repeated_edge",
              fmt::format("the edge from {} to {} occurs twice", name(conflict.a), name(conflict.b)), {},
              entity);
}

Result<void> check_input(const std::vector<Vec2>& points, const std::vector<std::vector<Index>>& loops) {
  if (points.size() < 3)
    return fail("delaunay.too_few_points", fmt::format("{} points, at least 3 are needed", points.size()));
  if (points.size() > 100'000'000)
    return fail("delaunay.too_many_points",
                fmt::format("{} points, at most 1e8 are supported", points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!is_in_exact_range(points[i]))
      return fail("delaunay.range",
                  fmt::format("{} has a coordinate that is not finite or out of range", named(i, points)), {},
                  fmt::format("point {}", i));
  if (loops.empty()) return fail("delaunay.no_loops", "there is no loop that bounds the region");
  for (std::size_t l = 0; l < loops.size(); ++l) {
    if (loops[l].size() < 3)
      return fail("delaunay.short_loop",
                  fmt::format("loop {} has {} points, at least 3 are needed", l, loops[l].size()), {},
                  fmt::format("loop {}", l));
    for (const Index i : loops[l])
      if (i < 0 || i >= static_cast<Index>(points.size()))
        return fail("delaunay.bad_index", fmt::format("loop {} names point {}, which does not exist", l, i),
                    {}, fmt::format("loop {}", l));
  }
  return {};
}

// Spreads from the left side of the loops' edges over the triangles inside and writes them out.
class InsideFlood {
 public:
  explicit InsideFlood(ConstrainedNet& constrained) : constrained_(constrained), net_(constrained.net) {
    mark_outside();
    first_edge_.reserve(net_.points.size());
  }

  // False where a loop is passed from its outside: one runs the wrong way round.
  bool run() {
    for (const Index e : constrained_.loop_edges) {
      if (net_.face(e) == outside) return failed(e);
      if (net_.face(e) != no_index) continue;
      stack_.assign(1, e);
      while (!stack_.empty()) {
        const Index next = stack_.back();
        stack_.pop_back();
        if (net_.face(next) == no_index && !visit(next)) return false;
      }
    }
    return true;
  }

  Triangulation result(const std::vector<Vec2>& points) const;
  Index bad_edge() const { return bad_edge_; }

 private:
  static constexpr Index outside = -2;

  void mark_outside() {
    Index e = constrained_.outside;
    do {
      net_.face(e) = outside;
      e = net_.next_of_face(e);
    } while (e != constrained_.outside);
  }
  bool visit(Index e);
  bool failed(Index e) {
    bad_edge_ = e;
    return false;
  }

  ConstrainedNet& constrained_;
  EdgeNet& net_;
  std::vector<Index> first_edge_;  // per triangle: its edge from corner 0 to corner 1
  std::vector<Index> stack_;
  Index bad_edge_ = no_index;
};

bool InsideFlood::visit(Index e) {
  const auto triangle = static_cast<Index>(first_edge_.size());
  first_edge_.push_back(e);
  for (int k = 0; k < 3; ++k, e = net_.next_of_face(e)) {
    net_.face(e) = triangle;
    if (constrained_.is_constrained(e)) {
      if (!constrained_.is_along_loop(e)) return failed(e);
      continue;
    }
    const Index beyond = net_.face(e ^ 1);
    if (beyond == outside) return failed(e);
    if (beyond == no_index) stack_.push_back(e ^ 1);
  }
  return true;
}

Triangulation InsideFlood::result(const std::vector<Vec2>& points) const {
  Triangulation result;
  result.points = points;
  result.triangles.resize(first_edge_.size());
  result.neighbours.resize(first_edge_.size());
  for (std::size_t t = 0; t < first_edge_.size(); ++t) {
    Index e = first_edge_[t];
    for (int k = 0; k < 3; ++k, e = net_.next_of_face(e)) {
      result.triangles[t][k] = constrained_.input[net_.origin(e)];
      result.neighbours[t][(k + 2) % 3] = constrained_.is_constrained(e) ? no_index : net_.face(e ^ 1);
    }
  }
  return result;
}

}  // namespace

Result<Triangulation> triangulate(const std::vector<Vec2>& points,
                                  const std::vector<std::vector<Index>>& loops) {
  if (auto checked = check_input(points, loops); !checked) return Failure(checked.error());
  auto constrained = delaunay::constrained_net(points, loops);
  if (!constrained) return failure(constrained.error(), points);
  InsideFlood flood(*constrained);
  if (!flood.run()) {
    const Index i = constrained->input[constrained->net.origin(flood.bad_edge())];
    return fail("delaunay.orientation",
                fmt::format("the loops do not bound a region on their left at {}", named(i, points)),
                "outer loops run counter-clockwise, holes clockwise", fmt::format("point {}", i));
  }
  return flood.result(points);
}

}  // namespace beadmesh
