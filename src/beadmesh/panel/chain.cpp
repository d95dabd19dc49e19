#include "beadmesh/panel/chain.h"

#include <algorithm>

namespace beadmesh {
namespace {

/// Where an edge ended up: chain, position in it, and whether the chain runs against the edge.
struct Place {
  Index chain = no_index;
  Index position = 0;
  bool reversed = false;
};

class ChainBuilder {
 public:
  ChainBuilder(const Panel& panel, double corner_angle) : panel_(panel), corner_angle_(corner_angle) {
    collect_sides();
    collect_edge_ends();
  }

  ChainSet build() {
    places_.resize(panel_.edges.size());
    for (Index e = 0; e < static_cast<Index>(panel_.edges.size()); ++e)
      if (places_[e].chain == no_index && uses_[e] > 0) build_chain(e);
    build_loops();
    return std::move(set_);
  }

 private:
  void collect_sides() {
    sides_.assign(panel_.edges.size(), {no_index, no_index});
    uses_.assign(panel_.edges.size(), 0);
    for (Index f = 0; f < static_cast<Index>(panel_.faces.size()); ++f)
      for (const std::vector<EdgeUse>& loop : panel_.faces[f].loops)
        for (const EdgeUse use : loop) {
          Index& natural = sides_[use.edge][use.reversed ? 1 : 0];
          (natural == no_index ? natural : sides_[use.edge][use.reversed ? 0 : 1]) = f;
          ++uses_[use.edge];
        }
  }

  void collect_edge_ends() {
    ends_.resize(panel_.points.size());
    for (Index e = 0; e < static_cast<Index>(panel_.edges.size()); ++e) {
      if (uses_[e] == 0) continue;
      ends_[panel_.edges[e].points.front()].push_back({e, false});
      ends_[panel_.edges[e].points.back()].push_back({e, true});
    }
  }

  Index head(EdgeUse use) const {
    const std::vector<Index>& points = panel_.edges[use.edge].points;
    return use.reversed ? points.front() : points.back();
  }

  std::array<Index, 2> sides(EdgeUse use) const {
    const std::array<Index, 2> s = sides_[use.edge];
    return use.reversed ? std::array<Index, 2>{s[1], s[0]} : s;
  }

  /// The segment that leaves the tail of `use`.
  Vec3 direction_at_tail(EdgeUse use) const {
    const std::vector<Index>& p = panel_.edges[use.edge].points;
    return use.reversed ? panel_.points[p[p.size() - 2]] - panel_.points[p.back()]
                        : panel_.points[p[1]] - panel_.points[p.front()];
  }

  /// The edge that goes on smoothly where `use` ends; edge = no_index at a corner.
  EdgeUse continuation(EdgeUse use) const {
    const std::vector<EdgeUse>& meeting = ends_[head(use)];
    if (meeting.size() != 2 || uses_[use.edge] > 2) return {};
    // An edge end listed as (edge, at its tail?) leaves the vertex as the use of the same spelling.
    const EdgeUse back{use.edge, !use.reversed};
    const bool first_is_back = meeting[0].edge == back.edge && meeting[0].reversed == back.reversed;
    const EdgeUse next = first_is_back ? meeting[1] : meeting[0];
    if (uses_[next.edge] > 2 || sides(next) != sides(use)) return {};
    const double turn = angle_between(-direction_at_tail(back), direction_at_tail(next));
    return turn < corner_angle_ ? next : EdgeUse{};
  }

  void build_chain(Index seed) {
    // The chain runs along the loop of its left face; only a free edge used backwards has no left face.
    const EdgeUse start{seed, sides_[seed][0] == no_index};
    Chain chain;
    chain.edges = {start};
    for (EdgeUse at = continuation(start); at.edge != no_index && at.edge != seed; at = continuation(at))
      chain.edges.push_back(at);
    const EdgeUse beyond = continuation(chain.edges.back());
    if (beyond.edge == no_index) prepend_backwards(chain, start);
    chain.faces = sides(start);
    fill_points(chain);
    const Index id = static_cast<Index>(set_.chains.size());
    for (Index i = 0; i < static_cast<Index>(chain.edges.size()); ++i)
      places_[chain.edges[i].edge] = {id, i, chain.edges[i].reversed};
    set_.chains.push_back(std::move(chain));
  }

