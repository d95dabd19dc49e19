#include "beadmesh/delaunay/constrained_net.h"

#include <optional>

#include "beadmesh/delaunay/constraints.h"
#include "beadmesh/delaunay/divide_and_conquer.h"

namespace beadmesh::delaunay {
namespace {

// Marks the edges of the loops in a Delaunay triangulation, and inserts those that are missing.
class LoopMarker {
 public:
  explicit LoopMarker(ConstrainedNet& result) : result_(result), net_(result.net) {}
  std::optional<NetConflict> run(const std::vector<std::vector<Index>>& loops);

 private:
  struct LoopEdge {
    Index from, to;  // points of the net
  };

  void collect(const std::vector<std::vector<Index>>& loops);
  std::optional<NetConflict> mark_present();
  std::optional<NetConflict> insert_missing();
  std::optional<NetConflict> mark(Index e, Index place);
  NetConflict conflict(const InsertionConflict& found, const LoopEdge& edge) const;
  Index input(Index point) const { return point == no_index ? no_index : result_.input[point]; }

  ConstrainedNet& result_;
  EdgeNet& net_;
  std::vector<LoopEdge> edges_;  // of all loops, loop by loop
  std::vector<Index> place_;     // per point: the place in edges_ of the first loop edge from it
  std::vector<Index> spokes_;    // per point: an edge from it
};

std::optional<NetConflict> LoopMarker::run(const std::vector<std::vector<Index>>& loops) {
  result_.is_constraint.assign(net_.size() / 2, 0);
  collect(loops);
  if (const auto conflict = mark_present()) return conflict;
  return insert_missing();
}

void LoopMarker::collect(const std::vector<std::vector<Index>>& loops) {
  std::vector<Index> point_of_input(net_.points.size());
  for (std::size_t i = 0; i < result_.input.size(); ++i)
    point_of_input[result_.input[i]] = static_cast<Index>(i);
  std::size_t count = 0;
  for (const auto& loop : loops) count += loop.size();
  edges_.reserve(count);
  place_.assign(net_.points.size(), no_index);
  for (const auto& loop : loops) {
    if (loop.empty()) continue;
    Index from = point_of_input[loop.front()];
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index to = point_of_input[loop[i + 1 < loop.size() ? i + 1 : 0]];
      if (place_[from] == no_index) place_[from] = static_cast<Index>(edges_.size());
      edges_.push_back({from, to});
      from = to;
    }
  }
  result_.loop_edges.assign(edges_.size(), no_index);
}

// Most loop edges are Delaunay already; one pass in memory order finds them without a search around points.
std::optional<NetConflict> LoopMarker::mark_present() {
  spokes_.assign(net_.points.size(), no_index);
  for (Index e = 0; e < net_.size(); ++e) {
    if (!net_.is_alive(e)) continue;
    const Index from = net_.origin(e);
    spokes_[from] = e;
    const Index place = place_[from];
    if (place == no_index || edges_[place].to != net_.destination(e)) continue;
    if (const auto conflict = mark(e, place)) return conflict;
  }
  return {};
}

std::optional<NetConflict> LoopMarker::insert_missing() {
  ConstraintInserter inserter(net_, result_.is_constraint, spokes_);
  for (Index place = 0; place < static_cast<Index>(edges_.size()); ++place) {
    if (result_.loop_edges[place] != no_index) continue;
    const LoopEdge edge = edges_[place];
    if (edge.from == edge.to)
      return NetConflict{NetConflict::Kind::repeated_edge, input(edge.from), input(edge.to)};
    Index e = inserter.find(edge.from, edge.to);
    if (e == no_index)
      if (const auto found = inserter.insert(edge.from, edge.to, e)) return conflict(found, edge);
    if (const auto repeated = mark(e, place)) return repeated;
  }
  return {};
}

std::optional<NetConflict> LoopMarker::mark(Index e, Index place) {
  char& mark = result_.is_constraint[e / 2];
  if (mark)
    return NetConflict{NetConflict::Kind::repeated_edge, input(edges_[place].from), input(edges_[place].to)};
  mark = e & 1 ? ConstrainedNet::along_odd : ConstrainedNet::along_even;
  result_.loop_edges[place] = e;
  return {};
}

NetConflict LoopMarker::conflict(const InsertionConflict& found, const LoopEdge& edge) const {
  const bool crossing = found.kind == InsertionConflict::Kind::crossing;
  return {crossing ? NetConflict::Kind::crossing : NetConflict::Kind::point_on_edge, input(edge.from),
          input(edge.to), input(found.point), input(found.other)};
}

}  // namespace

tl::expected<ConstrainedNet, NetConflict> constrained_net(const std::vector<Vec2>& points,
                                                          const std::vector<std::vector<Index>>& loops) {
  ConstrainedNet result;
  PointOrder order = put_points(points, result.net);
  if (!order.duplicates.empty()) {
    const auto [a, b] = order.duplicates.front();
    return tl::unexpected(NetConflict{NetConflict::Kind::duplicate, a, b});
  }
  result.input = std::move(order.input);
  result.outside = connect_delaunay(result.net);
  if (const auto conflict = LoopMarker(result).run(loops)) return tl::unexpected(*conflict);
  return result;
}

}  // namespace beadmesh::delaunay
