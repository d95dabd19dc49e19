#include "beadmesh/delaunay/constraints.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "beadmesh/geometry/predicates.h"

namespace beadmesh::delaunay {
namespace {

constexpr Index long_chain = 64;  // edges from which on a search tree pays

}  // namespace

Index ConstraintInserter::find(Index a, Index b) const {
  const Index start = spokes_[a];
  Index e = start;
  do {
    if (net_.destination(e) == b) return e;
    e = net_.next_around(e);
  } while (e != start);
  return no_index;
}

// The edge opposite a in the triangle at a through which the way to b goes; a's triangle is on its left.
InsertionConflict ConstraintInserter::first_crossed(Index a, Index b, Index& crossed) const {
  Index spoke = spokes_[a];
  const Vec2 pa = net_.from(spoke), pb = net_.points[b];
  double side = orient2d(pa, pb, net_.to(spoke));
  const Index start = spoke;
  do {
    const Index next = net_.next_around(spoke);
    const double next_side = orient2d(pa, pb, net_.to(next));
    if (side == 0 && dot(net_.to(spoke) - pa, pb - pa) > 0)
      return {InsertionConflict::Kind::point_on_edge, net_.destination(spoke), no_index};
    if (side < 0 && next_side > 0 && orient2d(pa, net_.to(spoke), net_.to(next)) > 0) {
      crossed = net_.next_of_face(spoke);
      return {};
    }
    spoke = next;
    side = next_side;
  } while (spoke != start);
  crossed = no_index;
  return {};
}

// Collects the crossed edges and both chains of the cavity; the left one is collected backwards and turned
// round.
InsertionConflict ConstraintInserter::walk(Index a, Index b, Index crossed) {
  const Vec2 pa = net_.points[a], pb = net_.points[b];
  crossed_.clear();
  left_.assign(1, net_.next_of_face(crossed));
  right_.assign(1, net_.next_of_face(left_.front()));
  for (;;) {
    if (is_constraint_[crossed / 2])
      return {InsertionConflict::Kind::crossing, net_.origin(crossed), net_.destination(crossed)};
    crossed_.push_back(crossed);
    // On the far side of the crossed edge: from its left end back to its right end, then over the apex.
    const Index right_side = net_.next_of_face(crossed ^ 1), left_side = net_.next_of_face(right_side);
    const Index apex = net_.destination(right_side);
    if (apex == b) {
      right_.push_back(right_side);
      left_.push_back(left_side);
      break;
    }
    const double side = orient2d(pa, pb, net_.points[apex]);
    if (side == 0) return {InsertionConflict::Kind::point_on_edge, apex, no_index};
    (side > 0 ? left_ : right_).push_back(side > 0 ? left_side : right_side);
    crossed = side > 0 ? right_side : left_side;
  }
  std::reverse(left_.begin(), left_.end());
  return {};
}

// The chain's edge at whose end the Delaunay triangle over the base has its third corner. Points that are not
// above the base (the chain may pass a point twice) do not count.
Index ConstraintInserter::apex(const Polygon& polygon, const std::vector<Index>& chain) const {
  const Vec2 a = net_.from(polygon.base), b = net_.to(polygon.base);
  if (polygon.last - polygon.first >= long_chain) return chain_apex_.find(a, b, polygon.first, polygon.last);
  Index best = no_index;
  for (Index i = polygon.first; i < polygon.last; ++i) {
    const Vec2 p = net_.to(chain[i]);
    if (best != no_index && incircle(a, b, net_.to(chain[best]), p) <= 0) continue;
    if (orient2d(a, b, p) > 0) best = i;
  }
  return best;
}

// Triangulates the face on the left of the base, whose other edges are the chain.
void ConstraintInserter::fill(Index base, const std::vector<Index>& chain) {
  if (chain.size() > long_chain) {
    std::vector<Vec2> points;
    for (const Index e : chain) points.push_back(net_.to(e));
    chain_apex_.reset(net_.from(base), net_.to(base), std::move(points));
  }
  pending_.assign(1, {base, 0, static_cast<Index>(chain.size()) - 1});
  while (!pending_.empty()) {
    const Polygon polygon = pending_.back();
    pending_.pop_back();
    if (polygon.last - polygon.first < 2) continue;
    const Index middle = apex(polygon, chain);
    if (middle > polygon.first) {
      const Index e = net_.connect(chain[middle], chain[polygon.first]);
      pending_.push_back({e, polygon.first, middle});
    }
    if (middle + 1 < polygon.last) {
      const Index e = net_.connect(chain[polygon.last], chain[middle + 1]);
      pending_.push_back({e, middle + 1, polygon.last});
    }
  }
}

InsertionConflict ConstraintInserter::insert(Index a, Index b, Index& inserted) {
  Index crossed;
  if (const auto conflict = first_crossed(a, b, crossed)) return conflict;
  if (const auto conflict = walk(a, b, crossed)) return conflict;
  for (const Index e : crossed_) net_.remove(e);
  for (const auto* chain : {&left_, &right_})
    for (const Index e : *chain) spokes_[net_.origin(e)] = e;
  inserted = net_.connect(left_.back(), left_.front());
  fill(inserted, left_);
  fill(inserted ^ 1, right_);
  return {};
}

}  // namespace beadmesh::delaunay
