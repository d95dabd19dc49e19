#include "beadmesh/mesh/chain_nodes.h"

#include <algorithm>
#include <cmath>

namespace beadmesh {
namespace {

std::vector<double> loop_offsets(const PlanarLoop& loop) {
  std::vector<double> offsets{0};
  for (size_t i = 0; i < loop.points.size(); ++i)
    offsets.push_back(offsets.back() + distance(loop.points[i], loop.points[(i + 1) % loop.points.size()]));
  return offsets;
}

}  // namespace

ChainNodes::ChainNodes(const Panel& panel, const ChainSet& chains)
    : panel_(panel),
      chains_(chains),
      nodes_(chains.chains.size()),
      vertex_nodes_(panel.points.size(), no_index) {
  segments_.resize(panel.faces.size());
  for (Index f = 0; f < Index(panel.faces.size()); ++f) {
    segments_[f].resize(panel.faces[f].facets.loops.size());
    for (Index l = 0; l < Index(segments_[f].size()); ++l) match_loop(f, l);
  }
}

/// The chains of a loop may begin at another point than its polyline does: both run the same way, so one
/// shift fits.
void ChainNodes::match_loop(Index face, Index loop) {
  std::vector<LoopSegment> walk;
  std::vector<std::pair<Index, Index>> ends;
  if (loop >= Index(chains_.loops[face].size())) return;
  for (const ChainUse& use : chains_.loops[face][loop]) {
    const auto& points = chains_.chains[use.chain].points;
    const Index n = Index(points.size()) - 1;
    for (Index k = 0; k < n; ++k) {
      const Index s = use.reversed ? n - 1 - k : k;
      walk.push_back({use.chain, s, use.reversed});
      ends.emplace_back(points[use.reversed ? s + 1 : s], points[use.reversed ? s : s + 1]);
    }
  }
  const Facets& facets = panel_.faces[face].facets;
  const auto& local = facets.loops[loop];
  const size_t n = local.size();
  if (walk.size() != n) return;
  const auto panel_point = [&](size_t i) { return facets.panel_points[local[i % n]]; };
  for (size_t shift = 0; shift < n; ++shift) {
    bool fits = true;
    for (size_t i = 0; fits && i < n; ++i)
      fits = panel_point(i + shift) == ends[i].first && panel_point(i + shift + 1) == ends[i].second;
    if (!fits) continue;
    auto& out = segments_[face][loop];
    out.resize(n);
    for (size_t i = 0; i < n; ++i) out[(i + shift) % n] = walk[i];
    return;
  }
}

Index ChainNodes::vertex_node(Index panel_point) {
  Index& node = vertex_nodes_[panel_point];
  if (node == no_index) {
    node = Index(points_.size());
    points_.push_back(panel_.points[panel_point]);
  }
  return node;
}

Index ChainNodes::add_node(Index chain, double arc_length) {
  points_.push_back(point_at(panel_, chains_.chains[chain], position_at(chains_.chains[chain], arc_length)));
  return Index(points_.size()) - 1;
}

void ChainNodes::place_evenly(Index c, int count) {
  std::vector<double> arc_lengths;
  for (int i = 0; i <= count; ++i) arc_lengths.push_back(chains_.chains[c].length() * i / count);
  place_at(c, arc_lengths);
}

void ChainNodes::place_at(Index c, const std::vector<double>& arc_lengths) {
  const Chain& chain = chains_.chains[c];
  auto& nodes = nodes_[c];
  nodes.clear();
  if (!chain.closed) nodes.push_back({0, vertex_node(chain.points.front())});
  for (size_t i = chain.closed ? 0 : 1; i + 1 < arc_lengths.size(); ++i)
    nodes.push_back({arc_lengths[i], add_node(c, arc_lengths[i])});
  if (!chain.closed) nodes.push_back({chain.length(), vertex_node(chain.points.back())});
}

std::vector<Index> ChainNodes::place_from_face(Index face, const PlanarRegion& region,
                                               const std::vector<BoundaryPosition>& positions) {
  std::vector<Index> ids;
  std::vector<std::vector<double>> offsets;
  for (const PlanarLoop& loop : region.loops) offsets.push_back(loop_offsets(loop));
  std::vector<bool> touched(chains_.chains.size(), false);
  for (const BoundaryPosition& at : positions) {
    const auto& of_loop = offsets[at.loop];
    double position = std::fmod(at.position, of_loop.back());
    if (position < 0) position += of_loop.back();
    const size_t next = std::upper_bound(of_loop.begin(), of_loop.end(), position) - of_loop.begin();
    const size_t i = std::min(next, of_loop.size() - 1) - 1;
    const LoopSegment& segment = segments_[face][at.loop][i];
    const Chain& chain = chains_.chains[segment.chain];
    double t = (position - of_loop[i]) / std::max(of_loop[i + 1] - of_loop[i], 1e-300);
    if (segment.reversed) t = 1 - t;
    double arc = chain.arc_length[segment.segment] +
                 t * (chain.arc_length[segment.segment + 1] - chain.arc_length[segment.segment]);
    if (chain.closed && arc >= chain.length()) arc = 0;
    ids.push_back(add_node(segment.chain, arc));
    nodes_[segment.chain].push_back({arc, ids.back()});
    touched[segment.chain] = true;
  }
  for (size_t c = 0; c < touched.size(); ++c)
    if (touched[c])
      std::sort(nodes_[c].begin(), nodes_[c].end(),
                [](const ChainNode& a, const ChainNode& b) { return a.arc_length < b.arc_length; });
  return ids;
}

int ChainNodes::count(Index chain) const {
  const int n = int(nodes_[chain].size());
  return chains_.chains[chain].closed ? n : n - 1;
}

std::vector<LoopNode> ChainNodes::nodes_of_loop(Index face, Index l, const PlanarRegion& region) const {
  std::vector<LoopNode> out;
  const auto& segments = segments_[face][l];
  const PlanarLoop& loop = region.loops[l];
  const auto offsets = loop_offsets(loop);
  for (size_t i = 0; i < segments.size(); ++i) {
    const Chain& chain = chains_.chains[segments[i].chain];
    if (nodes_[segments[i].chain].empty()) return {};
    const double low = chain.arc_length[segments[i].segment],
                 high = chain.arc_length[segments[i].segment + 1];
    std::vector<LoopNode> here;
    for (const ChainNode& node : nodes_[segments[i].chain]) {
      // Every segment owns its first point in the loop's direction, so that no node is seen twice.
      const bool mine = segments[i].reversed ? node.arc_length > low && node.arc_length <= high
                                             : node.arc_length >= low && node.arc_length < high;
      if (!mine) continue;
      double t = (node.arc_length - low) / std::max(high - low, 1e-300);
      if (segments[i].reversed) t = 1 - t;
      here.push_back({node.id, lerp(loop.points[i], loop.points[(i + 1) % loop.points.size()], t),
                      offsets[i] + t * (offsets[i + 1] - offsets[i])});
    }
    // A closed chain walked backward starts at its end, which carries its node 0.
    const bool wraps =
        segments[i].reversed && chain.closed && segments[i].segment + 2 == Index(chain.points.size());
    if (wraps && nodes_[segments[i].chain].front().arc_length == 0)
      here.push_back({nodes_[segments[i].chain].front().id, loop.points[i], offsets[i]});
    std::sort(here.begin(), here.end(),
              [](const LoopNode& a, const LoopNode& b) { return a.position < b.position; });
    out.insert(out.end(), here.begin(), here.end());
  }
  return out;
}

}  // namespace beadmesh
