#include "beadmesh/mesh/crest_lines.h"

#include <algorithm>

namespace beadmesh {

CrestLines::CrestLines(const std::vector<std::vector<Index>>& lines, const std::vector<Vec2>& positions,
                       const std::vector<NodeFreedom>& freedom) {
  places_.resize(positions.size());
  std::vector<int> visits(positions.size(), 0);
  for (const std::vector<Index>& nodes : lines)
    for (const Index node : nodes) ++visits[node];
  for (const std::vector<Index>& nodes : lines) {
    Line line{nodes, {}, {}};
    double arc = 0;
    for (size_t i = 0; i < nodes.size(); ++i) {
      line.points.push_back(positions[nodes[i]]);
      if (i > 0) arc += distance(line.points[i - 1], line.points[i]);
      line.arc.push_back(arc);
    }
    for (size_t i = 1; i + 1 < nodes.size(); ++i)
      if (visits[nodes[i]] == 1 && freedom[nodes[i]] == NodeFreedom::crest)
        places_[nodes[i]] = {static_cast<Index>(lines_.size()), static_cast<Index>(i), line.arc[i]};
    lines_.push_back(std::move(line));
  }
}

double CrestLines::arc_of(const Line& line, Index position) const {
  const Index node = line.nodes[position];
  return slides(node) ? places_[node].arc : line.arc[position];
}

double CrestLines::clamped(Index node, double shift) const {
  const Place& place = places_[node];
  const Line& line = lines_[place.line];
  const double low = arc_of(line, place.position - 1), high = arc_of(line, place.position + 1);
  const double margin = 0.05 * (high - low);
  return std::clamp(place.arc + shift, low + margin, high - margin);
}

double CrestLines::shift_to_middle(Index node) const {
  const Place& place = places_[node];
  const Line& line = lines_[place.line];
  return (arc_of(line, place.position - 1) + arc_of(line, place.position + 1)) / 2 - place.arc;
}

Vec2 CrestLines::shifted(Index node, double shift) const {
  const Line& line = lines_[places_[node].line];
  const double arc = clamped(node, shift);
  size_t i = static_cast<size_t>(std::upper_bound(line.arc.begin(), line.arc.end(), arc) - line.arc.begin());
  i = std::clamp<size_t>(i, 1, line.arc.size() - 1);
  const double length = line.arc[i] - line.arc[i - 1];
  return lerp(line.points[i - 1], line.points[i], length > 0 ? (arc - line.arc[i - 1]) / length : 0.0);
}

}  // namespace beadmesh