  void prepend_backwards(Chain& chain, EdgeUse start) const {
    std::vector<EdgeUse> before;
    for (EdgeUse at = continuation({start.edge, !start.reversed}); at.edge != no_index; at = continuation(at))
      before.push_back({at.edge, !at.reversed});
    chain.edges.insert(chain.edges.begin(), before.rbegin(), before.rend());
  }

  void fill_points(Chain& chain) const {
    for (const EdgeUse use : chain.edges) {
      std::vector<Index> points = panel_.edges[use.edge].points;
      if (use.reversed) std::reverse(points.begin(), points.end());
      chain.points.insert(chain.points.end(), points.begin() + (chain.points.empty() ? 0 : 1), points.end());
    }
    chain.closed = chain.points.front() == chain.points.back();
    chain.arc_length.assign(1, 0.0);
    for (std::size_t i = 1; i < chain.points.size(); ++i)
      chain.arc_length.push_back(chain.arc_length.back() + distance(panel_.points[chain.points[i - 1]],
                                                                    panel_.points[chain.points[i]]));
  }

  bool starts_chain(EdgeUse use) const {
    const Place& place = places_[use.edge];
    const bool against = use.reversed != place.reversed;
    const Index last = static_cast<Index>(set_.chains[place.chain].edges.size()) - 1;
    return place.position == (against ? last : 0);
  }

  void build_loops() {
    set_.loops.resize(panel_.faces.size());
    for (std::size_t f = 0; f < panel_.faces.size(); ++f)
      for (const std::vector<EdgeUse>& loop : panel_.faces[f].loops) {
        std::vector<ChainUse> uses;
        for (const EdgeUse use : loop)
          if (starts_chain(use))
            uses.push_back({places_[use.edge].chain, use.reversed != places_[use.edge].reversed});
        set_.loops[f].push_back(std::move(uses));
      }
  }

  const Panel& panel_;
  double corner_angle_;
  std::vector<std::array<Index, 2>> sides_;  // per edge: left and right face
  std::vector<int> uses_;                    // per edge: how many loops run through it
  std::vector<std::vector<EdgeUse>> ends_;   // per point: the edges that end there, as the uses that leave it
  std::vector<Place> places_;                // per edge
  ChainSet set_;
};

}  // namespace

ChainSet chains_of(const Panel& panel, double corner_angle) {
  return ChainBuilder(panel, corner_angle).build();
}

ChainPosition position_at(const Chain& chain, double arc_length) {
  const double length = chain.length();
  if (chain.closed && length > 0) arc_length -= std::floor(arc_length / length) * length;
  arc_length = std::clamp(arc_length, 0.0, length);
  const auto above = std::upper_bound(chain.arc_length.begin(), chain.arc_length.end(), arc_length);
  const Index last = static_cast<Index>(chain.points.size()) - 2;
  const Index segment = std::clamp<Index>(static_cast<Index>(above - chain.arc_length.begin()) - 1, 0, last);
  const double span = chain.arc_length[segment + 1] - chain.arc_length[segment];
  const double fraction = span > 0 ? (arc_length - chain.arc_length[segment]) / span : 0;
  return {segment, std::clamp(fraction, 0.0, 1.0)};
}

Vec3 point_at(const Panel& panel, const Chain& chain, ChainPosition position) {
  const Vec3 a = panel.points[chain.points[position.segment]];
  const Vec3 b = panel.points[chain.points[position.segment + 1]];
  if (position.fraction <= 0) return a;
  if (position.fraction >= 1) return b;
  Index segment = position.segment;
  for (const EdgeUse use : chain.edges) {
    const PanelEdge& edge = panel.edges[use.edge];
    const Index segments = static_cast<Index>(edge.points.size()) - 1;
    if (segment >= segments) {
      segment -= segments;
      continue;
    }
    if (!edge.curve) break;
    const Index i = use.reversed ? segments - segment : segment;
    const Index j = use.reversed ? i - 1 : i + 1;
    return edge.curve->point(std::lerp(edge.parameters[i], edge.parameters[j], position.fraction));
  }
  return lerp(a, b, position.fraction);
}

}  // namespace beadmesh
