#include "beadmesh/mesh/sliding_lines.h"

#include <algorithm>

namespace beadmesh {

SlidingLine line_through(const std::vector<Index>& nodes, const std::vector<Vec2>& positions) {
  const bool closed = nodes.size() > 2 && nodes.front() == nodes.back();
  std::vector<Vec2> points;
  for (size_t i = 0; i + (closed ? 1 : 0) < nodes.size(); ++i) points.push_back(positions[nodes[i]]);
  SlidingLine line{Polyline<Vec2>(points, closed), nodes, {}};
  if (closed) line.nodes.pop_back();
  for (Index i = 0; i < Index(line.nodes.size()); ++i) line.at.push_back(line.curve.position(i));
  return line;
}

SlidingLines::SlidingLines(std::vector<SlidingLine> lines, const std::vector<NodeFreedom>& freedom)
    : lines_(std::move(lines)), places_(freedom.size()), crest_(freedom.size(), false) {
  std::vector<int> visits(freedom.size(), 0);
  for (const SlidingLine& line : lines_)
    for (const Index node : line.nodes) {
      ++visits[node];
      if (line.is_crest) crest_[node] = true;
    }
  for (Index l = 0; l < Index(lines_.size()); ++l) {
    const std::vector<Index>& nodes = lines_[l].nodes;
    const Index end = lines_[l].curve.is_closed() ? 0 : 1;
    for (Index i = end; i + end < Index(nodes.size()); ++i)
      if (visits[nodes[i]] == 1 && freedom[nodes[i]] == NodeFreedom::sliding && nodes.size() > 2)
        places_[nodes[i]] = {l, i};
  }
}

/// Between the neighbours on the line; round a closed line the numbers run on over its start.
SlidingLines::Range SlidingLines::room(Index node) const {
  const auto [l, i] = places_[node];
  const SlidingLine& line = lines_[l];
  const Index last = Index(line.nodes.size()) - 1;
  const double length = line.curve.length();
  return {i > 0 ? line.at[i - 1] : line.at[last] - length, i < last ? line.at[i + 1] : line.at[0] + length};
}

double SlidingLines::clamped(Index node, double shift) const {
  const Range free = room(node);
  const double margin = 0.05 * (free.high - free.low);
  return std::clamp(position(node) + shift, free.low + margin, free.high - margin);
}

double SlidingLines::shift_to_middle(Index node) const {
  const Range free = room(node);
  return (free.low + free.high) / 2 - position(node);
}

void SlidingLines::slide(Index node, double shift) {
  const double moved = clamped(node, shift);
  lines_[places_[node].line].at[places_[node].position] = moved;
}

bool SlidingLines::next_to_tip(Index node) const {
  if (!slides(node)) return false;
  const auto [l, position] = places_[node];
  const SlidingLine& line = lines_[l];
  return line.is_crest && !line.curve.is_closed() &&
         (position == 1 || position + 2 == Index(line.nodes.size()));
}

Vec2 SlidingLines::shifted(Index node, double shift) const {
  return lines_[places_[node].line].curve.point_at(clamped(node, shift));
}

double SlidingLines::position(Index node) const {
  return lines_[places_[node].line].at[places_[node].position];
}

}  // namespace beadmesh
